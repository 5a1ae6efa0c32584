//! Trigonometric polynomials of one angle as `P(c) + s R(c)`, `c = cos α`, `s = sin α`, by
//! `cos kα = T_k(c)` and `sin kα = s U_{k−1}(c)`; their zeros at `α = 0` and `π` are split off
//! exactly, `1 − c² = s²` and `1 − c = vers α`, so that no digits cancel there.

use crate::algebra::{Rational, Series};

/// A polynomial in the cosine: coefficients (functions of parameters) from the constant upwards.
#[derive(Clone, Default, Debug)]
pub(crate) struct Polynomial(Vec<Series>);

/// `s^sines · vers^versed · c^cosines · rest(c)`.
#[derive(Clone, Debug)]
pub(super) struct FactoredPolynomial {
    pub sines: u32,
    pub versed: u32,
    pub cosines: u32,
    pub rest: Vec<Series>,
}

impl Polynomial {
    /// Adds `coefficient · T_k`.
    pub(crate) fn add_first_kind(&mut self, k: usize, coefficient: &Series) {
        self.add(&chebyshev(k, 1), coefficient);
    }

    /// Adds `coefficient · U_k`.
    pub(crate) fn add_second_kind(&mut self, k: usize, coefficient: &Series) {
        self.add(&chebyshev(k, 2), coefficient);
    }

    fn add(&mut self, numbers: &[i128], coefficient: &Series) {
        self.0.resize(self.0.len().max(numbers.len()), Series::zero());
        for (entry, &number) in self.0.iter_mut().zip(numbers) {
            *entry += coefficient.scale(Rational::integer(number));
        }
        while self.0.last().is_some_and(Series::is_zero) {
            self.0.pop();
        }
    }

    /// From the constant upwards.
    pub(crate) fn coefficients(&self) -> &[Series] {
        &self.0
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Splits off the factors that vanish at `c = 0`, at `c = ±1` together, then at `c = 1`.
    pub(super) fn factored(self) -> FactoredPolynomial {
        let cosines = self.0.iter().take_while(|p| p.is_zero()).count();
        let rest = self.0[cosines..].to_vec();
        let mut factored = FactoredPolynomial { sines: 0, versed: 0, cosines: cosines as u32, rest };
        while factored.rest.len() > 2 && vanishes(&factored.rest, 1) && vanishes(&factored.rest, -1) {
            factored.rest = divided(&divided(&factored.rest, 1), -1);
            factored.sines += 2;
        }
        while factored.rest.len() > 1 && vanishes(&factored.rest, 1) {
            factored.rest = divided(&factored.rest, 1);
            factored.versed += 1;
        }
        factored
    }
}

fn vanishes(polynomial: &[Series], at: i64) -> bool {
    let sign = |k: usize| if k % 2 == 1 { Rational::from(at) } else { Rational::ONE };
    polynomial.iter().enumerate().map(|(k, p)| p.scale(sign(k))).sum::<Series>().is_zero()
}

/// Exact division by `1 − c` for a root at 1, by `1 + c` for a root at −1.
fn divided(polynomial: &[Series], root: i64) -> Vec<Series> {
    let mut quotient = vec![Series::zero(); polynomial.len() - 1];
    let mut carry = Series::zero();
    for k in (0..quotient.len()).rev() {
        carry = &polynomial[k + 1] + &carry.scale(Rational::from(root));
        quotient[k] = carry.scale(Rational::from(-root));
    }
    quotient
}

/// Coefficients of T_k (`kind` 1: `T₁ = c`) or U_k (`kind` 2: `U₁ = 2c`).
fn chebyshev(k: usize, kind: i128) -> Vec<i128> {
    let (mut now, mut next) = (vec![1], vec![0, kind]);
    for _ in 0..k {
        let mut after: Vec<i128> = core::iter::once(0).chain(next.iter().map(|x| 2 * x)).collect();
        after.iter_mut().zip(&now).for_each(|(a, b)| *a -= b);
        now = core::mem::replace(&mut next, after);
    }
    now
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(series: &[Series]) -> Vec<Rational> {
        series.iter().map(|s| s.as_constant().unwrap()).collect()
    }

    #[test]
    fn one_minus_cosine_cubed_has_a_single_versed_factor() {
        let mut p = Polynomial::default();
        p.add_first_kind(0, &Series::integer(4));
        p.add_first_kind(1, &Series::integer(-3));
        p.add_first_kind(3, &Series::integer(-1));
        let factored = p.factored();
        assert_eq!((factored.sines, factored.versed), (0, 1));
        assert_eq!(numbers(&factored.rest), [4, 4, 4].map(Rational::from));
    }

    #[test]
    fn one_minus_double_cosine_is_a_sine_squared() {
        let mut p = Polynomial::default();
        p.add_first_kind(0, &Series::one());
        p.add_first_kind(2, &Series::integer(-1));
        let factored = p.factored();
        assert_eq!((factored.sines, factored.versed), (2, 0));
        assert_eq!(numbers(&factored.rest), [Rational::from(2)]);
    }
}
