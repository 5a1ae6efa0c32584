//! The compass walker of Goswami, Thuilot and Espiau by equations of its own: three point masses on
//! two legs, fixed steps of Runge and Kutta, heel strikes by the momenta about the new foot.

use nalgebra::{DMatrix, Matrix2, Vector2};

/// Masses m of a leg and M of the hip, lengths a and b, slope, gravity.
#[derive(Clone, Copy)]
pub struct Walker {
    pub m: f64,
    pub hip: f64,
    pub a: f64,
    pub b: f64,
    pub gamma: f64,
    pub g: f64,
}

/// A step of time, s: its fourth power, times some 1e3, is rounding.
const STEP: f64 = 1e-4;

/// Angles from the downward vertical and their rates, of the leg that stands and of the one that
/// swings.
pub type State = [f64; 4];

impl Walker {
    fn along(angle: f64) -> Vector2<f64> {
        Vector2::new(angle.sin(), -angle.cos())
    }

    /// Masses with ∂r/∂(stance, swing) about the standing foot.
    fn masses(&self, [stance, swing, ..]: State) -> [(f64, [Vector2<f64>; 2]); 3] {
        let l = self.a + self.b;
        let turned = |angle: f64| Vector2::new(angle.cos(), angle.sin());
        let none = Vector2::zeros();
        [
            (self.m, [-self.a * turned(stance), none]),
            (self.hip, [-l * turned(stance), none]),
            (self.m, [-l * turned(stance), self.b * turned(swing)]),
        ]
    }

    fn matrix(masses: &[(f64, [Vector2<f64>; 2]); 3]) -> Matrix2<f64> {
        Matrix2::from_fn(|i, j| masses.iter().map(|(m, along)| m * along[i].dot(&along[j])).sum())
    }

    fn rates(&self, state: State) -> State {
        let [stance, swing, u, v] = state;
        let l = self.a + self.b;
        let masses = self.masses(state);
        // What r̈ is without accelerations: −θ̇² r of each part.
        let parts = [
            self.a * Self::along(stance) * u * u,
            l * Self::along(stance) * u * u,
            l * Self::along(stance) * u * u - self.b * Self::along(swing) * v * v,
        ];
        let weight = Vector2::new(0.0, -self.g);
        let force = Vector2::from_fn(|i, _| {
            masses.iter().zip(&parts).map(|((m, along), part)| m * along[i].dot(&(weight - part))).sum()
        });
        let a = Self::matrix(&masses).try_inverse().unwrap() * force;
        [u, v, a[0], a[1]]
    }

    fn advanced(&self, y: State, h: f64) -> State {
        let moved = |k: State, h: f64| core::array::from_fn(|i| y[i] + h * k[i]);
        let k1 = self.rates(y);
        let k2 = self.rates(moved(k1, 0.5 * h));
        let k3 = self.rates(moved(k2, 0.5 * h));
        let k4 = self.rates(moved(k3, h));
        core::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
    }

    /// From one heel strike to the next: the angle of the leg that has just come down and the rates
    /// of both legs, it first, and the time of the step.
    fn step(&self, [stance, u, v]: [f64; 3]) -> ([f64; 3], f64) {
        // Both feet are on the slope where the angles add up to −2γ.
        let above = |y: &State| y[0] + y[1] + 2.0 * self.gamma;
        let (mut y, mut t) = ([stance, -2.0 * self.gamma - stance, u, v], 0.0);
        loop {
            let next = self.advanced(y, STEP);
            // The swinging leg comes down in front.
            if t > 0.1 && next[1] > next[0] && above(&y) * above(&next) <= 0.0 && above(&next) > above(&y) {
                break;
            }
            (y, t) = (next, t + STEP);
        }
        let (mut low, mut high) = (0.0, STEP);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if above(&self.advanced(y, middle)) < 0.0 { low = middle } else { high = middle }
        }
        let h = 0.5 * (low + high);
        (self.struck(self.advanced(y, h)), t + h)
    }

    /// The impulse at the new foot does no work on motions about it: their momenta stay.
    fn struck(&self, [old, new, u, v]: State) -> [f64; 3] {
        let before = self.masses([old, new, u, v]).map(|(m, along)| m * (along[0] * u + along[1] * v));
        let after = self.masses([new, old, 0.0, 0.0]);
        // Of the leg that stood, then the hip, then the other: the parts change their order.
        let momenta = [before[2], before[1], before[0]];
        let momentum =
            Vector2::from_fn(|i, _| after.iter().zip(&momenta).map(|((_, along), p)| along[i].dot(p)).sum());
        let rates = Self::matrix(&after).try_inverse().unwrap() * momentum;
        [new, rates[0], rates[1]]
    }

    /// Two steps, after which the same leg stands.
    pub fn gait(&self, state: [f64; 3]) -> ([f64; 3], f64) {
        let (middle, first) = self.step(state);
        let (end, second) = self.step(middle);
        (end, first + second)
    }

    /// The derivatives of a gait by central differences of the sixth order.
    pub fn slopes(&self, state: [f64; 3]) -> DMatrix<f64> {
        let h = 2e-3;
        DMatrix::from_fn(3, 3, |i, j| {
            let difference = |k: f64| {
                let at = |sign: f64| {
                    let mut moved = state;
                    moved[j] += sign * k * h;
                    self.gait(moved).0[i]
                };
                at(1.0) - at(-1.0)
            };
            (45.0 * difference(1.0) - 9.0 * difference(2.0) + difference(3.0)) / (60.0 * h)
        })
    }
}
