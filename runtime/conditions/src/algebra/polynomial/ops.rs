//! + − · on polynomials.

use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_traits::Zero;

use super::{Exponents, Polynomial};

impl Polynomial {
    fn from_terms(variables: usize, mut terms: BTreeMap<Exponents, BigInt>) -> Self {
        terms.retain(|_, c| !c.is_zero());
        Self { variables, terms }
    }

    pub fn scale(&self, c: &BigInt) -> Self {
        let terms = self.terms.iter().map(|(k, d)| (k.clone(), d * c)).collect();
        Self::from_terms(self.variables, terms)
    }

    pub fn pow(&self, n: u32) -> Self {
        (0..n).fold(Self::one(self.variables), |power, _| &power * self)
    }

    /// self · c · monomial.
    pub(super) fn times_term(&self, exponents: &Exponents, c: &BigInt) -> Self {
        let raised = |k: &Exponents| k.iter().zip(exponents).map(|(a, b)| a + b).collect();
        let terms = self.terms.iter().map(|(k, d)| (raised(k), d * c)).collect();
        Self::from_terms(self.variables, terms)
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let mut terms = self.terms.clone();
        for (exponents, c) in &other.terms {
            *terms.entry(exponents.clone()).or_default() += c;
        }
        Polynomial::from_terms(self.variables, terms)
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &-other
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.scale(&BigInt::from(-1))
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut terms = BTreeMap::new();
        for (a, c) in &self.terms {
            for (b, d) in &other.terms {
                let exponents: Exponents = a.iter().zip(b).map(|(a, b)| a + b).collect();
                *terms.entry(exponents).or_insert_with(BigInt::zero) += c * d;
            }
        }
        Polynomial::from_terms(self.variables, terms)
    }
}
