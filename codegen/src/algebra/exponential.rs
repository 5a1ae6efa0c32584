//! A series as a Laurent polynomial: cos x = (z + z⁻¹)/2, sin x = (z − z⁻¹)/2i with z = e^{ix},
//! one z for every symbol of an argument. In this form a product is a product, so division can work
//! by leading terms.

use super::gaussian::Gaussian;
use super::product::push_wave;
use super::{Monomial, Powers, Rational, Series};
use std::collections::BTreeMap;

/// Exponents of the symbols, exponents of their z.
pub(super) type Exponents = (Monomial, Powers);

/// Σ coefficient · monomial · z^k; no coefficient is zero.
pub(super) type Exponential = BTreeMap<Exponents, Gaussian>;

impl Series {
    /// The exponential form; `None` for overflow.
    pub(super) fn to_exponential(&self) -> Option<Exponential> {
        if self.is_overflow() {
            return None;
        }
        let mut sum = Exponential::new();
        for (term, c) in self.entries() {
            let k = &term.wave.argument;
            if k.is_empty() {
                let c = Gaussian::new(*c, Rational::ZERO);
                sum.insert((term.monomial.clone(), Powers::ZERO), c);
                continue;
            }
            let half = *c * Rational::HALF;
            let (positive, negative) = if term.wave.sine {
                (Gaussian::new(Rational::ZERO, -half), Gaussian::new(Rational::ZERO, half))
            } else {
                (Gaussian::new(half, Rational::ZERO), Gaussian::new(half, Rational::ZERO))
            };
            subtract(&mut sum, (term.monomial.clone(), k.clone()), Gaussian::ZERO - positive);
            subtract(&mut sum, (term.monomial.clone(), k.times(-1)?), Gaussian::ZERO - negative);
        }
        Some(sum)
    }

    /// Back from the exponential form of a real series:
    /// c z^k + c̄ z⁻ᵏ = 2 re c · cos(k·x) − 2 im c · sin(k·x).
    pub(super) fn from_exponential(exponential: &Exponential) -> Self {
        Self::one().collect(|sum| {
            for ((monomial, k), c) in exponential {
                match k.first() {
                    None => push_wave(sum, monomial, false, Some(Powers::ZERO), c.re),
                    Some(&(_, first)) if first.is_positive() => {
                        push_wave(sum, monomial, false, Some(k.clone()), c.re + c.re);
                        push_wave(sum, monomial, true, Some(k.clone()), -(c.im + c.im));
                    }
                    Some(_) => {}
                }
            }
        })
    }
}

/// sum −= c · term.
pub(super) fn subtract(sum: &mut Exponential, term: Exponents, c: Gaussian) {
    let entry = sum.entry(term);
    match entry {
        std::collections::btree_map::Entry::Vacant(vacant) => {
            vacant.insert(Gaussian::ZERO - c);
        }
        std::collections::btree_map::Entry::Occupied(mut occupied) => {
            let difference = *occupied.get() - c;
            if difference.is_zero() {
                occupied.remove();
            } else {
                occupied.insert(difference);
            }
        }
    }
}
