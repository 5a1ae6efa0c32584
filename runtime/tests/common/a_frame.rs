//! Two bars of mass m and length l hinged at the apex D, feet A, B on a smooth floor, mirrored: φ to the floor, h the
//! height of D. Multipliers only.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct AFrame {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

static LAYOUT: Layout = Layout {
    name: "AFrame",
    declaration: "",
    parameters: &["m", "l", "g"],
    coordinates: &[Coordinate { name: "phi", is_angle: true }, Coordinate { name: "h", is_angle: false }],
    contacts: &[Contact { label: "A, B", supports: &["A", "B"], shared: true, foot: None }],
    joints: &[],
    points: &["D", "B"],
    bars: &[Bar { name: "DB", from: 0, to: 1 }],
    closed_forms: &[],
};

impl BarSystem for AFrame {
    const LAYOUT: &'static Layout = &LAYOUT;
    type Constants<S: Real> = [S; 3];
    type State<S: Real> = [S; 4];
    type Reactions<S: Real> = [S; 1];
    type Kernel<S: Real> = Kernel<S, 2, 1, 3>;
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
            Measure { of: "bar AD", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar DB", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar DB", kind: MeasureKind::Length, value: self.l },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> Vec<Scenery> {
        Vec::new()
    }

    /// φ = 60°.
    fn nominal(&self) -> Vec<f64> {
        vec![core::f64::consts::FRAC_PI_3, 0.75f64.sqrt() * self.l]
    }

    fn constants<S: Real>(&self) -> [S; 3] {
        [self.m, self.l, self.g].map(S::from_f64)
    }

    fn kernel<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 4]) -> Kernel<S, 2, 1, 3> {
        let [phi, h, u, _] = *state;
        let (s, c) = phi.sin_cos();
        let two = S::ratio(2, 1);
        let couple = -(m * l * c);
        Kernel {
            mass: [[S::ratio(2, 3) * m * l * l, couple], [couple, two * m]],
            force: [m * g * l * c, -(two * m * g) - m * l * s * u * u],
            gap: [h - l * s],
            jacobian: [[-(l * c), S::ratio(1, 1)]],
            bias: [l * s * u * u],
        }
    }

    fn energy<S: Real>(&[m, l, g]: &[S; 3], state: &[S; 4]) -> Energy<S> {
        let [phi, h, u, v] = *state;
        let (s, c) = phi.sin_cos();
        Energy {
            kinetic: m * (v * v - v * l * u * c + S::ratio(1, 3) * l * l * u * u),
            potential: m * g * (S::ratio(2, 1) * h - l * s),
        }
    }

    fn points<S: Real>(&[_, l, _]: &[S; 3], state: &[S; 4]) -> [S; 4] {
        let (s, c) = state[0].sin_cos();
        [S::ratio(0, 1), state[1], l * c, state[1] - l * s]
    }

    fn feet<S: Real>(_: &[S; 3], _: &[S; 4]) -> [S; 0] {
        []
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, _: Form, visitor: V) -> V::Output {
        visitor.visit(Phase {
            set,
            form: Form::Projected,
            derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), 1, set, state),
            reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), 1, set),
            embed: |_, state| *state,
            restrict: |state| *state,
            pivot: |_, _| S::ratio(1, 1),
            energy: Self::energy,
        })
    }
}
