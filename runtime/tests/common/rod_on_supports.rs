//! A level rod of mass m and length l with three one-sided supports under it: A and C at the ends, B under its centre.
//! y the height of the centre, θ the tilt, small by assumption: gaps are y + s θ with s = −l/2, 0, l/2.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct RodOnSupports {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

static LAYOUT: Layout = Layout {
    name: "RodOnSupports",
    declaration: "",
    parameters: &["m", "l", "g"],
    coordinates: &[Coordinate { name: "y", is_angle: false }, Coordinate { name: "theta", is_angle: true }],
    contacts: &[
        Contact { label: "A", supports: &["A"], shared: true, foot: None },
        Contact { label: "B", supports: &["B"], shared: true, foot: None },
        Contact { label: "C", supports: &["C"], shared: true, foot: None },
    ],
    joints: &[],
    points: &[],
    bars: &[],
    closed_forms: &[],
};

impl BarSystem for RodOnSupports {
    const LAYOUT: &'static Layout = &LAYOUT;
    type Constants<S: Real> = [S; 3];
    type State<S: Real> = [S; 4];
    type Reactions<S: Real> = [S; 3];
    type Kernel<S: Real> = Kernel<S, 2, 3, 5>;
    type Points<S: Real> = [S; 0];
    type Feet<S: Real> = [S; 0];

    fn parameters(&self) -> Vec<f64> {
        vec![self.m, self.l, self.g]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], l: values[1], g: values[2] }
    }

    fn measures(&self) -> Vec<Measure> {
        vec![
            Measure { of: "bar AC", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar AC", kind: MeasureKind::Length, value: self.l },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> Vec<Scenery> {
        Vec::new()
    }

    fn nominal(&self) -> Vec<f64> {
        vec![0.0, 0.0]
    }

    fn constants<S: Real>(&self) -> [S; 3] {
        [self.m, self.l, self.g].map(S::from_f64)
    }

    fn kernel<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 4]) -> Kernel<S, 2, 3, 5> {
        let (zero, one, half) = (S::ratio(0, 1), S::ratio(1, 1), S::ratio(1, 2) * l);
        Kernel {
            mass: [[m, zero], [zero, S::ratio(1, 12) * m * l * l]],
            force: [-(m * g), zero],
            gap: [state[0] - half * state[1], state[0], state[0] + half * state[1]],
            jacobian: [[one, -half], [one, zero], [one, half]],
            bias: [zero; 3],
        }
    }

    fn energy<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 4]) -> Energy<S> {
        let speed = state[2] * state[2] + S::ratio(1, 12) * l * l * state[3] * state[3];
        Energy { kinetic: S::ratio(1, 2) * m * speed, potential: m * g * state[0] }
    }

    fn points<S: Real>(_: &[S; 3], _: &[S; 4]) -> [S; 0] {
        []
    }

    fn feet<S: Real>(_: &[S; 3], _: &[S; 4]) -> [S; 0] {
        []
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), 3, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), 3, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
