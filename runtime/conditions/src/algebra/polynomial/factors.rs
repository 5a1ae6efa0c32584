//! Factors as far as greatest common divisors tell them apart: contents, monomials, squarefree
//! parts (Yun's algorithm).

use num_bigint::BigInt;

use super::Polynomial;

/// number · Π factorᵏ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Factors {
    pub number: BigInt,
    /// Squarefree, without common factors, leading coefficients positive, each with its exponent.
    pub factors: Vec<(Polynomial, u32)>,
}

impl Polynomial {
    /// Its factors; those of equal exponent stay together unless a variable tells them apart.
    pub fn factors(&self) -> Factors {
        if self.is_zero() {
            return Factors { number: 0.into(), factors: Vec::new() };
        }
        let sign = if self.is_negative() { -1 } else { 1 };
        let number: BigInt = self.number() * sign;
        let mut rest = self.over(&Self::constant(self.variables, number.clone()));
        let mut factors = Vec::new();
        for (x, k) in self.monomial().into_iter().enumerate().filter(|(_, k)| *k > 0) {
            let variable = Self::variable(self.variables, x);
            rest = rest.over(&variable.pow(k));
            factors.push((variable, k));
        }
        rest.split(0, &mut factors);
        Factors { number, factors }
    }

    /// The factors of a primitive polynomial: first what is free of a variable, then the rest of
    /// it.
    fn split(&self, variable: usize, factors: &mut Vec<(Self, u32)>) {
        if self.is_one() || variable >= self.variables {
            return;
        }
        if !self.depends_on(variable) {
            return self.split(variable + 1, factors);
        }
        let content = self.content(variable);
        content.split(variable + 1, factors);
        let parts = self.over(&content).squarefree(variable).into_iter();
        factors.extend(
            parts.flat_map(|(part, k)| part.split_contents(variable).into_iter().map(move |f| (f, k))),
        );
    }

    /// Yun's algorithm: `self = Π pᵢⁱ` with squarefree pᵢ, all of them with the variable.
    pub(crate) fn squarefree(&self, variable: usize) -> Vec<(Self, u32)> {
        let derivative = self.derivative(variable);
        let common = self.gcd(&derivative);
        let (mut b, mut c) = (self.over(&common), derivative.over(&common));
        let mut parts = Vec::new();
        for k in 1.. {
            if !b.depends_on(variable) {
                break;
            }
            let d = &c - &b.derivative(variable);
            let part = b.gcd(&d);
            b = b.over(&part);
            c = d.over(&part);
            if part.depends_on(variable) {
                parts.push((part, k));
            }
        }
        parts
    }

    /// Splits off what is free of each other variable.
    fn split_contents(self, from: usize) -> Vec<Self> {
        let other = (from + 1..self.variables).find_map(|x| {
            let content = self.content(x);
            (self.depends_on(x) && content.as_constant().is_none()).then_some(content)
        });
        match other {
            None => vec![self],
            Some(content) => {
                let rest = self.over(&content);
                [content, rest].into_iter().flat_map(|part| part.split_contents(from)).collect()
            }
        }
    }
}
