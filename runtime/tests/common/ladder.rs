//! A ladder of mass m and length l, its foot A on a smooth floor, its head B at a smooth wall; θ from the floor,
//! (x, y) its centre. Multipliers only.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct Ladder {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

static LAYOUT: Layout = Layout {
    name: "Ladder",
    declaration: "",
    parameters: &["m", "l", "g"],
    coordinates: &[
        Coordinate { name: "x", is_angle: false },
        Coordinate { name: "y", is_angle: false },
        Coordinate { name: "theta", is_angle: true },
    ],
    contacts: &[
        Contact { label: "A", supports: &["A"], shared: true, foot: None },
        Contact { label: "B", supports: &["B"], shared: true, foot: None },
    ],
    joints: &[],
    points: &["A", "B"],
    bars: &[Bar { name: "AB", from: 0, to: 1 }],
    closed_forms: &[],
};

impl BarSystem for Ladder {
    const LAYOUT: &'static Layout = &LAYOUT;
    type Constants<S: Real> = [S; 3];
    type State<S: Real> = [S; 6];
    type Reactions<S: Real> = [S; 2];
    type Kernel<S: Real> = Kernel<S, 3, 2, 5>;
    type Points<S: Real> = [S; 4];
    type Feet<S: Real> = [S; 0];

    fn parameters(&self) -> Vec<f64> {
        vec![self.m, self.l, self.g]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], l: values[1], g: values[2] }
    }

    fn measures(&self) -> Vec<Measure> {
        vec![
            Measure { of: "bar AB", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar AB", kind: MeasureKind::Length, value: self.l },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> Vec<Scenery> {
        Vec::new()
    }

    /// θ = 60°.
    fn nominal(&self) -> Vec<f64> {
        vec![0.25 * self.l, 0.75f64.sqrt() * 0.5 * self.l, core::f64::consts::FRAC_PI_3]
    }

    fn constants<S: Real>(&self) -> [S; 3] {
        [self.m, self.l, self.g].map(S::from_f64)
    }

    fn kernel<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 6]) -> Kernel<S, 3, 2, 5> {
        let [x, y, theta, _, _, u] = *state;
        let (s, c) = theta.sin_cos();
        let (zero, one, half) = (S::ratio(0, 1), S::ratio(1, 1), S::ratio(1, 2) * l);
        Kernel {
            mass: [[m, zero, zero], [zero, m, zero], [zero, zero, S::ratio(1, 12) * m * l * l]],
            force: [zero, -(m * g), zero],
            gap: [y - half * s, x - half * c],
            jacobian: [[zero, one, -(half * c)], [one, zero, half * s]],
            bias: [half * s * u * u, half * c * u * u],
        }
    }

    fn energy<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 6]) -> Energy<S> {
        let [_, y, _, vx, vy, u] = *state;
        let speed = vx * vx + vy * vy + S::ratio(1, 12) * l * l * u * u;
        Energy { kinetic: S::ratio(1, 2) * m * speed, potential: m * g * y }
    }

    fn points<S: Real>(&[_, l, _]: &[S; 3], state: &[S; 6]) -> [S; 4] {
        let (s, c) = state[2].sin_cos();
        let half = S::ratio(1, 2) * l;
        [state[0] + half * c, state[1] - half * s, state[0] - half * c, state[1] + half * s]
    }

    fn feet<S: Real>(_: &[S; 3], _: &[S; 6]) -> [S; 0] {
        []
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), 2, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), 2, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
