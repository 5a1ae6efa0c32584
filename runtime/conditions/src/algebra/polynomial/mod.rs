//! Polynomials `Σ c Π xᵢ^kᵢ` with integer coefficients of any size; the variables are known by
//! their positions.

mod division;
mod factors;
mod gcd;
mod ops;
mod resultant;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// The exponent of every variable.
pub(crate) type Exponents = Vec<u32>;

/// A polynomial; those of one calculation have the same variables. No coefficient is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Polynomial {
    variables: usize,
    /// In lexicographic order of the exponents, so that the last term leads.
    terms: BTreeMap<Exponents, BigInt>,
}

impl Polynomial {
    pub fn zero(variables: usize) -> Self {
        Self { variables, terms: BTreeMap::new() }
    }

    pub fn constant(variables: usize, c: BigInt) -> Self {
        Self::term(vec![0; variables], c)
    }

    pub fn one(variables: usize) -> Self {
        Self::constant(variables, BigInt::one())
    }

    pub fn variable(variables: usize, at: usize) -> Self {
        let mut exponents = vec![0; variables];
        exponents[at] = 1;
        Self::term(exponents, BigInt::one())
    }

    pub fn term(exponents: Exponents, c: BigInt) -> Self {
        let mut polynomial = Self::zero(exponents.len());
        polynomial.add_term(exponents, c);
        polynomial
    }

    pub fn add_term(&mut self, exponents: Exponents, c: BigInt) {
        match self.terms.entry(exponents) {
            Entry::Vacant(vacant) if !c.is_zero() => {
                vacant.insert(c);
            }
            Entry::Vacant(_) => {}
            Entry::Occupied(mut occupied) => {
                *occupied.get_mut() += c;
                if occupied.get().is_zero() {
                    occupied.remove();
                }
            }
        }
    }

    pub fn variables(&self) -> usize {
        self.variables
    }

    /// The terms in increasing order.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Exponents, &BigInt)> {
        self.terms.iter()
    }

    pub fn len(&self) -> usize {
        self.terms.len()
    }

    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    pub fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|c| c.is_one())
    }

    /// Its value if no variable occurs.
    pub fn as_constant(&self) -> Option<BigInt> {
        match self.terms.first_key_value() {
            None => Some(BigInt::zero()),
            Some((exponents, c)) => (self.len() == 1 && exponents.iter().all(|&k| k == 0)).then(|| c.clone()),
        }
    }

    pub fn leading(&self) -> Option<(&Exponents, &BigInt)> {
        self.terms.last_key_value()
    }

    pub fn is_negative(&self) -> bool {
        self.leading().is_some_and(|(_, c)| c.is_negative())
    }

    /// The greatest exponent of a variable; 0 of a zero polynomial.
    pub fn degree(&self, variable: usize) -> u32 {
        self.terms.keys().map(|k| k[variable]).max().unwrap_or(0)
    }

    pub fn depends_on(&self, variable: usize) -> bool {
        self.degree(variable) > 0
    }

    /// The first variable that occurs.
    pub fn first_variable(&self) -> Option<usize> {
        (0..self.variables).find(|&x| self.depends_on(x))
    }

    /// What multiplies `variable^exponent`.
    pub fn coefficient(&self, variable: usize, exponent: u32) -> Self {
        let mut part = Self::zero(self.variables);
        for (exponents, c) in self.terms.iter().filter(|(k, _)| k[variable] == exponent) {
            let mut rest = exponents.clone();
            rest[variable] = 0;
            part.terms.insert(rest, c.clone());
        }
        part
    }

    /// The coefficient of the highest power of a variable.
    pub fn leading_coefficient(&self, variable: usize) -> Self {
        self.coefficient(variable, self.degree(variable))
    }

    /// The coefficients by the powers of some variables, which stay in the keys.
    pub fn collected(&self, by: impl Fn(usize) -> bool) -> BTreeMap<Exponents, Self> {
        let mut collected = BTreeMap::new();
        for (exponents, c) in &self.terms {
            let part = |inside: bool| -> Exponents {
                exponents.iter().enumerate().map(|(x, &k)| if by(x) == inside { k } else { 0 }).collect()
            };
            let entry = collected.entry(part(true)).or_insert_with(|| Self::zero(self.variables));
            entry.add_term(part(false), c.clone());
        }
        collected
    }

    /// ∂/∂variable.
    pub fn derivative(&self, variable: usize) -> Self {
        let mut derivative = Self::zero(self.variables);
        for (exponents, c) in self.terms.iter().filter(|(k, _)| k[variable] > 0) {
            let mut lowered = exponents.clone();
            lowered[variable] -= 1;
            derivative.terms.insert(lowered, c * exponents[variable]);
        }
        derivative
    }

    /// A polynomial in place of a variable.
    pub fn substitute(&self, variable: usize, value: &Self) -> Self {
        let powers = (0..=self.degree(variable)).rev();
        powers.fold(Self::zero(self.variables), |sum, k| &(&sum * value) + &self.coefficient(variable, k))
    }
}
