//! Poisson series and their quotients as operations.
//!
//! Terms are grouped by their powers of coordinates and rates; a group is a trigonometric
//! polynomial whose coefficients depend on parameters only. A group of one angle becomes a
//! polynomial in its cosine; cosines that cancel at zero angles go through versed sines.

use std::collections::BTreeMap;

use super::group::{Group, Plan, Product, groups, may_cancel, plan};
use super::polynomial::FactoredPolynomial;
use super::wave::ComputedWaves;
use super::{Id, Program, perfect};
use crate::algebra::{Angle, Quotient, Rational, Series, Symbol};
use crate::motion::{Expression, OpaqueTerm};
use crate::system::{Definition, Function, Operator, System};

/// Lowers series into a program; what it lowers shares its sines and cosines.
pub struct Lowering<'a> {
    pub(super) program: &'a mut Program,
    pub(super) waves: ComputedWaves,
    system: &'a System,
    opaque_terms: &'a [OpaqueTerm],
    defined: BTreeMap<Symbol, Id>,
}

impl<'a> Lowering<'a> {
    /// Prepares to lower `series`: their versed sines decide which angles are halved.
    pub fn new<'s>(
        program: &'a mut Program,
        system: &'a System,
        opaque_terms: &'a [OpaqueTerm],
        series: impl IntoIterator<Item = &'s Series>,
    ) -> Self {
        let mut waves = ComputedWaves::default();
        for group in series.into_iter().filter(|s| may_cancel(s)).flat_map(|s| groups(s).into_values()) {
            match plan(&group) {
                Plan::Polynomial { direction, cosine, sine } if cosine.versed + sine.versed > 0 => {
                    waves.half.extend(direction.iter().map(|&(symbol, _)| symbol));
                }
                Plan::Versed => {
                    let arguments = group.keys().flat_map(|wave| wave.argument.iter());
                    waves.half.extend(arguments.map(|&(symbol, _)| symbol));
                }
                _ => {}
            }
        }
        Self { program, waves, system, opaque_terms, defined: BTreeMap::new() }
    }

    /// The program that is being built.
    pub fn program(&mut self) -> &mut Program {
        self.program
    }

    /// From now on a symbol stands for a value.
    pub fn define(&mut self, symbol: Symbol, value: Id) {
        self.defined.insert(symbol, value);
    }

    /// A parameter, coordinate, rate or acceleration, or what a derived constant is defined as.
    pub fn symbol(&mut self, symbol: Symbol) -> Id {
        if let Some(&value) = self.defined.get(&symbol) {
            return value;
        }
        if let Symbol::Opaque { index, order } = symbol {
            let value = self.expression(&self.opaque_terms[usize::from(index)].orders[usize::from(order)]);
            self.defined.insert(symbol, value);
            return value;
        }
        let definition = match symbol {
            Symbol::Parameter(i) => usize::from(i).checked_sub(self.system.parameters.len()),
            _ => None,
        };
        let value = match definition.map(|i| self.system.constants[i].clone()) {
            None => self.program.input(symbol),
            Some(definition) => self.definition(&definition),
        };
        self.defined.insert(symbol, value);
        value
    }

    fn definition(&mut self, definition: &Definition) -> Id {
        match definition {
            Definition::Sqrt(s) => {
                let square = self.series(s);
                self.program.sqrt(square)
            }
            Definition::Ratio(a, b) => {
                let (a, b) = (self.series(a), self.series(b));
                self.program.div(a, b)
            }
        }
    }

    /// An expression.
    pub fn expression(&mut self, expression: &Expression) -> Id {
        match expression {
            Expression::Value(quotient) => self.quotient(quotient),
            Expression::Angle(angle) => self.angle(angle),
            Expression::Time => self.program.input(Symbol::Time),
            Expression::Apply(function, inner) => {
                if let (Function::Sqrt, Some((factor, root))) = (function, perfect::root(inner)) {
                    return self.magnitude(factor, &root);
                }
                let inner = self.expression(inner);
                self.apply(*function, inner)
            }
            Expression::Join(operator, a, b) => {
                let (a, b) = (self.expression(a), self.expression(b));
                match operator {
                    Operator::Add => self.program.add(a, b),
                    Operator::Subtract => self.program.sub(a, b),
                    Operator::Multiply => self.program.mul(a, b),
                    Operator::Divide => self.program.div(a, b),
                }
            }
        }
    }

    /// √(c r²).
    fn magnitude(&mut self, factor: Rational, root: &Series) -> Id {
        let root = self.series(root);
        let square = self.program.mul(root, root);
        let (magnitude, factor) = (self.program.sqrt(square), self.program.ratio(factor));
        let factor = if self.program.is_one(factor) { factor } else { self.program.sqrt(factor) };
        self.program.mul(factor, magnitude)
    }

    fn apply(&mut self, function: Function, x: Id) -> Id {
        match function {
            Function::Negate => self.program.neg(x),
            Function::Sqrt => self.program.sqrt(x),
            Function::Sin => self.program.sin_cos(x).0,
            Function::Cos => self.program.sin_cos(x).1,
            Function::Tan => {
                let (sin, cos) = self.program.sin_cos(x);
                self.program.div(sin, cos)
            }
            Function::Elementary(function) => self.program.elementary(function, x),
            Function::Power(n) => {
                let power = self.program.power(x, n.unsigned_abs());
                let one = self.program.integer(1);
                if n < 0 { self.program.div(one, power) } else { power }
            }
        }
    }

    /// A series.
    pub fn series(&mut self, series: &Series) -> Id {
        let mut sum = self.program.integer(0);
        for (powers, group) in groups(series) {
            let waves = self.group(&group);
            let powers = self.powers(powers.factors());
            sum = self.program.mul_add(waves, powers, sum);
        }
        sum
    }

    /// A quotient: the numerator times the reciprocals of its factors.
    pub fn quotient(&mut self, quotient: &Quotient) -> Id {
        let mut value = self.series(quotient.numerator());
        for (factor, exponent) in quotient.factors() {
            let inverse = self.reciprocal(factor);
            let inverse = self.program.power(inverse, *exponent);
            value = self.program.mul(value, inverse);
        }
        value
    }

    /// `numerator / denominator` with one division.
    pub fn ratio(&mut self, numerator: &Quotient, denominator: &Quotient) -> Id {
        let (mut above, mut below) = (Series::one(), Series::one());
        for (factor, k) in numerator.factors() {
            let other = denominator.factors().iter().find(|(f, _)| f == factor).map_or(0, |(_, k)| *k);
            below = &below * &factor.pow(k.saturating_sub(other));
        }
        for (factor, k) in denominator.factors() {
            let other = numerator.factors().iter().find(|(f, _)| f == factor).map_or(0, |(_, k)| *k);
            above = &above * &factor.pow(k.saturating_sub(other));
        }
        let (above, below) = (self.series(&above), self.series(&below));
        let (n, d) = (self.series(numerator.numerator()), self.series(denominator.numerator()));
        let (n, d) = (self.program.mul(n, above), self.program.mul(d, below));
        self.program.div(n, d)
    }

    /// An angle, or a length that stands for itself.
    pub fn angle(&mut self, angle: &Angle) -> Id {
        let turns = Rational::new(angle.signed_quarters().into(), 2);
        let (turns, pi) = (self.program.ratio(turns), self.program.pi());
        let mut sum = self.program.mul(turns, pi);
        for &(symbol, k) in angle.terms() {
            let value = self.symbol(symbol);
            let k = self.program.integer(k.into());
            sum = self.program.mul_add(k, value, sum);
        }
        sum
    }

    fn reciprocal(&mut self, factor: &Series) -> Id {
        let value = self.series(factor);
        let one = self.program.integer(1);
        self.program.div(one, value)
    }

    fn group(&mut self, group: &Group) -> Id {
        match plan(group) {
            Plan::Plain => self.plain(group),
            Plan::Versed => self.versed_group(group),
            Plan::Products(products) => self.products(&products),
            Plan::Polynomial { direction, cosine, sine } => {
                let even = self.factored(&direction, &cosine);
                let (sin, _) = self.wave(&direction);
                let odd = self.factored(&direction, &sine);
                self.program.mul_add(odd, sin, even)
            }
        }
    }

    fn plain(&mut self, group: &Group) -> Id {
        let mut sum = self.program.integer(0);
        for (wave, coefficient) in group {
            let coefficient = self.constant(coefficient);
            let (sin, cos) = self.wave(&wave.argument);
            sum = self.program.mul_add(coefficient, if wave.sine { sin } else { cos }, sum);
        }
        sum
    }

    fn products(&mut self, products: &[Product]) -> Id {
        let mut sum = self.program.integer(0);
        for Product { coefficient, factors } in products {
            let coefficient = self.constant(coefficient);
            let [a, b] = factors.each_ref().map(|(argument, sine)| {
                let (sin, cos) = self.wave(argument);
                if *sine { sin } else { cos }
            });
            let product = self.program.mul(a, b);
            sum = self.program.mul_add(coefficient, product, sum);
        }
        sum
    }

    /// `Σ a cos α` with `Σ a = 0` is `−Σ a vers α`.
    fn versed_group(&mut self, group: &Group) -> Id {
        let mut sum = self.program.integer(0);
        for (wave, coefficient) in group.iter().filter(|(wave, _)| !wave.is_one()) {
            let (coefficient, value) = if wave.sine {
                (self.constant(coefficient), self.wave(&wave.argument).0)
            } else {
                (self.constant(&-coefficient), self.versed(&wave.argument))
            };
            sum = self.program.mul_add(coefficient, value, sum);
        }
        sum
    }

    fn factored(&mut self, direction: &[(Symbol, i16)], polynomial: &FactoredPolynomial) -> Id {
        let Some((last, rest)) = polynomial.rest.split_last() else { return self.program.integer(0) };
        let (sin, cos) = self.wave(direction);
        let mut value = self.constant(last);
        let mut gap = 1;
        for coefficient in rest.iter().rev() {
            if coefficient.is_zero() {
                gap += 1;
                continue;
            }
            let power = self.program.power(cos, core::mem::replace(&mut gap, 1));
            let coefficient = self.constant(coefficient);
            value = self.program.mul_add(value, power, coefficient);
        }
        for (base, exponent) in [(cos, polynomial.cosines), (sin, polynomial.sines)] {
            let power = self.program.power(base, exponent);
            value = self.program.mul(value, power);
        }
        if polynomial.versed > 0 {
            let versed = self.versed(direction);
            let power = self.program.power(versed, polynomial.versed);
            value = self.program.mul(value, power);
        }
        value
    }

    /// A coefficient: products of parameters, computed once; of c and −c the one whose first term
    /// is positive.
    fn constant(&mut self, series: &Series) -> Id {
        if series.terms().next().is_some_and(|(_, first)| first.signum() < 0) {
            let positive = self.constant(&-series);
            return self.program.neg(positive);
        }
        let mut sum = self.program.integer(0);
        for (term, coefficient) in series.terms() {
            let product = self.powers(term.monomial.factors());
            let coefficient = self.program.ratio(coefficient);
            let product = self.program.mul(coefficient, product);
            sum = self.program.add(sum, product);
        }
        sum
    }

    fn powers(&mut self, powers: &[(Symbol, i16)]) -> Id {
        let (mut above, mut below) = (self.program.integer(1), self.program.integer(1));
        for &(symbol, exponent) in powers {
            let base = self.symbol(symbol);
            let power = self.program.power(base, exponent.unsigned_abs().into());
            let side = if exponent > 0 { &mut above } else { &mut below };
            *side = self.program.mul(*side, power);
        }
        self.program.div(above, below)
    }
}
