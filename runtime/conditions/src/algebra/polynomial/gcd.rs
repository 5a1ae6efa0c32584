//! Greatest common divisors by primitive remainder sequences, variable by variable (Knuth, *The Art
//! of Computer Programming*, vol. 2, 4.6.1).

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Zero;

use super::{Exponents, Polynomial};

impl Polynomial {
    /// The greatest common divisor, its leading coefficient positive; 0 of two zeros.
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return (self + other).positive();
        }
        let Some(variable) = self.first_variable().into_iter().chain(other.first_variable()).min() else {
            let number = self.number().gcd(&other.number());
            return Self::constant(self.variables, number);
        };
        match (self.depends_on(variable), other.depends_on(variable)) {
            (true, false) => other.gcd(&self.content(variable)),
            (false, true) => self.gcd(&other.content(variable)),
            _ => self.gcd_in(other, variable),
        }
    }

    fn gcd_in(&self, other: &Self, variable: usize) -> Self {
        let (own, theirs) = (self.content(variable), other.content(variable));
        let (mut a, mut b) = (self.over(&own), other.over(&theirs));
        if a.degree(variable) < b.degree(variable) {
            std::mem::swap(&mut a, &mut b);
        }
        while !b.is_zero() {
            let remainder = a.pseudo_remainder(&b, variable);
            a = b;
            b = remainder.over(&remainder.content(variable));
        }
        let common = own.gcd(&theirs);
        if a.depends_on(variable) { (&common * &a).positive() } else { common }
    }

    /// The greatest common divisor of the coefficients in one variable; 1 of zero, so that it may
    /// be divided by.
    pub fn content(&self, variable: usize) -> Self {
        self.common(|x| x == variable)
    }

    /// The greatest common divisor of the coefficients by the powers of some variables; 1 of zero.
    pub fn common(&self, by: impl Fn(usize) -> bool) -> Self {
        let mut content = Self::zero(self.variables);
        for coefficient in self.collected(by).values() {
            content = content.gcd(coefficient);
            if content.is_one() {
                break;
            }
        }
        if content.is_zero() { Self::one(self.variables) } else { content }
    }

    /// The greatest integer that divides all coefficients; 0 of zero.
    pub fn number(&self) -> BigInt {
        self.terms.values().fold(BigInt::zero(), |number, c| number.gcd(c))
    }

    /// The greatest monomial that divides all terms.
    pub fn monomial(&self) -> Exponents {
        let mut terms = self.terms.keys();
        let first = terms.next().cloned().unwrap_or_else(|| vec![0; self.variables]);
        terms.fold(first, |least, k| least.iter().zip(k).map(|(a, b)| *a.min(b)).collect())
    }

    /// Divided by what divides it.
    pub(super) fn over(&self, divisor: &Self) -> Self {
        self.divide_exact(divisor).unwrap_or_else(|| self.clone())
    }

    /// Itself or its opposite, the leading coefficient positive.
    pub fn positive(self) -> Self {
        if self.is_negative() { -&self } else { self }
    }
}
