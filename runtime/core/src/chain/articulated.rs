//! The accelerations from the free end and back: a joint feels what hangs from it as a mass that
//! depends on the direction.
//!
//! What hangs from the first end of a bar answers its acceleration a, less g, with the force −(A a +
//! b), per mass of a bar. From A′ and b′ at its other end, zero beyond the last bar, r = l ω² e and
//! j = J/m + l²/4 follow
//!
//! ```text
//! v = ½ l n + A′ l n,     c = j + l n·A′ l n,    b″ = b′ − A′ r,    s = l n·b″
//! A = 1 + A′ − v vᵀ/c,    b = b″ − ½ r − s v/c
//! ω̇ = −(v·a + s)/c,       a′ = a + ω̇ l n − r
//! ```
//!
//! (R. Featherstone, *Rigid Body Dynamics Algorithms*, 2008, ch. 7). These are fewer operations
//! than those of `elimination`, in one chain twice as long: for many states at once, which hide the
//! waiting; and for small J, of which nothing is divided by.

use arrayvec::ArrayVec;

use super::Chain;
use super::plane::{PlaneVector, Symmetric};
use crate::scalar::Real;

/// A and b of what hangs from a joint.
struct Hanging<S> {
    mass: Symmetric<S>,
    bias: PlaneVector<S>,
}

/// l e, v/c, s/c and ω² of a bar.
struct Answer<S> {
    along: PlaneVector<S>,
    turn: PlaneVector<S>,
    bias: S,
    square: S,
}

impl<S: Real> Chain<S> {
    /// The angular acceleration of each bar, to more digits than [`Self::accelerations`] where J is
    /// small beside m l².
    #[inline(always)]
    pub fn articulated<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> [S; N] {
        let inertia = (self.length * self.length).mul_add(S::ratio(1, 4), self.inertia / self.mass);
        let zero = S::ratio(0, 1);
        let mass = Symmetric { xx: zero, xy: zero, yy: zero };
        let mut hanging = Hanging { mass, bias: PlaneVector::zero() };
        let mut answers = ArrayVec::<Answer<S>, N>::new();
        for (angle, rate) in angles.iter().zip(rates).rev() {
            let (sin, cos) = angle.sin_cos();
            let along = PlaneVector { x: self.length * cos, y: self.length * sin };
            answers.push(hanging.pass(along, *rate, inertia));
        }
        let mut a = PlaneVector { x: -self.gravity.x, y: -self.gravity.y };
        let mut accelerations = *rates;
        for (acceleration, answer) in accelerations.iter_mut().zip(answers.iter().rev()) {
            *acceleration = answer.pass(&mut a);
        }
        accelerations
    }
}

impl<S: Real> Hanging<S> {
    /// From what hangs from the other end of a bar with this l e, ω and j to what hangs from the
    /// first.
    #[inline(always)]
    fn pass(&mut self, along: PlaneVector<S>, rate: S, inertia: S) -> Answer<S> {
        let (half, one) = (S::ratio(1, 2), S::ratio(1, 1));
        let Self { mass: Symmetric { xx, xy, yy }, bias: b } = *self;
        let (PlaneVector { x, y }, square) = (along, rate * rate);
        let r = along.scaled(square);
        // l n = (−y, x).
        let carried = PlaneVector { x: xy.mul_add(x, -(xx * y)), y: yy.mul_add(x, -(xy * y)) };
        let v = PlaneVector { x: (-half).mul_add(y, carried.x), y: half.mul_add(x, carried.y) };
        let inverse = one / x.mul_add(carried.y, (-y).mul_add(carried.x, inertia));
        let beyond = PlaneVector {
            x: (-xx).mul_add(r.x, (-xy).mul_add(r.y, b.x)),
            y: (-xy).mul_add(r.x, (-yy).mul_add(r.y, b.y)),
        };
        let s = x.mul_add(beyond.y, -(y * beyond.x));
        let turn = v.scaled(inverse);
        self.mass = Symmetric {
            xx: (-v.x).mul_add(turn.x, xx + one),
            xy: (-v.x).mul_add(turn.y, xy),
            yy: (-v.y).mul_add(turn.y, yy + one),
        };
        self.bias = PlaneVector {
            x: (-s).mul_add(turn.x, (-half).mul_add(r.x, beyond.x)),
            y: (-s).mul_add(turn.y, (-half).mul_add(r.y, beyond.y)),
        };
        Answer { along, turn, bias: inverse * s, square }
    }
}

impl<S: Real> Answer<S> {
    /// ω̇; from a at the first end to that at the other.
    #[inline(always)]
    fn pass(&self, a: &mut PlaneVector<S>) -> S {
        let Self { along: PlaneVector { x, y }, turn, bias, square } = *self;
        let turn = -turn.x.mul_add(a.x, turn.y.mul_add(a.y, bias));
        a.x = (-turn).mul_add(y, (-square).mul_add(x, a.x));
        a.y = turn.mul_add(x, (-square).mul_add(y, a.y));
        turn
    }
}
