//! Fig. 1a mirrored: two equal bars hinged at D on the corners P, Q; φ their angle to the horizontal, y the height of D.
//!
//! On the corners y = −(l/2) tan φ (y upward); closed form and multipliers.

use liftoff::kernel;
use liftoff::model::*;
use liftoff::scalar::{Real, Scalar};

#[derive(Clone, Debug)]
pub struct FallingPair {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}

#[derive(Clone)]
pub struct Constants<S> {
    m: S,
    l: S,
    g: S,
}

static LAYOUT: Layout = Layout {
    name: "FallingPair",
    declaration: "",
    summary: "",
    parameters: &["m", "l", "g"],
    coordinates: &[Coordinate { name: "phi", is_angle: true }, Coordinate { name: "y", is_angle: false }],
    contacts: &[Contact {
        label: "P, Q",
        supports: &["P", "Q"],
        shared: true,
        foot: Some(0),
        kind: ContactKind::Support,
        rough: false,
        law: Law::Newton,
        stop: false,
    }],
    joints: &[],
    tangents: &[],
    timed: false,
    quantities: &[],
    points: &["D", "A", "B"],
    bars: &[Bar { name: "AD", from: 1, to: 0 }, Bar { name: "DB", from: 0, to: 2 }],
    closed_forms: &[ContactSet(1)],
};

fn n<S: Real>(p: i64, q: i64) -> S {
    S::ratio(p, q)
}

/// (sin φ, cos φ, 1 − cos φ).
fn angle<S: Real>(phi: S) -> (S, S, S) {
    let (s, c) = phi.sin_cos();
    let (half, _) = (phi * n(1, 2)).sin_cos();
    (s, c, n::<S>(2, 1) * half * half)
}

mod on_corners {
    use super::*;

    pub fn derivative<S: Scalar>(k: &Constants<S>, _: ContactSet, r: &[S; 2]) -> [S; 2] {
        let (s, c, vers) = angle(r[0]);
        let sec = n::<S>(1, 1) / c;
        let (tan, sec2) = (s * sec, sec * sec);
        let mass = k.m * k.l * k.l * n(1, 2) * (n::<S>(4, 3) + sec2 * sec2 - n::<S>(2, 1) * sec);
        let change =
            k.m * k.l * k.l * n(1, 2) * (n::<S>(4, 1) * sec2 * sec2 * tan - n::<S>(2, 1) * sec * tan);
        let force = k.m * k.g * k.l * vers * (n::<S>(1, 1) + c + c * c) * sec2;
        [r[1], (force - n::<S>(1, 2) * change * r[1] * r[1]) / mass]
    }

    pub fn reactions<S: Scalar>(k: &Constants<S>, set: ContactSet, r: &[S; 2]) -> [S; 1] {
        let (s, c, _) = angle(r[0]);
        let sec = n::<S>(1, 1) / c;
        let [u, a] = derivative(k, set, r);
        let rise = (c - sec * sec) * a - (s + n::<S>(2, 1) * sec * sec * s * sec) * u * u;
        [n::<S>(2, 1) * k.m * (k.g + n::<S>(1, 2) * k.l * rise) * sec]
    }

    pub fn embed<S: Scalar>(k: &Constants<S>, r: &[S; 2]) -> [S; 4] {
        let (s, c, _) = angle(r[0]);
        let half = n::<S>(1, 2) * k.l;
        [r[0], -(half * s / c), r[1], -(half * r[1] / (c * c))]
    }

    pub fn energy<S: Scalar>(k: &Constants<S>, r: &[S; 2]) -> Energy<S> {
        let (s, c, vers) = angle(r[0]);
        let sec = n::<S>(1, 1) / c;
        let sec4 = sec * sec * sec * sec;
        let inertia = k.m * k.l * k.l * n(1, 4) * (n::<S>(4, 3) + sec4 - n::<S>(2, 1) * sec);
        Energy { kinetic: inertia * r[1] * r[1], potential: -(k.m * k.g * k.l * s * sec * vers) }
    }
}

