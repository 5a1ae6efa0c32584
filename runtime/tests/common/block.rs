//! A rigid block, 2b wide and 2h high, on its two rough lower corners A and B; (x, y) its centre, θ its tilt.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct Block {
    pub m: f64,
    pub b: f64,
    pub h: f64,
    pub g: f64,
}

const fn corner(label: &'static str, supports: &'static [&'static str]) -> Contact {
    let (kind, law) = (ContactKind::Support, Law::Newton);
    Contact { label, supports, shared: true, foot: None, kind, rough: true, law, stop: false }
}

static LAYOUT: Layout = Layout {
    name: "Block",
    declaration: "",
    summary: "",
    parameters: &["m", "b", "h", "g"],
    coordinates: &[
        Coordinate { name: "x", is_angle: false },
        Coordinate { name: "y", is_angle: false },
        Coordinate { name: "theta", is_angle: true },
    ],
    contacts: &[corner("A", &["A"]), corner("B", &["B"])],
    joints: &[],
    tangents: &[0, 1],
    timed: false,
    quantities: &[],
    points: &["A", "B"],
    bars: &[],
    closed_forms: &[],
};

impl BarSystem for Block {
    const LAYOUT: &'static Layout = &LAYOUT;
    /// m, b, h, g.
    type Constants<S: Real> = [S; 4];
    type State<S: Real> = [S; 6];
    type Reactions<S: Real> = [S; 2];
    type Accelerations<S: Real> = [S; 3];
    type Multipliers<S: Real> = [S; 4];
    type Kernel<S: Real> = Kernel<S, 3, 4, 7>;
    type Points<S: Real> = [S; 4];
    type Feet<S: Real> = [S; 0];

    type Parameters = [f64; 4];
    type Measures = [Measure; 3];
    type Scenery = [Scenery; 0];

    fn parameters(&self) -> [f64; 4] {
        [self.m, self.b, self.h, self.g]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], b: values[1], h: values[2], g: values[3] }
    }

    fn measures(&self) -> [Measure; 3] {
        [
            Measure { of: "block", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "block", kind: MeasureKind::Length, value: 2.0 * self.h },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> [Scenery; 0] {
        []
    }

    fn nominal(&self) -> [f64; 3] {
        [0.0, self.h, 0.0]
    }

    fn constants<S: Real>(&self) -> [S; 4] {
        [self.m, self.b, self.h, self.g].map(S::from_f64)
    }

    fn kernel<S: Real>(&[m, b, h, g]: &[S; 4], &[_, y, theta, _, _, w]: &[S; 6]) -> Kernel<S, 3, 4, 7> {
        let (zero, one) = (S::ratio(0, 1), S::ratio(1, 1));
        let (s, c) = theta.sin_cos();
        let inertia = m * (b * b + h * h) * S::ratio(1, 3);
        // The corners from the centre.
        let [left, right] = [-b, b].map(|a| [c * a + s * h, s * a - c * h]);
        Kernel {
            mass: [[m, zero, zero], [zero, m, zero], [zero, zero, inertia]],
            force: [zero, -(m * g), zero],
            gap: [y + left[1], y + right[1], zero, zero],
            jacobian: [
                [zero, one, left[0]],
                [zero, one, right[0]],
                [one, zero, -left[1]],
                [one, zero, -right[1]],
            ],
            bias: [left[1], right[1], left[0], right[0]].map(|r| -(r * w * w)),
            drift: [zero; 4],
        }
    }

    fn energy<S: Real>(&[m, b, h, g]: &[S; 4], &[_, y, _, u, v, w]: &[S; 6]) -> Energy<S> {
        let spin = (b * b + h * h) * S::ratio(1, 3) * w * w;
        Energy { kinetic: S::ratio(1, 2) * m * (u * u + v * v + spin), potential: m * g * y }
    }

    fn points<S: Real>(&[_, b, h, _]: &[S; 4], &[x, y, theta, ..]: &[S; 6]) -> [S; 4] {
        let (s, c) = theta.sin_cos();
        [x - c * b + s * h, y - s * b - c * h, x + c * b + s * h, y + s * b - c * h]
    }

    fn feet<S: Real>(_: &[S; 4], _: &[S; 6]) -> [S; 0] {
        []
    }

    fn quantity<S: Real>(_: &[S; 4], _: usize, _: &[S; 6], _: &[S; 3], _: &[S; 4]) -> S {
        S::from_f64(f64::NAN)
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            coordinates: 3,
            rates: 3,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), &LAYOUT, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), &LAYOUT, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
