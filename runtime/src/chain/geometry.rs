//! What the equations need of each bar, one array a quantity so that bars are computed side by side.

use super::Chain;
use super::elimination::Joint;
use super::plane::{Symmetric, Vector};
use super::two::Two;
use crate::scalar::Real;

/// Y, −½ l ω² e and −(m l/2J) n of every bar.
pub(super) struct Bars<S, const N: usize> {
    xx: [S; N],
    xy: [S; N],
    yy: [S; N],
    pull_x: [S; N],
    pull_y: [S; N],
    turn_x: [S; N],
    turn_y: [S; N],
}

impl<S: Real, const N: usize> Bars<S, N> {
    #[inline]
    pub(super) fn of(chain: &Chain<S>, angles: &[S; N], rates: &[S; N]) -> Self {
        const { assert!(N > 0, "a chain has a bar") };
        let (sin, cos) = S::sin_cos_each(*angles);
        let none = [S::ratio(0, 1); N];
        let one = S::ratio(1, 1);
        let (kappa, half) = (chain.slenderness, -(chain.length * S::ratio(1, 2)));
        let mut bars =
            Self { xx: none, xy: none, yy: none, pull_x: none, pull_y: none, turn_x: none, turn_y: none };
        for k in 0..N {
            let across = kappa * sin[k];
            bars.xx[k] = (-across).mul_add(sin[k], one);
            bars.xy[k] = across * cos[k];
            bars.yy[k] = across.mul_add(sin[k], one - kappa);
            let pull = half * rates[k] * rates[k];
            (bars.pull_x[k], bars.pull_y[k]) = (pull * cos[k], pull * sin[k]);
            (bars.turn_x[k], bars.turn_y[k]) = (chain.lever * sin[k], -(chain.lever * cos[k]));
        }
        bars
    }

    /// Y.
    #[inline]
    pub(super) fn across(&self, bar: usize) -> Symmetric<S> {
        Symmetric { xx: self.xx[bar], xy: self.xy[bar], yy: self.yy[bar] }
    }

    /// Y of two bars.
    #[inline(always)]
    pub(super) fn across_two(&self, near: usize, far: usize) -> Symmetric<Two<S>> {
        let two = |of: &[S; N]| Two([of[near], of[far]]);
        Symmetric { xx: two(&self.xx), xy: two(&self.xy), yy: two(&self.yy) }
    }

    #[inline]
    fn pull(&self, bar: usize) -> Vector<S> {
        Vector { x: self.pull_x[bar], y: self.pull_y[bar] }
    }

    /// The pin.
    #[inline]
    pub(super) fn pin(&self, gravity: Vector<S>) -> Joint<S> {
        let two = S::ratio(2, 1);
        Joint {
            compliance: Symmetric { xx: two, xy: S::ratio(0, 1), yy: two } - self.across(0),
            parting: self.pull(0) - gravity,
        }
    }

    /// The joint before `bar`, not the pin.
    #[inline]
    pub(super) fn joint(&self, bar: usize) -> Joint<S> {
        let four = S::ratio(4, 1);
        let across = self.across(bar - 1) + self.across(bar);
        Joint {
            compliance: Symmetric { xx: four, xy: S::ratio(0, 1), yy: four } - across,
            parting: self.pull(bar - 1) + self.pull(bar),
        }
    }

    /// ω̇ of a bar from λ at its two ends.
    #[inline]
    pub(super) fn turn(&self, bar: usize, first: Vector<S>, last: Vector<S>) -> S {
        Vector { x: self.turn_x[bar], y: self.turn_y[bar] }.dot(first + last)
    }
}
