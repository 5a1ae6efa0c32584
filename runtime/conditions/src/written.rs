//! Polynomials and rational functions as they are written: coefficients collected, low powers
//! first.

use std::cmp::Reverse;

use liftoff_codegen::algebra::{Series, Symbol, SymbolNames};
use liftoff_codegen::math::Math;
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive};

use crate::algebra::form::Form;
use crate::algebra::polynomial::{Exponents, Polynomial};
use crate::algebra::ring::{Ring, Variable};

/// Writes with the names of one model.
pub(crate) struct Written<'a> {
    pub ring: &'a Ring,
    pub names: &'a dyn SymbolNames,
}

impl Written<'_> {
    /// A rational function in its factors.
    pub fn form(&self, form: &Form) -> Math {
        if form.is_zero() {
            return Math::ZERO;
        }
        let above = self.factors(form.number.numer(), &form.above);
        let below = self.factors(form.number.denom(), &form.below);
        let quotient = match below {
            Math::Number { numerator: 1, denominator: 1 } => above,
            below => above.all_over(below),
        };
        quotient.signed(form.number.is_negative())
    }

    /// Factors with their powers.
    pub fn product(&self, factors: &[(Polynomial, u32)]) -> Math {
        self.factors(&BigInt::one(), factors)
    }

    /// |number| · Π factorᵏ: monomials of parameters, sums, sines and cosines.
    fn factors(&self, number: &BigInt, factors: &[(Polynomial, u32)]) -> Math {
        let mut factors: Vec<&(Polynomial, u32)> = factors.iter().collect();
        factors.sort_by_key(|(factor, _)| self.rank_factor(factor));
        let single = factors.len() == 1 && number.abs().is_one();
        let written = factors.into_iter().map(|(factor, k)| match self.sum(factor) {
            sum @ Math::Sum(_) if !single || *k > 1 => sum.group().power(*k as i32),
            Math::Apply { function, power, argument } => Math::Apply { function, power: power * k, argument },
            other => other.power(*k as i32),
        });
        Math::product([integer(&number.abs())].into_iter().chain(written))
    }

    fn rank_factor(&self, factor: &Polynomial) -> (usize, usize, Reverse<Exponents>) {
        let exponents = factor.leading().map(|(k, _)| k.clone()).unwrap_or_default();
        let single = factor.len() == 1;
        let plain = exponents.iter().position(|&k| k > 0).map(|at| self.ring.variables[at]);
        let class = match (single, plain) {
            (true, Some(Variable::Plain(Symbol::Parameter(i)))) => self.names.rank_parameter(i).into(),
            (true, Some(Variable::Sine(_) | Variable::Cosine(_))) => 12,
            (true, _) => 10,
            (false, _) if self.ring.is_constant(factor) => 1,
            (false, _) => 11,
        };
        (class, factor.len(), Reverse(exponents))
    }

    /// A polynomial: Σ coefficient · sines, cosines and coordinates; a positive term leads where
    /// there is one.
    pub fn sum(&self, polynomial: &Polynomial) -> Math {
        let collected = polynomial.collected(|x| !self.ring.variables[x].is_parameter());
        let mut parts: Vec<(&Exponents, &Polynomial)> = collected.iter().collect();
        parts.sort_by_key(|(k, _)| (k.iter().sum::<u32>(), Reverse((*k).clone())));
        let mut terms: Vec<Math> = parts
            .into_iter()
            .flat_map(|(k, coefficient)| match self.term(k, coefficient) {
                Math::Sum(terms) => terms,
                term => vec![term],
            })
            .collect();
        let led = terms.iter().position(|term| !matches!(term, Math::Minus(_))).unwrap_or(0);
        let first = terms.remove(led);
        terms.insert(0, first);
        Math::sum(terms)
    }

    fn term(&self, exponents: &Exponents, coefficient: &Polynomial) -> Math {
        let waves = self.monomial(exponents);
        if waves.is_empty() {
            return self.parameters(coefficient);
        }
        let negative = all_negative(coefficient);
        let coefficient = if negative { -coefficient } else { coefficient.clone() };
        let number = coefficient.number();
        let common = Polynomial::term(coefficient.monomial(), number.clone());
        let rest = coefficient.divide_exact(&common).unwrap_or_else(|| self.ring.one());
        let sum = match rest.is_one() {
            true => Math::ONE,
            false => self.parameters(&rest).group(),
        };
        let front = [integer(&number), sum].into_iter().filter(|part| *part != Math::ONE);
        let front = front.chain(self.monomial(&common.monomial())).chain(waves);
        Math::product(front).signed(negative)
    }

    /// A sum of monomials of parameters.
    fn parameters(&self, polynomial: &Polynomial) -> Math {
        let mut terms: Vec<(&Exponents, &BigInt)> = polynomial.terms().collect();
        terms.reverse();
        let led = terms.iter().position(|(_, c)| c.is_positive()).unwrap_or(0);
        let first = terms.remove(led);
        terms.insert(0, first);
        Math::sum(terms.into_iter().map(|(k, c)| {
            let factors = [integer(&c.abs())].into_iter().chain(self.monomial(k));
            Math::product(factors).signed(c.is_negative())
        }))
    }

    /// The factors of a monomial, parameters in their order, then the start, then the coordinate.
    fn monomial(&self, exponents: &Exponents) -> Vec<Math> {
        let mut factors: Vec<(Variable, u32)> = self
            .ring
            .variables
            .iter()
            .copied()
            .zip(exponents.iter().copied())
            .filter(|(_, k)| *k > 0)
            .collect();
        factors.sort_by_key(|(variable, _)| match variable {
            Variable::Plain(Symbol::Parameter(i)) => (0, self.names.rank_parameter(*i), *i, None),
            Variable::Plain(symbol) => (1, 0, 0, Some(Reverse(*symbol))),
            Variable::Sine(symbol) | Variable::Cosine(symbol) => (2, 0, 0, Some(Reverse(*symbol))),
        });
        factors.into_iter().map(|(variable, k)| self.variable(variable, k)).collect()
    }

    fn variable(&self, variable: Variable, k: u32) -> Math {
        let symbol = Series::symbol(variable.symbol()).math(self.names);
        let function = match variable {
            Variable::Sine(_) => "sin",
            Variable::Cosine(_) => "cos",
            Variable::Plain(_) => return symbol.power(k as i32),
        };
        Math::Apply { function, power: k, argument: Box::new(symbol) }
    }

    /// `0 = factor`, or the parameter that it gives.
    pub fn zeros(&self, factor: &Polynomial) -> [Math; 2] {
        match crate::algebra::critical::solved(self.ring, factor) {
            Some((at, [above, below])) => {
                let left = self.variable(self.ring.variables[at], 1);
                [left, self.quotient(&above, &below)]
            }
            None => [Math::ZERO, self.sum(factor)],
        }
    }

    /// A quotient of polynomials in parameters.
    pub fn quotient(&self, above: &Polynomial, below: &Polynomial) -> Math {
        if let Some((above, below)) = above.as_constant().zip(below.as_constant()) {
            let number = [above.abs(), below.abs()].map(|c| c.to_u128());
            if let [Some(numerator), Some(denominator)] = number {
                let negative = above.is_negative() != below.is_negative();
                return Math::Number { numerator, denominator }.signed(negative);
            }
        }
        let above = self.sum(above);
        match self.sum(below) {
            Math::Number { numerator: 1, denominator: 1 } => above,
            below => above.over(below),
        }
    }
}

fn all_negative(polynomial: &Polynomial) -> bool {
    polynomial.terms().all(|(_, c)| c.is_negative())
}

/// A number ≥ 0, in words where it is too long for a formula's.
fn integer(n: &BigInt) -> Math {
    n.to_u128().map_or_else(|| Math::Words(n.to_string()), Math::integer)
}