impl BarSystem for FallingPair {
    const LAYOUT: &'static Layout = &LAYOUT;
    type Constants<S: Real> = Constants<S>;
    type State<S: Real> = [S; 4];
    type Reactions<S: Real> = [S; 1];
    type Accelerations<S: Real> = [S; 2];
    type Multipliers<S: Real> = [S; 1];
    type Kernel<S: Real> = Kernel<S, 2, 1, 3>;
    type Points<S: Real> = [S; 6];
    type Feet<S: Real> = [S; 2];

    type Parameters = [f64; 3];
    type Measures = [Measure; 4];
    type Scenery = [Scenery; 0];

    fn parameters(&self) -> [f64; 3] {
        [self.m, self.l, self.g]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { m: values[0], l: values[1], g: values[2] }
    }

    fn measures(&self) -> [Measure; 4] {
        [
            Measure { of: "bar AD", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar DB", kind: MeasureKind::Mass, value: self.m },
            Measure { of: "bar AD", kind: MeasureKind::Length, value: self.l },
            Measure { of: "gravity", kind: MeasureKind::Gravity, value: self.g },
        ]
    }

    fn scenery(&self) -> [Scenery; 0] {
        []
    }

    fn nominal(&self) -> [f64; 2] {
        [0.0, 0.0]
    }

    fn constants<S: Real>(&self) -> Constants<S> {
        Constants { m: S::from_f64(self.m), l: S::from_f64(self.l), g: S::from_f64(self.g) }
    }

    fn kernel<S: Real>(k: &Constants<S>, state: &[S; 4]) -> Kernel<S, 2, 1, 3> {
        let [phi, y, u, v] = *state;
        let (s, c, _) = angle(phi);
        let (ml, two) = (k.m * k.l, n::<S>(2, 1));
        Kernel {
            mass: [[n::<S>(2, 3) * ml * k.l, ml * c], [ml * c, two * k.m]],
            force: [-(ml * k.g * c), ml * u * u * s - two * k.m * k.g],
            gap: [n::<S>(1, 2) * k.l * s + y * c],
            jacobian: [[n::<S>(1, 2) * k.l * c - y * s, c]],
            bias: [-(n::<S>(1, 2) * k.l * s + y * c) * u * u - two * s * u * v],
            drift: [n(0, 1)],
        }
    }

    fn energy<S: Real>(k: &Constants<S>, state: &[S; 4]) -> Energy<S> {
        let [phi, y, u, v] = *state;
        let (s, c, _) = angle(phi);
        Energy {
            kinetic: k.m * (v * v + v * k.l * u * c + n::<S>(1, 3) * k.l * k.l * u * u),
            potential: n::<S>(2, 1) * k.m * k.g * (y + n::<S>(1, 2) * k.l * s),
        }
    }

    fn points<S: Real>(k: &Constants<S>, state: &[S; 4]) -> [S; 6] {
        let (s, c, _) = angle(state[0]);
        let (y, zero) = (state[1], n(0, 1));
        [zero, y, -(k.l * c), y + k.l * s, k.l * c, y + k.l * s]
    }

    fn feet<S: Real>(k: &Constants<S>, state: &[S; 4]) -> [S; 2] {
        let (s, c, _) = angle(state[0]);
        let foot = n::<S>(1, 2) * k.l * c - state[1] * s;
        [foot, k.l - foot]
    }

    fn quantity<S: Real>(_: &Constants<S>, _: usize, _: &[S; 4], _: &[S; 2], _: &[S; 1]) -> S {
        S::from_f64(f64::NAN)
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, form: Form, visitor: V) -> V::Output {
        match (form, set.0) {
            (Form::Closed, 1) => visitor.visit(Phase {
                set,
                form,
                coordinates: 1,
                rates: 1,
                derivative: on_corners::derivative,
                reactions: on_corners::reactions,
                embed: on_corners::embed,
                restrict: |state| [state[0], state[2]],
                pivot: |_, r| angle(r[0]).1,
                energy: on_corners::energy,
            }),
            _ => visitor.visit(Phase {
                set,
                form: Form::Projected,
                coordinates: 2,
                rates: 2,
                derivative: |k, set, state| kernel::derivative(&Self::kernel(k, state), &LAYOUT, set, state),
                reactions: |k, set, state| kernel::reactions(&Self::kernel(k, state), &LAYOUT, set),
                embed: |_, state| *state,
                restrict: |state| *state,
                pivot: |_, _| n(1, 1),
                energy: Self::energy,
            }),
        }
    }
}
