//! Polynomials in one unknown with integer coefficients.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Coefficients from the constant upwards, the last not zero; none of the zero polynomial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Univariate(Vec<BigInt>);

impl Univariate {
    /// What has the roots of a polynomial with rational coefficients: its coefficients over their
    /// content.
    pub fn from_coefficients(coefficients: &[BigRational]) -> Self {
        let common = coefficients.iter().fold(BigInt::one(), |common, c| common.lcm(c.denom()));
        Self::primitive(coefficients.iter().map(|c| c.numer() * (&common / c.denom())).collect())
    }

    /// The coefficients over their greatest common divisor.
    fn primitive(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(BigInt::is_zero) {
            coefficients.pop();
        }
        let content = coefficients.iter().fold(BigInt::zero(), |content, c| content.gcd(c));
        Self(coefficients.into_iter().map(|c| c / &content).collect())
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub fn coefficients(&self) -> &[BigInt] {
        &self.0
    }

    pub fn at_zero(&self) -> BigInt {
        self.0.first().cloned().unwrap_or_default()
    }

    pub fn value(&self, x: &BigRational) -> BigRational {
        self.0.iter().rev().fold(BigRational::zero(), |sum, c| sum * x + BigRational::from(c.clone()))
    }

    /// p(c x), up to a positive number.
    pub fn scaled(&self, c: &BigRational) -> Self {
        let mut power = BigRational::one();
        let scaled = self.0.iter().map(|coefficient| {
            let scaled = &power * BigRational::from(coefficient.clone());
            power *= c;
            scaled
        });
        Self::from_coefficients(&scaled.collect::<Vec<_>>())
    }

    /// xⁿ p(1/x).
    pub fn reversed(&self, degree: usize) -> Self {
        let padding = (degree + 1).saturating_sub(self.0.len());
        let padded = self.0.iter().cloned().chain(std::iter::repeat_n(BigInt::zero(), padding));
        Self::primitive(padded.collect::<Vec<_>>().into_iter().rev().collect())
    }

    /// p over the power of x that divides it.
    pub fn without_zero(&self) -> Self {
        Self(self.0.iter().skip_while(|c| c.is_zero()).cloned().collect())
    }

    /// Divided by (x − root) as often as that divides it, and how often that is.
    pub fn without(&self, root: &BigRational) -> (Self, u32) {
        let mut rest = self.clone();
        let factor = Self(vec![-root.numer().clone(), root.denom().clone()]);
        let mut k = 0;
        while !rest.is_zero() && rest.value(root).is_zero() {
            rest = rest.quotient(&factor);
            k += 1;
        }
        (rest, k)
    }

    fn derivative(&self) -> Self {
        Self(self.0.iter().enumerate().skip(1).map(|(k, c)| c * k).collect())
    }

    /// The factors of each multiplicity, by Yun's algorithm.
    pub fn squarefree(&self) -> Vec<(Self, u32)> {
        let derivative = self.derivative();
        let common = self.gcd(&derivative);
        let (mut b, mut c) = (self.quotient(&common), derivative.quotient(&common));
        let mut parts = Vec::new();
        for k in 1.. {
            if b.degree() == 0 {
                break;
            }
            let d = c.minus(&b.derivative());
            let part = b.gcd(&d);
            (b, c) = (b.quotient(&part), d.quotient(&part));
            if part.degree() > 0 {
                parts.push((part, k));
            }
        }
        parts
    }

    fn minus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let at = |p: &Self, k: usize| p.0.get(k).cloned().unwrap_or_default();
        let mut difference: Vec<BigInt> = (0..length).map(|k| at(self, k) - at(other, k)).collect();
        while difference.last().is_some_and(BigInt::is_zero) {
            difference.pop();
        }
        Self(difference)
    }

    /// The primitive greatest common divisor.
    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (Self::primitive(self.0.clone()), Self::primitive(other.0.clone()));
        while !b.is_zero() {
            let remainder = a.remainder(&b);
            a = b;
            b = remainder;
        }
        a
    }

    /// A primitive multiple of the remainder.
    fn remainder(&self, divisor: &Self) -> Self {
        let mut rest = self.0.clone();
        let Some(leading) = divisor.0.last() else { return self.clone() };
        while rest.len() >= divisor.0.len() {
            let top = rest.last().cloned().unwrap_or_default();
            let shift = rest.len() - divisor.0.len();
            for c in &mut rest {
                *c *= leading;
            }
            for (k, d) in divisor.0.iter().enumerate() {
                rest[shift + k] -= &top * d;
            }
            rest.pop();
        }
        Self::primitive(rest)
    }

    /// self / divisor, which divides it over the rationals with an integer quotient.
    fn quotient(&self, divisor: &Self) -> Self {
        let mut rest = self.0.clone();
        let Some(leading) = divisor.0.last() else { return self.clone() };
        let length = (rest.len() + 1).saturating_sub(divisor.0.len());
        let mut quotient = vec![BigInt::zero(); length];
        for k in (0..length).rev() {
            let c = &rest[k + divisor.0.len() - 1] / leading;
            for (i, d) in divisor.0.iter().enumerate() {
                rest[k + i] -= &c * d;
            }
            quotient[k] = c;
        }
        Self(quotient)
    }
}
