//! The accelerations from the free end and back: a joint feels what hangs from it as a mass that depends on the direction.
//!
//! What hangs from the first end of a bar answers its acceleration a, less g, with the force −(A a + b), per mass of a bar.
//! From A′ and b′ at its other end, zero beyond the last bar, r = l ω² e and j = J/m + l²/4 follow
//!
//! ```text
//! v = ½ l n + A′ l n,     c = j + l n·A′ l n,    b″ = b′ − A′ r,    s = l n·b″
//! A = 1 + A′ − v vᵀ/c,    b = b″ − ½ r − s v/c
//! ω̇ = −(v·a + s)/c,       a′ = a + ω̇ l n − r
//! ```
//!
//! (R. Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7). These are fewer operations than those of `elimination`, in
//! one chain twice as long: for many states at once, which hide the waiting.

use super::Chain;
use super::plane::Vector;
use crate::scalar::Real;

impl<S: Real> Chain<S> {
    /// The angular acceleration of each bar.
    #[inline(always)]
    pub(super) fn from_free_end<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> [S; N] {
        let (half, one, zero) = (S::ratio(1, 2), S::ratio(1, 1), S::ratio(0, 1));
        // l e, its components one array each.
        let (mut along_y, mut along_x) = S::sin_cos_each(*angles);
        (0..N).for_each(|k| (along_x[k], along_y[k]) = (self.length * along_x[k], self.length * along_y[k]));
        let inertia = (self.length * self.length).mul_add(S::ratio(1, 4), self.inertia / self.mass);
        // v/c and s/c.
        let [mut turn_x, mut turn_y, mut bias] = [*rates; 3];
        let (mut xx, mut xy, mut yy, mut b) = (zero, zero, zero, Vector { x: zero, y: zero });
        for k in (0..N).rev() {
            // l n = (−y, x).
            let (x, y) = (along_x[k], along_y[k]);
            let square = rates[k] * rates[k];
            let r = Vector { x: square * x, y: square * y };
            let carried = Vector { x: xy.mul_add(x, -(xx * y)), y: yy.mul_add(x, -(xy * y)) };
            let v = Vector { x: (-half).mul_add(y, carried.x), y: half.mul_add(x, carried.y) };
            let inverse = one / x.mul_add(carried.y, (-y).mul_add(carried.x, inertia));
            let beyond = Vector {
                x: (-xx).mul_add(r.x, (-xy).mul_add(r.y, b.x)),
                y: (-xy).mul_add(r.x, (-yy).mul_add(r.y, b.y)),
            };
            let s = x.mul_add(beyond.y, -(y * beyond.x));
            let turn = v.scaled(inverse);
            xx = (-v.x).mul_add(turn.x, xx + one);
            xy = (-v.x).mul_add(turn.y, xy);
            yy = (-v.y).mul_add(turn.y, yy + one);
            b = Vector {
                x: (-s).mul_add(turn.x, (-half).mul_add(r.x, beyond.x)),
                y: (-s).mul_add(turn.y, (-half).mul_add(r.y, beyond.y)),
            };
            (turn_x[k], turn_y[k], bias[k]) = (turn.x, turn.y, inverse * s);
        }
        let mut accelerations = bias;
        let (mut ax, mut ay) = (-self.gravity.x, -self.gravity.y);
        for k in 0..N {
            let turn = -turn_x[k].mul_add(ax, turn_y[k].mul_add(ay, bias[k]));
            let square = rates[k] * rates[k];
            accelerations[k] = turn;
            ax = (-turn).mul_add(along_y[k], (-square).mul_add(along_x[k], ax));
            ay = turn.mul_add(along_x[k], (-square).mul_add(along_y[k], ay));
        }
        accelerations
    }
}
