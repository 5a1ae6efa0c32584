//! A trebuchet by Lagrange's equations in the angles of beam, chest and sling from hanging down; in
//! the trough the stone's height is held by a multiplier.

use crate::numerics::{extrapolated, root};
use nalgebra::{Matrix4, Vector4};

/// Its masses and lengths.
#[derive(Clone, Copy, Debug)]
pub struct Trebuchet {
    /// Mass of the uniform beam.
    pub beam: f64,
    /// Mass of the chest.
    pub weight: f64,
    /// Moment of inertia of the chest about its middle.
    pub spin: f64,
    /// Mass of the stone.
    pub stone: f64,
    /// Short and long arm, chest, sling.
    pub lengths: [f64; 4],
    /// Gravity.
    pub g: f64,
}

/// Angles of beam, chest and sling, and their rates.
pub type TrebuchetState = [f64; 6];

impl Trebuchet {
    /// Accelerations of the angles, and the trough's force.
    fn solve(&self, y: &TrebuchetState, trough: bool) -> Vector4<f64> {
        let [a, b, c, s] = self.lengths;
        let [theta, psi, chi, p, q, r] = *y;
        let (first, second) = (-self.weight * a * c, self.stone * b * s);
        let half = 0.5 * (b - a);
        let about = self.beam * ((a + b) * (a + b) / 12.0 + half * half);
        let mut matrix = Matrix4::zeros();
        matrix[(0, 0)] = about + self.weight * a * a + self.stone * b * b;
        matrix[(1, 1)] = self.weight * c * c + self.spin;
        matrix[(2, 2)] = self.stone * s * s;
        let [d, f] = [theta - psi, theta - chi];
        for (i, value) in [(1, first * d.cos()), (2, second * f.cos())] {
            matrix[(0, i)] = value;
            matrix[(i, 0)] = value;
        }
        let weights = self.beam * half - self.weight * a + self.stone * b;
        let mut right = Vector4::new(
            -first * d.sin() * q * q - second * f.sin() * r * r - self.g * weights * theta.sin(),
            first * d.sin() * p * p - self.g * self.weight * c * psi.sin(),
            second * f.sin() * p * p - self.g * self.stone * s * chi.sin(),
            0.0,
        );
        if trough {
            for (i, slope) in [(0, b * theta.sin()), (2, s * chi.sin())] {
                matrix[(i, 3)] = -slope;
                matrix[(3, i)] = slope;
            }
            right[3] = -b * theta.cos() * p * p - s * chi.cos() * r * r;
        } else {
            matrix[(3, 3)] = 1.0;
        }
        matrix.lu().solve(&right).unwrap_or_default()
    }

    /// When something of the state first is zero, and the state then.
    fn until(
        &self,
        mut y: TrebuchetState,
        trough: bool,
        zero: impl Fn(&TrebuchetState) -> f64,
    ) -> Option<(f64, TrebuchetState)> {
        const STEP: f64 = 5e-3;
        let rates = |y: &TrebuchetState| {
            let turn = self.solve(y, trough);
            [y[3], y[4], y[5], turn[0], turn[1], turn[2]]
        };
        for k in 0..400 {
            let next = extrapolated(rates, &y, STEP);
            if zero(&y) > 0.0 && zero(&next) <= 0.0 {
                let rest = root(|step| zero(&extrapolated(rates, &y, step)), 0.0, STEP)?;
                return Some((f64::from(k) * STEP + rest, extrapolated(rates, &y, rest)));
            }
            y = next;
        }
        None
    }

    /// From rest: when the stone leaves the trough, and with what angles.
    pub fn lifted(&self, start: [f64; 3]) -> Option<(f64, TrebuchetState)> {
        let [theta, psi, chi] = start;
        self.until([theta, psi, chi, 0.0, 0.0, 0.0], true, |y| self.solve(y, true)[3])
    }

    /// From there: when the beam has come to an angle, and with what.
    pub fn released(&self, from: TrebuchetState, theta: f64) -> Option<(f64, TrebuchetState)> {
        self.until(from, false, |y| y[0] - theta)
    }

    /// Velocity of the stone.
    pub fn velocity(&self, y: &TrebuchetState) -> [f64; 2] {
        let [_, b, _, s] = self.lengths;
        let [theta, _, chi, p, _, r] = *y;
        [b * theta.cos() * p + s * chi.cos() * r, b * theta.sin() * p + s * chi.sin() * r]
    }
}
