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

impl<S: Real, const N: usize> Bars<S, N> {
    /// Tells λ at the first and at the last end of every bar.
    #[inline]
    pub(super) fn solve(&self, gravity: Vector<S>, mut tell: impl FnMut(usize, Vector<S>, Vector<S>)) {
        let (pairs, middle) = ((N - 1) / 2, N / 2);
        let lead = middle - pairs;
        let mut known = [Eliminated::nothing(); N];
        let mut near = self.pin(gravity);
        if lead == 1 {
            (near, known[0]) = near.into_next(self.across(0), self.joint(1));
        }
        if pairs > 0 {
            let mut far = self.joint(N - 1);
            for i in 0..pairs {
                let (k, j) = (lead + i, N - 1 - i);
                (near, known[k]) = near.into_next(self.across(k), self.joint(k + 1));
                (far, known[j]) = far.into_next(self.across(j - 1), self.joint(j - 1));
            }
            near = near.meet(far, self.joint(middle));
        }
        let mut before = near.force();
        let mut after = before;
        for i in (0..pairs).rev() {
            let (k, j) = (lead + i, N - 1 - i);
            let (first, last) = (known[k].force(before), known[j].force(after));
            tell(k, first, before);
            tell(j - 1, after, last);
            (before, after) = (first, last);
        }
        if lead == 1 {
            tell(0, known[0].force(before), before);
        }
        tell(N - 1, after, Vector::zero());
    }
}
