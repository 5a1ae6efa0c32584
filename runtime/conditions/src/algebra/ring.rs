//! Series as polynomials: `cos(k x) + i sin(k x) = (cos x + i sin x)ᵏ` makes of every wave a
//! polynomial in the sine and the cosine of each symbol in it, between which `sin² + cos² = 1`.

use std::collections::BTreeSet;

use liftoff_codegen::algebra::{Rational, Series, Symbol, Term};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;

use crate::algebra::polynomial::{Exponents, Polynomial};

/// What polynomials are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Variable {
    /// sin of a symbol.
    Sine(Symbol),
    /// cos of a symbol.
    Cosine(Symbol),
    /// A symbol.
    Plain(Symbol),
}

impl Variable {
    pub fn symbol(self) -> Symbol {
        match self {
            Self::Sine(symbol) | Self::Cosine(symbol) | Self::Plain(symbol) => symbol,
        }
    }

    pub fn is_parameter(self) -> bool {
        matches!(self, Self::Plain(symbol) if symbol.is_parameter())
    }
}

/// The variables of a calculation, coordinates first, and what they obey.
#[derive(Clone, Debug)]
pub(crate) struct Ring {
    pub variables: Vec<Variable>,
}

impl Ring {
    /// What these series are polynomials in; the symbols given come first.
    pub fn new<'a>(first: &[Symbol], series: impl Iterator<Item = &'a Series>) -> Self {
        let mut found = BTreeSet::new();
        for (term, _) in series.flat_map(|series| series.terms()) {
            let waves = term.wave.argument.iter();
            found.extend(waves.flat_map(|(s, _)| [Variable::Sine(*s), Variable::Cosine(*s)]));
            found.extend(term.monomial.factors().iter().map(|(s, _)| Variable::Plain(*s)));
        }
        let place = |variable: &Variable| {
            let symbol = variable.symbol();
            (first.iter().position(|s| *s == symbol).unwrap_or(first.len()), symbol, *variable)
        };
        let mut variables: Vec<Variable> = found.into_iter().collect();
        variables.sort_by_key(place);
        Self { variables }
    }

    pub fn len(&self) -> usize {
        self.variables.len()
    }

    pub fn position(&self, variable: Variable) -> Option<usize> {
        self.variables.iter().position(|v| *v == variable)
    }

    pub fn one(&self) -> Polynomial {
        Polynomial::one(self.len())
    }

    fn variable(&self, variable: Variable) -> Polynomial {
        self.position(variable).map_or_else(|| self.one(), |at| Polynomial::variable(self.len(), at))
    }

    /// Numerator and denominator of a series; the denominator is a number times a monomial of
    /// parameters.
    pub fn fraction(&self, series: &Series) -> [Polynomial; 2] {
        let mut number = BigInt::one();
        let mut below: Exponents = vec![0; self.len()];
        for (term, c) in series.terms() {
            number = number.lcm(&BigInt::from(c.denominator()));
            for &(symbol, k) in term.monomial.factors().iter().filter(|(_, k)| *k < 0) {
                if let Some(at) = self.position(Variable::Plain(symbol)) {
                    below[at] = below[at].max(u32::from(k.unsigned_abs()));
                }
            }
        }
        let terms = series.terms().map(|(term, c)| self.term(term, c, &number, &below));
        let sum = terms.fold(Polynomial::zero(self.len()), |sum, term| &sum + &term);
        [self.reduced(&sum), Polynomial::term(below, number)]
    }

    /// number · below · c · term.
    fn term(&self, term: &Term, c: Rational, number: &BigInt, below: &Exponents) -> Polynomial {
        let mut exponents = below.clone();
        for &(symbol, k) in term.monomial.factors() {
            if let Some(at) = self.position(Variable::Plain(symbol)) {
                exponents[at] = exponents[at].saturating_add_signed(k.into());
            }
        }
        let coefficient = number / BigInt::from(c.denominator()) * BigInt::from(c.numerator());
        let [cosine, sine] = self.wave(&term.wave.argument);
        &Polynomial::term(exponents, coefficient) * if term.wave.sine { &sine } else { &cosine }
    }

    /// cos and sin of Σ kᵢ xᵢ.
    fn wave(&self, argument: &[(Symbol, i16)]) -> [Polynomial; 2] {
        let start = [self.one(), Polynomial::zero(self.len())];
        argument.iter().fold(start, |sum, &(symbol, k)| {
            let cosine = self.variable(Variable::Cosine(symbol));
            let sine = self.variable(Variable::Sine(symbol));
            let sine = if k < 0 { -&sine } else { sine };
            (0..k.unsigned_abs())
                .fold(sum, |[c, s], _| [&(&c * &cosine) - &(&s * &sine), &(&c * &sine) + &(&s * &cosine)])
        })
    }

    /// With `cos² = 1 − sin²`, or `sin² = 1 − cos²` where that has fewer terms, symbol by symbol.
    pub fn reduced(&self, polynomial: &Polynomial) -> Polynomial {
        let symbols: BTreeSet<Symbol> = self.variables.iter().map(|v| v.symbol()).collect();
        symbols.into_iter().fold(polynomial.clone(), |polynomial, symbol| {
            let Some([sine, cosine]) = self.circle(symbol) else { return polynomial };
            let by_sine = self.without_square(&polynomial, cosine, sine);
            let by_cosine = self.without_square(&polynomial, sine, cosine);
            if by_cosine.len() < by_sine.len() { by_cosine } else { by_sine }
        })
    }

    /// With `cos² = 1 − sin²` of every symbol: equal functions have one such form.
    pub fn normal(&self, polynomial: &Polynomial) -> Polynomial {
        let symbols: BTreeSet<Symbol> = self.variables.iter().map(|v| v.symbol()).collect();
        symbols.into_iter().fold(polynomial.clone(), |polynomial, symbol| match self.circle(symbol) {
            Some([sine, cosine]) => self.without_square(&polynomial, cosine, sine),
            None => polynomial,
        })
    }

    /// Where sine and cosine of a symbol stand.
    pub fn circle(&self, symbol: Symbol) -> Option<[usize; 2]> {
        Some([self.position(Variable::Sine(symbol))?, self.position(Variable::Cosine(symbol))?])
    }

    /// With `gone² = 1 − kept²`: at most the first power of `gone` stays.
    pub fn without_square(&self, polynomial: &Polynomial, gone: usize, kept: usize) -> Polynomial {
        let kept = Polynomial::variable(self.len(), kept);
        let square = &self.one() - &(&kept * &kept);
        let odd = Polynomial::variable(self.len(), gone);
        let powers = (0..=polynomial.degree(gone)).map(|k| {
            let rest = &polynomial.coefficient(gone, k) * &square.pow(k / 2);
            if k % 2 == 1 { &rest * &odd } else { rest }
        });
        powers.fold(Polynomial::zero(self.len()), |sum, part| &sum + &part)
    }
}
