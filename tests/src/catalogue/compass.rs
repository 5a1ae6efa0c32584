//! The compass gait (Goswami, Thuilot and Espiau 1998): two equal legs with a point mass each and a
//! point mass at the hip, by Lagrange's equations about the foot that stands; at a heel strike by
//! the moments of momentum that keep their values.

use crate::numerics::{extrapolated, root};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

/// Its masses and lengths.
#[derive(Clone, Copy, Debug)]
pub struct Compass {
    /// Mass of a leg, at `a` from its foot and `b` from the hip.
    pub leg: f64,
    /// Mass of the hip.
    pub hip: f64,
    /// From a foot to the mass of its leg.
    pub a: f64,
    /// From there to the hip.
    pub b: f64,
    /// Angle of the slope.
    pub slope: f64,
    /// Gravity.
    pub g: f64,
}

/// Just after a heel strike: the angle of the leg that stands, from the vertical and
/// counter-clockwise from its foot, its rate and that of the other leg; both feet are on the slope.
pub type Stride = [f64; 3];

/// Places and velocities by `sin` and `cos` of the angle of a leg, from foot to hip.
fn up(angle: f64) -> Vector2<f64> {
    Vector2::new(-angle.sin(), angle.cos())
}

fn turned(angle: f64, rate: f64) -> Vector2<f64> {
    Vector2::new(-angle.cos(), -angle.sin()) * rate
}

impl Compass {
    /// Angles of the standing and of the swinging leg, and their rates: how they change.
    fn rates(&self, y: &[f64; 4]) -> [f64; 4] {
        let [stance, swing, p, q] = *y;
        let (l, apart) = (self.a + self.b, stance - swing);
        let c = self.leg * l * self.b;
        let masses = Matrix2::new(
            self.hip * l * l + self.leg * (self.a * self.a + l * l),
            -c * apart.cos(),
            -c * apart.cos(),
            self.leg * self.b * self.b,
        );
        let moment = self.g * (self.hip * l + self.leg * (self.a + l));
        let forces = Vector2::new(
            c * apart.sin() * q * q + moment * stance.sin(),
            -c * apart.sin() * p * p - self.leg * self.b * self.g * swing.sin(),
        );
        let turn = masses.lu().solve(&forces).unwrap_or_default();
        [p, q, turn[0], turn[1]]
    }

    /// Rates after a heel strike of the leg that swung, and of the one that stood.
    fn struck(&self, [stance, swing, p, q]: [f64; 4]) -> [f64; 2] {
        let (l, cross) = (self.a + self.b, |a: Vector2<f64>, b: Vector2<f64>| a.perp(&b));
        // The moments about the new foot of all, and about the hip of the leg that stood.
        let moments = |hip: Vector2<f64>, ahead: Vector2<f64>, behind: Vector2<f64>| {
            let arm = -self.b * up(stance);
            let all = self.hip * cross(l * up(swing), hip)
                + self.leg * (cross(self.a * up(swing), ahead) + cross(l * up(swing) + arm, behind));
            Vector2::new(all, self.leg * cross(arm, behind))
        };
        let hip = turned(stance, l * p);
        let before = moments(hip, hip - turned(swing, self.b * q), turned(stance, self.a * p));
        let after = |p: f64, q: f64| {
            let hip = turned(swing, l * p);
            moments(hip, turned(swing, self.a * p), hip - turned(stance, self.b * q))
        };
        let matrix = Matrix2::from_columns(&[after(1.0, 0.0), after(0.0, 1.0)]);
        let rates = matrix.lu().solve(&before).unwrap_or_default();
        [rates[0], rates[1]]
    }

    /// The next stride and the time it takes; nothing if the foot does not come down within two
    /// seconds.
    pub fn next(&self, [angle, p, q]: Stride) -> Option<(Stride, f64)> {
        const STEP: f64 = 0.01;
        let mut y = [angle, -2.0 * self.slope - angle, p, q];
        // Both feet are on the slope where this is zero: at the start, where the foot scuffs, and
        // where it comes down ahead.
        let above = |y: &[f64; 4]| y[0] + y[1] + 2.0 * self.slope;
        let ahead = |y: &[f64; 4], step: f64| extrapolated(|y| self.rates(y), y, step);
        for k in 0..200 {
            let next = ahead(&y, STEP);
            if k > 0 && above(&y) > 0.0 && above(&next) <= 0.0 {
                let rest = root(|step| above(&ahead(&y, step)), 0.0, STEP)?;
                let end = ahead(&y, rest);
                let [p, q] = self.struck(end);
                return Some(([end[1], p, q], f64::from(k) * STEP + rest));
            }
            y = next;
        }
        None
    }

    /// The stride that comes back, by Newton's method from one beside it.
    pub fn gait(&self, from: Stride) -> Option<Stride> {
        let mut stride = Vector3::from(from);
        for _ in 0..8 {
            let miss =
                |stride: Vector3<f64>| self.next(stride.into()).map(|(next, _)| Vector3::from(next) - stride);
            let here = miss(stride)?;
            let mut slopes = Matrix3::zeros();
            for i in 0..3 {
                let aside = Vector3::ith(i, 1e-6);
                slopes.set_column(i, &((miss(stride + aside)? - miss(stride - aside)?) / 2e-6));
            }
            stride -= slopes.lu().solve(&here)?;
        }
        Some(stride.into())
    }
}
