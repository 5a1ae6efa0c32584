//! Real roots of polynomials in one unknown, isolated with certainty: integers only, Descartes'
//! rule of signs on Bernstein coefficients (Collins & Akritas 1976; Lane & Riesenfeld 1981), then
//! bisection.

mod interval;
#[cfg(test)]
mod tests;
mod univariate;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

pub(crate) use univariate::Univariate;

/// Halvings of an interval of length 1 around a root: beyond the 53 bits of a double, and 27 more
/// where it is small.
const BITS: u32 = 80;

/// A real root.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Root {
    /// The root, within 2⁻⁸⁰ of the length of the interval it was sought in.
    pub at: BigRational,
    /// How often it is one: 2 where two roots have become one.
    pub multiplicity: u32,
}

/// The roots within `[−1, 1]`, in increasing order.
pub(crate) fn within_unit(polynomial: &Univariate) -> Vec<Root> {
    let one = BigRational::one();
    let mut roots: Vec<Root> = Vec::new();
    for (part, multiplicity) in polynomial.squarefree() {
        let mut found = Vec::new();
        if part.at_zero().is_zero() {
            found.push(BigRational::zero());
        }
        let part = part.without_zero();
        for sign in [one.clone(), -&one] {
            let mirrored = part.scaled(&sign);
            found.extend(interval::between_zero_and_one(&mirrored, BITS).into_iter().map(|x| x * &sign));
            if mirrored.value(&one).is_zero() {
                found.push(sign);
            }
        }
        roots.extend(found.into_iter().map(|at| Root { at, multiplicity }));
    }
    roots.sort_by(|a, b| a.at.cmp(&b.at));
    roots
}

/// The sign of a number.
pub(crate) fn sign(x: &BigRational) -> i32 {
    if x.is_zero() {
        0
    } else if x.is_positive() {
        1
    } else {
        -1
    }
}
