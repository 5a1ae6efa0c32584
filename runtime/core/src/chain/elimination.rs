//! The forces in the joints: `Dₖ λₖ − Yₖ₋₁ λₖ₋₁ − Yₖ λₖ₊₁ = rₖ`, joints eliminated from the pin and
//! from the free end at once, which meet in the middle: two chains of operations that wait for
//! their results, each half as long.
//!
//! Block elimination (G. H. Golub, C. F. Van Loan, *Matrix Computations*, 4th ed., 2013, § 4.5.1):
//! a joint with `X λ = β + Y λ′` hands `X′ = D′ − Y X⁻¹ Y`, `β′ = r′ + Y X⁻¹ β` to its neighbour,
//! whose λ′ gives its own by `λ = X⁻¹ Y λ′ + X⁻¹ β`.

use super::geometry::Bars;
use super::joint::{Eliminated, JointCompliance};
use super::plane::{PlaneVector, Symmetric};
use super::two_ended::TwoEnded;
use crate::scalar::Real;

impl<S: Real> JointCompliance<S> {
    /// Eliminates this joint across a bar with this Y into the joint `next`.
    #[inline]
    fn into_next(self, across: Symmetric<S>, next: Self) -> (Self, Eliminated<S>) {
        let Self { compliance, parting } = self;
        let inverse = S::ratio(1, 1) / compliance.determinant();
        let adjugate = compliance.adjugate();
        let product = adjugate.times(across);
        let carried = product.scaled(inverse);
        let reduced = Self {
            compliance: next.compliance.less(inverse, across.times_to_symmetric(product)),
            parting: carried.transpose_to(parting, next.parting),
        };
        let PlaneVector { x, y } = adjugate.apply(parting);
        (reduced, Eliminated { carried, own: PlaneVector { x: inverse * x, y: inverse * y } })
    }

    /// X⁻¹ β.
    #[inline]
    fn force(self) -> PlaneVector<S> {
        let inverse = S::ratio(1, 1) / self.compliance.determinant();
        let PlaneVector { x, y } = self.compliance.adjugate().apply(self.parting);
        PlaneVector { x: inverse * x, y: inverse * y }
    }

    /// Two joints that are one, less what both have counted.
    #[inline]
    fn meet(self, other: Self, counted: Self) -> Self {
        Self {
            compliance: self.compliance + (other.compliance - counted.compliance),
            parting: self.parting + (other.parting - counted.parting),
        }
    }
}

impl<S: Real> Eliminated<S> {
    #[inline]
    fn force(&self, neighbour: PlaneVector<S>) -> PlaneVector<S> {
        self.carried.apply_to(neighbour, self.own)
    }
}

/// A joint of each side, side by side.
#[inline(always)]
fn beside<S: Real>(near: JointCompliance<S>, far: JointCompliance<S>) -> JointCompliance<TwoEnded<S>> {
    let two = |f: fn(&JointCompliance<S>) -> S| TwoEnded([f(&near), f(&far)]);
    JointCompliance {
        compliance: Symmetric {
            xx: two(|j| j.compliance.xx),
            xy: two(|j| j.compliance.xy),
            yy: two(|j| j.compliance.yy),
        },
        parting: PlaneVector { x: two(|j| j.parting.x), y: two(|j| j.parting.y) },
    }
}

impl<S: Real> JointCompliance<TwoEnded<S>> {
    #[inline(always)]
    fn side(self, i: usize) -> JointCompliance<S> {
        let Self { compliance: Symmetric { xx, xy, yy }, parting } = self;
        JointCompliance {
            compliance: Symmetric { xx: xx.0[i], xy: xy.0[i], yy: yy.0[i] },
            parting: parting.side(i),
        }
    }
}

impl<S: Real> PlaneVector<TwoEnded<S>> {
    #[inline(always)]
    fn side(self, i: usize) -> PlaneVector<S> {
        PlaneVector { x: self.x.0[i], y: self.y.0[i] }
    }
}

impl<S: Real, const N: usize> Bars<S, N> {
    /// Tells ω̇ of every bar, and λ at its first end.
    #[inline]
    pub(super) fn solve(&mut self, gravity: PlaneVector<S>, mut tell: impl FnMut(usize, S, PlaneVector<S>)) {
        let (pairs, middle) = ((N - 1) / 2, N / 2);
        let lead = middle - pairs;
        let meeting = self.joint(middle, gravity);
        let mut near = self.joint(0, gravity);
        let mut first = None;
        if lead == 1 {
            let (next, eliminated) = near.into_next(self.across(0), self.joint(1, gravity));
            (near, first) = (next, Some(eliminated));
        }
        if pairs > 0 {
            let mut both = beside(near, self.joint(N - 1, gravity));
            for i in 0..pairs {
                let (k, j) = (lead + i, N - 1 - i);
                let next = beside(self.joint(k + 1, gravity), self.joint(j - 1, gravity));
                let eliminated;
                (both, eliminated) = both.into_next(self.across_two(k, j - 1), next);
                self.keep([k, j], eliminated);
            }
            near = both.side(0).meet(both.side(1), meeting);
        }
        let force = near.force();
        let mut both = PlaneVector { x: TwoEnded([force.x; 2]), y: TwoEnded([force.y; 2]) };
        for i in (0..pairs).rev() {
            let (k, j) = (lead + i, N - 1 - i);
            let outer = self.eliminated([k, j]).force(both);
            let turn = self.turn_two([k, j - 1], outer + both);
            tell(k, turn.0[0], outer.side(0));
            tell(j - 1, turn.0[1], both.side(1));
            both = outer;
        }
        if let Some(first) = first {
            let (inner, outer) = (both.side(0), first.force(both.side(0)));
            tell(0, self.turn(0, outer + inner), outer);
        }
        tell(N - 1, self.turn(N - 1, both.side(1)), both.side(1));
    }
}
