//! Factors S that balance a system, `(S K S)(S⁻¹x) = S r`: unit inertias and unit rows of
//! constraints.

use crate::model::KernelView;
use crate::scalar::Scalar;

/// Writes factors that make the diagonal of M one, then the largest entry of each closed row of J.
#[inline(always)]
pub(crate) fn balance<S: Scalar>(kernel: &(impl KernelView<S> + ?Sized), closed: &[usize], scale: &mut [S]) {
    let n = kernel.force().len();
    scale.fill(S::ratio(1, 1));
    for j in 0..n {
        let inertia = constant(kernel.mass(j)[j]);
        let column = closed.iter().map(|&row| constant(kernel.jacobian(row)[j]));
        scale[j] = reciprocal(if inertia > S::ZERO { inertia.sqrt() } else { largest(column) });
    }
    for (k, &row) in (n..).zip(closed) {
        scale[k] = reciprocal(largest((0..n).map(|j| balanced(constant(kernel.jacobian(row)[j]), scale[j]))));
    }
}

/// x without its derivatives: what is balanced is unbalanced by the same, whatever that is.
#[inline(always)]
fn constant<S: Scalar>(x: S) -> S {
    if S::DIFFERENTIATED { S::from_f64(x.to_f64()) } else { x }
}

/// x times a factor of the balance.
#[inline(always)]
pub(super) fn balanced<S: Scalar>(x: S, scale: S) -> S {
    if S::DIFFERENTIATED { x.scaled(scale.to_f64()) } else { x * scale }
}

#[inline(always)]
fn largest<S: Scalar>(entries: impl Iterator<Item = S>) -> S {
    entries.fold(S::ZERO, |most, x| if x.abs() > most { x.abs() } else { most })
}

/// `1 / x`, and 1 for zero.
#[inline(always)]
fn reciprocal<S: Scalar>(x: S) -> S {
    if x > S::ZERO { S::ratio(1, 1) / x } else { S::ratio(1, 1) }
}
