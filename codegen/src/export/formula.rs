//! Series, quotients and expressions as formulas of a program, all coefficients exact.

use std::collections::BTreeMap;

use crate::algebra::{Angle, Quotient, Rational, Series, Symbol, Term};
use crate::motion::Expression;
use crate::spline::Spline;
use crate::system::{Elementary, Function, Operator};

/// Columns from which on a sum takes a line for each of its terms.
const WIDE: usize = 100;

/// Writes formulas with the identifiers of symbols. What is longer than a line has line ends
/// between terms.
#[derive(Clone, Debug, Default)]
pub(super) struct Formulas {
    identifiers: BTreeMap<Symbol, String>,
}

impl Formulas {
    /// From now on a symbol has this identifier.
    pub fn name(&mut self, symbol: Symbol, identifier: String) {
        self.identifiers.insert(symbol, identifier);
    }

    /// The identifier of a symbol.
    pub fn symbol(&self, symbol: Symbol) -> &str {
        self.identifiers.get(&symbol).map_or("nan", String::as_str)
    }

    /// A series, term by term.
    pub fn series(&self, series: &Series) -> String {
        sum(series.terms().map(|(term, coefficient)| self.term(term, coefficient)))
    }

    /// Numerator over the factors of the denominator.
    pub fn quotient(&self, quotient: &Quotient) -> String {
        let numerator = self.series(quotient.numerator());
        if quotient.factors().is_empty() {
            return numerator;
        }
        let factor = |(factor, exponent): &(Series, u32)| match exponent {
            1 => format!("({})", self.series(factor)),
            k => format!("({})**{k}", self.series(factor)),
        };
        let factors: Vec<String> = quotient.factors().iter().map(factor).collect();
        match &factors[..] {
            [one] => format!("({numerator})/{one}"),
            factors => format!("({numerator})/({})", factors.join("*")),
        }
    }

    /// An angle: multiples of symbols and quarter turns.
    pub fn angle(&self, angle: &Angle) -> String {
        let quarters = match angle.quarter_turns() {
            3 => -1,
            quarters => i128::from(quarters),
        };
        let turn = (quarters != 0).then(|| multiple(Rational::new(quarters, 2), "pi"));
        sum(self.multiples(angle.terms()).chain(turn))
    }

    /// An expression that is no series.
    pub fn expression(&self, expression: &Expression) -> String {
        match expression {
            Expression::Value(quotient) => self.quotient(quotient),
            Expression::Angle(angle) => self.angle(angle),
            Expression::Time => self.symbol(Symbol::Time).to_owned(),
            Expression::Apply(function, x) => applied(*function, &self.expression(x)),
            Expression::Join(operator, a, b) => {
                let sign = match operator {
                    Operator::Add => '+',
                    Operator::Subtract => '-',
                    Operator::Multiply => '*',
                    Operator::Divide => '/',
                };
                format!("({}) {sign} ({})", self.expression(a), self.expression(b))
            }
        }
    }

    fn term(&self, term: &Term, coefficient: Rational) -> String {
        let powers = term.monomial.factors();
        let raised = |symbol: Symbol, k: u16| match k {
            1 => self.symbol(symbol).to_owned(),
            k => format!("{}**{k}", self.symbol(symbol)),
        };
        let side = |positive: bool| {
            let side = powers.iter().filter(move |(_, k)| (*k > 0) == positive);
            side.map(|&(symbol, k)| raised(symbol, k.unsigned_abs()))
        };
        let wave = (!term.wave.is_one()).then(|| {
            let function = if term.wave.sine { "sin" } else { "cos" };
            format!("{function}({})", sum(self.multiples(&term.wave.argument)))
        });
        let above: Vec<String> = side(true).chain(wave).collect();
        let above = multiple(coefficient, &above.join("*"));
        side(false).fold(above, |text, factor| format!("{text}/{factor}"))
    }

    fn multiples(&self, multiples: &[(Symbol, i16)]) -> impl Iterator<Item = String> {
        multiples.iter().map(|&(symbol, k)| multiple(Rational::integer(k.into()), self.symbol(symbol)))
    }
}

/// A number times what is a product, or 1 where it is empty.
fn multiple(number: Rational, product: &str) -> String {
    if number.signum() < 0 {
        return format!("-{}", multiple(-number, product));
    }
    match (number.numerator(), number.denominator(), product) {
        (1, 1, product) if !product.is_empty() => product.to_owned(),
        (p, 1, "") => p.to_string(),
        (p, 1, product) => format!("{p}*{product}"),
        (p, q, "") => format!("Rational({p}, {q})"),
        (p, q, product) => format!("Rational({p}, {q})*{product}"),
    }
}

/// Terms, one a line where they are long; of none it is 0.
fn sum(terms: impl Iterator<Item = String>) -> String {
    let terms: Vec<String> = terms.collect();
    let wide = terms.iter().map(|term| term.len() + 3).sum::<usize>() > WIDE;
    let between = if wide { "\n    " } else { " " };
    let mut sum = String::new();
    for term in terms {
        match (sum.is_empty(), term.strip_prefix('-')) {
            (true, _) => sum = term,
            (false, Some(term)) => sum += &format!("{between}- {term}"),
            (false, None) => sum += &format!("{between}+ {term}"),
        }
    }
    if sum.is_empty() { "0".to_owned() } else { sum }
}

fn applied(function: Function, x: &str) -> String {
    match function {
        Function::Negate => format!("-({x})"),
        Function::Sqrt => format!("sqrt({x})"),
        Function::Sin => format!("sin({x})"),
        Function::Cos => format!("cos({x})"),
        Function::Tan => format!("tan({x})"),
        Function::Elementary(Elementary::Table(table)) => pieces(&table, x),
        Function::Elementary(function) => format!("sympy.{}({x})", function.name()),
        Function::Power(n) => format!("({x})**{}", exponent(n.into())),
    }
}

/// The value of a table, piece by piece.
fn pieces(table: &Spline, x: &str) -> String {
    let piece = |(end, text): (Option<f64>, String)| match end {
        Some(end) => format!("({text}, ({x}) < {end:?}), "),
        None => format!("({text}, True)"),
    };
    format!("sympy.Piecewise({})", table.write_pieces(x).into_iter().map(piece).collect::<String>())
}

fn exponent(n: i64) -> String {
    if n < 0 { format!("({n})") } else { n.to_string() }
}
