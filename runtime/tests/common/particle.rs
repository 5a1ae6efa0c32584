//! A point mass above a floor: ÿ = −g, restitution e at the floor.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct Particle {
    pub m: f64,
    pub g: f64,
    pub e: f64,
}

static LAYOUT: Layout = Layout {
    name: "Particle",
    declaration: "",
    summary: "",
    parameters: &["m", "g", "e"],
    coordinates: &[Coordinate { name: "y", is_angle: false }],
    contacts: &[Contact {
        label: "P",
        supports: &["P"],
        shared: true,
        foot: None,
        kind: ContactKind::Support,
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

impl BarSystem for Particle {
    const LAYOUT: &'static Layout = &LAYOUT;
    /// m, g.
    type Constants<S: Real> = [S; 2];
    type State<S: Real> = [S; 2];
    type Reactions<S: Real> = [S; 1];
    type Accelerations<S: Real> = [S; 1];
    type Multipliers<S: Real> = [S; 1];
    type Kernel<S: Real> = Kernel<S, 1, 1, 2>;
    type Points<S: Real> = [S; 2];
    type Feet<S: Real> = [S; 0];

    type Parameters = [f64; 3];
    type Measures = [Measure; 2];
    type Scenery = [Scenery; 0];

    fn parameters(&self) -> [f64; 3] {
        [self.m, self.g, self.e]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], g: values[1], e: values[2] }
    }

    fn measures(&self) -> [Measure; 2] {
        [
            Measure { of: "P", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn restitution(&self) -> [f64; 1] {
        [self.e]
    }

    fn scenery(&self) -> [Scenery; 0] {
        []
    }

    fn nominal(&self) -> [f64; 1] {
        [1.0]
    }

    fn constants<S: Real>(&self) -> [S; 2] {
        [S::from_f64(self.m), S::from_f64(self.g)]
    }

    fn kernel<S: Real>(&[m, g]: &[S; 2], &[y, _]: &[S; 2]) -> Kernel<S, 1, 1, 2> {
        let (zero, one) = (S::ratio(0, 1), S::ratio(1, 1));
        Kernel { mass: [[m]], force: [-(m * g)], gap: [y], jacobian: [[one]], bias: [zero], drift: [zero] }
    }

    fn energy<S: Real>(&[m, g]: &[S; 2], &[y, v]: &[S; 2]) -> Energy<S> {
        Energy { kinetic: S::ratio(1, 2) * m * v * v, potential: m * g * y }
    }

    fn points<S: Real>(_: &[S; 2], &[y, _]: &[S; 2]) -> [S; 2] {
        [S::ratio(0, 1), y]
    }

    fn feet<S: Real>(_: &[S; 2], _: &[S; 2]) -> [S; 0] {
        []
    }

    fn quantity<S: Real>(_: &[S; 2], _: usize, _: &[S; 2], _: &[S; 1], _: &[S; 1]) -> S {
        S::from_f64(f64::NAN)
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            coordinates: 1,
            rates: 1,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), &LAYOUT, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), &LAYOUT, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
