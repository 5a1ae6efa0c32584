//! Quantities of each bar for the equations, one array per quantity so that bars are computed side
//! by side.

use core::array::from_fn;

use super::Chain;
use super::joint::{Eliminated, JointCompliance};
use super::plane::{Matrix, PlaneVector, Symmetric};
use super::two_ended::TwoEnded;
use crate::scalar::Real;

/// Y, −½ l ω² e and −(m l/2J) n of every bar; X⁻¹Y and X⁻¹β of an eliminated joint overwrite the
/// entries of its bar. Arrays are not cleared first: that would take as long as solving a short
/// chain.
pub(super) struct Bars<S, const N: usize> {
    xx: [S; N],
    xy: [S; N],
    yy: [S; N],
    pull_x: [S; N],
    pull_y: [S; N],
    turn_x: [S; N],
    turn_y: [S; N],
    /// The fourth entry of X⁻¹Y; arbitrary before elimination.
    fourth: [S; N],
}

impl<S: Real, const N: usize> Bars<S, N> {
    #[inline]
    pub(super) fn compute(chain: &Chain<S>, angles: &[S; N], rates: &[S; N]) -> Self {
        const { assert!(N > 0, "a chain has a bar") };
        let (sin, cos) = S::sin_cos_each(*angles);
        let one = S::ratio(1, 1);
        let (kappa, lever, half) = (chain.slenderness, chain.lever, -(chain.length * S::ratio(1, 2)));
        Self {
            xx: from_fn(|k| (-(kappa * sin[k])).mul_add(sin[k], one)),
            xy: from_fn(|k| kappa * sin[k] * cos[k]),
            yy: from_fn(|k| (kappa * sin[k]).mul_add(sin[k], one - kappa)),
            pull_x: from_fn(|k| half * rates[k] * rates[k] * cos[k]),
            pull_y: from_fn(|k| half * rates[k] * rates[k] * sin[k]),
            turn_x: from_fn(|k| lever * sin[k]),
            turn_y: from_fn(|k| -(lever * cos[k])),
            fourth: *rates,
        }
    }

    /// Y.
    #[inline]
    pub(super) fn across(&self, bar: usize) -> Symmetric<S> {
        Symmetric { xx: self.xx[bar], xy: self.xy[bar], yy: self.yy[bar] }
    }

    /// Y of two bars.
    #[inline(always)]
    pub(super) fn across_two(&self, near: usize, far: usize) -> Symmetric<TwoEnded<S>> {
        let two = |of: &[S; N]| TwoEnded([of[near], of[far]]);
        Symmetric { xx: two(&self.xx), xy: two(&self.xy), yy: two(&self.yy) }
    }

    #[inline]
    fn pull(&self, bar: usize) -> PlaneVector<S> {
        PlaneVector { x: self.pull_x[bar], y: self.pull_y[bar] }
    }

    /// The joint before `bar`, the pin before the first.
    #[inline]
    pub(super) fn joint(&self, bar: usize, gravity: PlaneVector<S>) -> JointCompliance<S> {
        let identity =
            |times| Symmetric { xx: S::ratio(times, 1), xy: S::ratio(0, 1), yy: S::ratio(times, 1) };
        match bar.checked_sub(1) {
            None => JointCompliance {
                compliance: identity(2) - self.across(bar),
                parting: self.pull(bar) - gravity,
            },
            Some(before) => JointCompliance {
                compliance: identity(4) - (self.across(before) + self.across(bar)),
                parting: self.pull(before) + self.pull(bar),
            },
        }
    }

    /// Stores two eliminated joints in place of the entries of their bars.
    #[inline(always)]
    pub(super) fn keep(&mut self, joints: [usize; 2], Eliminated { carried, own }: Eliminated<TwoEnded<S>>) {
        let [xx, xy, yy, fourth] = carried.0;
        for (side, joint) in joints.into_iter().enumerate() {
            (self.xx[joint], self.xy[joint], self.yy[joint]) = (xx.0[side], xy.0[side], yy.0[side]);
            (self.fourth[joint], self.pull_x[joint], self.pull_y[joint]) =
                (fourth.0[side], own.x.0[side], own.y.0[side]);
        }
    }

    #[inline(always)]
    pub(super) fn eliminated(&self, [near, far]: [usize; 2]) -> Eliminated<TwoEnded<S>> {
        let two = |of: &[S; N]| TwoEnded([of[near], of[far]]);
        let carried = Matrix([two(&self.xx), two(&self.xy), two(&self.yy), two(&self.fourth)]);
        Eliminated { carried, own: PlaneVector { x: two(&self.pull_x), y: two(&self.pull_y) } }
    }

    /// ω̇ of a bar from the sum of λ at its two ends.
    #[inline(always)]
    pub(super) fn turn(&self, bar: usize, sum: PlaneVector<S>) -> S {
        PlaneVector { x: self.turn_x[bar], y: self.turn_y[bar] }.dot(sum)
    }

    /// ω̇ of two bars.
    #[inline(always)]
    pub(super) fn turn_two(&self, [near, far]: [usize; 2], sum: PlaneVector<TwoEnded<S>>) -> TwoEnded<S> {
        let two = |of: &[S; N]| TwoEnded([of[near], of[far]]);
        PlaneVector { x: two(&self.turn_x), y: two(&self.turn_y) }.dot(sum)
    }
}
