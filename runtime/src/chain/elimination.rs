//! The forces in the joints: `Dₖ λₖ − Yₖ₋₁ λₖ₋₁ − Yₖ λₖ₊₁ = rₖ`, joints eliminated from the pin and from the free end at once,
//! which meet in the middle: two chains of operations that wait for their results, each half as long.
//!
//! Block elimination (G. H. Golub, C. F. Van Loan, *Matrix Computations*, 4th ed., 2013, § 4.5.1): a joint with `X λ = β + Y λ′`
//! hands `X′ = D′ − Y X⁻¹ Y`, `β′ = r′ + Y X⁻¹ β` to its neighbour, whose λ′ gives its own by `λ = X⁻¹ Y λ′ + X⁻¹ β`.

use super::geometry::Bars;
use super::plane::{Matrix, Symmetric, Vector};
use crate::scalar::Real;

/// X and β of a joint.
#[derive(Clone, Copy)]
pub(super) struct Joint<S> {
    pub(super) compliance: Symmetric<S>,
    pub(super) parting: Vector<S>,
}

/// X⁻¹Y and X⁻¹β of an eliminated joint.
pub(super) struct Eliminated<S> {
    pub(super) carried: Matrix<S>,
    pub(super) own: Vector<S>,
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
    fn force(&self, neighbour: Vector<S>) -> Vector<S> {
        self.carried.apply_to(neighbour, self.own)
    }
}

impl<S: Real, const N: usize> Bars<S, N> {
    /// Tells ω̇ of every bar, and λ at its first end.
    #[inline]
    pub(super) fn solve(&mut self, gravity: Vector<S>, mut tell: impl FnMut(usize, S, Vector<S>)) {
        let (pairs, middle) = ((N - 1) / 2, N / 2);
        let lead = middle - pairs;
        let meeting = self.joint(middle, gravity);
        let mut near = self.joint(0, gravity);
        let mut far = self.joint(N - 1, gravity);
        if lead == 1 {
            near = self.eliminate(0, near, self.across(0), self.joint(1, gravity));
        }
        for i in 0..pairs {
            let (k, j) = (lead + i, N - 1 - i);
            let (next, last) = (self.joint(k + 1, gravity), self.joint(j - 1, gravity));
            let across = self.across(j - 1);
            near = self.eliminate(k, near, self.across(k), next);
            far = self.eliminate(j, far, across, last);
        }
        if pairs > 0 {
            near = near.meet(far, meeting);
        }
        let mut before = near.force();
        let mut after = before;
        for i in (0..pairs).rev() {
            let (k, j) = (lead + i, N - 1 - i);
            let (first, last) = (self.eliminated(k).force(before), self.eliminated(j).force(after));
            tell(k, self.turn(k, first, before), first);
            tell(j - 1, self.turn(j - 1, after, last), after);
            (before, after) = (first, last);
        }
        if lead == 1 {
            let first = self.eliminated(0).force(before);
            tell(0, self.turn(0, first, before), first);
        }
        tell(N - 1, self.turn(N - 1, after, Vector::zero()), after);
    }

    #[inline]
    fn eliminate(&mut self, joint: usize, at: Joint<S>, across: Symmetric<S>, next: Joint<S>) -> Joint<S> {
        let (next, eliminated) = at.into_next(across, next);
        self.keep(joint, eliminated);
        next
    }
}
