//! The forces in the joints: `Dₖ λₖ − Yₖ₋₁ λₖ₋₁ − Yₖ λₖ₊₁ = rₖ`, joints eliminated from the pin and from the free end at once,
//! which meet in the middle: two chains of operations that wait for their results, each half as long.
//!
//! Block elimination (G. H. Golub, C. F. Van Loan, *Matrix Computations*, 4th ed., 2013, § 4.5.1): a joint with `X λ = β + Y λ′`
//! hands `X′ = D′ − Y X⁻¹ Y`, `β′ = r′ + Y X⁻¹ β` to its neighbour, whose λ′ gives its own by `λ = X⁻¹ Y λ′ + X⁻¹ β`.

use super::geometry::Bars;
use super::plane::{Matrix, Symmetric, Vector};
use super::two::Two;
use crate::scalar::Real;

/// X and β of a joint.
#[derive(Clone, Copy)]
pub(super) struct Joint<S> {
    pub(super) compliance: Symmetric<S>,
    pub(super) parting: Vector<S>,
}

/// X⁻¹Y and X⁻¹β of an eliminated joint.
#[derive(Clone, Copy)]
struct Eliminated<S> {
    carried: Matrix<S>,
    own: Vector<S>,
}

impl<S: Real> Joint<S> {
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
        let Vector { x, y } = adjugate.apply(parting);
        (reduced, Eliminated { carried, own: Vector { x: inverse * x, y: inverse * y } })
    }

    /// X⁻¹ β.
    #[inline]
    fn force(self) -> Vector<S> {
        let inverse = S::ratio(1, 1) / self.compliance.determinant();
        let Vector { x, y } = self.compliance.adjugate().apply(self.parting);
        Vector { x: inverse * x, y: inverse * y }
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
    fn nothing() -> Self {
        Self { carried: Matrix([S::ratio(0, 1); 4]), own: Vector::zero() }
    }

    #[inline]
    fn force(&self, neighbour: Vector<S>) -> Vector<S> {
        self.carried.apply_to(neighbour, self.own)
    }
}

/// A joint of each side, side by side.
#[inline(always)]
fn beside<S: Real>(near: Joint<S>, far: Joint<S>) -> Joint<Two<S>> {
    let two = |f: fn(&Joint<S>) -> S| Two([f(&near), f(&far)]);
    Joint {
        compliance: Symmetric {
            xx: two(|j| j.compliance.xx),
            xy: two(|j| j.compliance.xy),
            yy: two(|j| j.compliance.yy),
        },
        parting: Vector { x: two(|j| j.parting.x), y: two(|j| j.parting.y) },
    }
}

impl<S: Real> Joint<Two<S>> {
    #[inline(always)]
    fn side(self, i: usize) -> Joint<S> {
        let Self { compliance: Symmetric { xx, xy, yy }, parting } = self;
        Joint { compliance: Symmetric { xx: xx.0[i], xy: xy.0[i], yy: yy.0[i] }, parting: parting.side(i) }
    }
}

impl<S: Real> Vector<Two<S>> {
    #[inline(always)]
    fn side(self, i: usize) -> Vector<S> {
        Vector { x: self.x.0[i], y: self.y.0[i] }
    }
}

impl<S: Real, const N: usize> Bars<S, N> {
    /// Tells λ at the first and at the last end of every bar.
    #[inline]
    pub(super) fn solve(&self, gravity: Vector<S>, mut tell: impl FnMut(usize, Vector<S>, Vector<S>)) {
        let (pairs, middle) = ((N - 1) / 2, N / 2);
        let lead = middle - pairs;
        let mut near = self.pin(gravity);
        let mut first = Eliminated::nothing();
        if lead == 1 {
            (near, first) = near.into_next(self.across(0), self.joint(1));
        }
        let mut known = [Eliminated::<Two<S>>::nothing(); N];
        if pairs > 0 {
            let mut both = beside(near, self.joint(N - 1));
            for i in 0..pairs {
                let (k, j) = (lead + i, N - 1 - i);
                let next = beside(self.joint(k + 1), self.joint(j - 1));
                (both, known[i]) = both.into_next(self.across_two(k, j - 1), next);
            }
            near = both.side(0).meet(both.side(1), self.joint(middle));
        }
        let force = near.force();
        let mut both = Vector { x: Two([force.x; 2]), y: Two([force.y; 2]) };
        for i in (0..pairs).rev() {
            let (k, j) = (lead + i, N - 1 - i);
            let outer = known[i].force(both);
            tell(k, outer.side(0), both.side(0));
            tell(j - 1, both.side(1), outer.side(1));
            both = outer;
        }
        if lead == 1 {
            tell(0, first.force(both.side(0)), both.side(0));
        }
        tell(N - 1, both.side(1), Vector::zero());
    }
}
