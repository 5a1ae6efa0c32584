//! A point mass on a thread of length l from the origin: gap l − |r|.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct Bob {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

static LAYOUT: Layout = Layout {
    name: "Bob",
    declaration: "",
    summary: "",
    parameters: &["m", "l", "g"],
    coordinates: &[Coordinate { name: "x", is_angle: false }, Coordinate { name: "y", is_angle: false }],
    contacts: &[Contact {
        label: "rope",
        supports: &["rope"],
        shared: true,
        foot: None,
        kind: ContactKind::Thread,
        rough: false,
        law: Law::Newton,
        stop: false,
    }],
    joints: &[],
    tangents: &[],
    timed: false,
    quantities: &[],
    points: &["P"],
    bars: &[],
    closed_forms: &[],
};

impl BarSystem for Bob {
    const LAYOUT: &'static Layout = &LAYOUT;
    /// m, l, g.
    type Constants<S: Real> = [S; 3];
    type State<S: Real> = [S; 4];
    type Reactions<S: Real> = [S; 1];
    type Accelerations<S: Real> = [S; 2];
    type Multipliers<S: Real> = [S; 1];
    type Kernel<S: Real> = Kernel<S, 2, 1, 3>;
    type Points<S: Real> = [S; 2];
    type Feet<S: Real> = [S; 0];

    type Parameters = [f64; 3];
    type Measures = [Measure; 3];
    type Scenery = [Scenery; 0];

    fn parameters(&self) -> [f64; 3] {
        [self.m, self.l, self.g]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], l: values[1], g: values[2] }
    }

    fn measures(&self) -> [Measure; 3] {
        [
            Measure { of: "P", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "rope", kind: MeasureKind::Length, value: self.l },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> [Scenery; 0] {
        []
    }

    fn nominal(&self) -> [f64; 2] {
        [0.0, -self.l]
    }

    fn constants<S: Real>(&self) -> [S; 3] {
        [self.m, self.l, self.g].map(S::from_f64)
    }

    fn kernel<S: Real>(&[m, l, g]: &[S; 3], &[x, y, u, v]: &[S; 4]) -> Kernel<S, 2, 1, 3> {
        let zero = S::ratio(0, 1);
        let r = (x * x + y * y).sqrt();
        let across = (x * v - y * u) / r;
        Kernel {
            mass: [[m, zero], [zero, m]],
            force: [zero, -(m * g)],
            gap: [l - r],
            jacobian: [[-(x / r), -(y / r)]],
            // d²|r|/dt² = (v² − ṙ²)/r without acceleration, and v² − ṙ² is the square of the speed across.
            bias: [-(across * across / r)],
            drift: [zero],
        }
    }

    fn energy<S: Real>(&[m, _, g]: &[S; 3], &[_, y, u, v]: &[S; 4]) -> Energy<S> {
        Energy { kinetic: S::ratio(1, 2) * m * (u * u + v * v), potential: m * g * y }
    }

    fn points<S: Real>(_: &[S; 3], &[x, y, ..]: &[S; 4]) -> [S; 2] {
        [x, y]
    }

    fn feet<S: Real>(_: &[S; 3], _: &[S; 4]) -> [S; 0] {
        []
    }

    fn quantity<S: Real>(_: &[S; 3], _: usize, _: &[S; 4], _: &[S; 2], _: &[S; 1]) -> S {
        S::from_f64(f64::NAN)
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            coordinates: 2,
            rates: 2,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), &LAYOUT, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), &LAYOUT, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
