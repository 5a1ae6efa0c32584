//! Expressions of time and motion, for loads and drives, as text and as the oracle's data.

use super::assemble::Places;
use super::quantity::Quantity;
use super::spec::{Declared, Spec};
use crate::oracle::{Coordinate, Formula};

/// An expression of time, declared coordinates and positions of points.
#[derive(Clone, Debug)]
pub enum Expression {
    Number(Quantity),
    Time,
    /// A declared coordinate, by index, or its rate.
    Coordinate(usize, bool),
    /// The position of a point along an axis, or its rate.
    Position(String, usize, bool),
    Sum(Box<Expression>, Box<Expression>),
    Difference(Box<Expression>, Box<Expression>),
    Product(Box<Expression>, Box<Expression>),
    /// a / b.
    Quotient(Box<Expression>, Box<Expression>),
    Square(Box<Expression>),
    Sqrt(Box<Expression>),
    Sin(Box<Expression>),
    Cos(Box<Expression>),
    Tan(Box<Expression>),
    Exp(Box<Expression>),
    Log(Box<Expression>),
    Tanh(Box<Expression>),
    Atan(Box<Expression>),
    Min(Box<Expression>, Box<Expression>),
    Max(Box<Expression>, Box<Expression>),
}

use Expression::{
    Atan, Coordinate as Q, Cos, Difference, Exp, Log, Max, Min, Number, Position, Product, Quotient, Sin,
    Sqrt, Square, Sum, Tan, Tanh, Time,
};

impl Expression {
    pub fn literal(hundredths: i32) -> Self {
        Number(Quantity::literal(hundredths))
    }

    pub fn plus(self, other: Self) -> Self {
        Sum(Box::new(self), Box::new(other))
    }

    pub fn times(self, other: Self) -> Self {
        Product(Box::new(self), Box::new(other))
    }

    pub fn sin(self) -> Self {
        Sin(Box::new(self))
    }

    /// As it is declared, in as many parentheses as it takes.
    pub fn text(&self, spec: &Spec) -> String {
        let of = |inner: &Self| inner.text(spec);
        match self {
            Number(quantity) => format!("({})", quantity.text()),
            Time => "t".into(),
            Q(index, rate) => {
                let (Declared::Angle { name, .. } | Declared::Position { name, .. }) =
                    &spec.coordinates[*index];
                if *rate { format!("rate({name})") } else { name.clone() }
            }
            Position(point, axis, rate) => {
                format!("{}({point})", [["x", "y"], ["vx", "vy"]][usize::from(*rate)][*axis])
            }
            Sum(a, b) => format!("({} + {})", of(a), of(b)),
            Difference(a, b) => format!("({} - {})", of(a), of(b)),
            Product(a, b) => format!("{} * {}", of(a), of(b)),
            Quotient(a, b) => format!("({} / ({}))", of(a), of(b)),
            Square(a) => format!("({}).powi(2)", of(a)),
            Sqrt(a) => format!("sqrt({})", of(a)),
            Sin(a) => format!("sin({})", of(a)),
            Cos(a) => format!("cos({})", of(a)),
            Tan(a) => format!("tan({})", of(a)),
            Exp(a) => format!("exp({})", of(a)),
            Log(a) => format!("log({})", of(a)),
            Tanh(a) => format!("tanh({})", of(a)),
            Atan(a) => format!("atan({})", of(a)),
            Min(a, b) => format!("min({}, {})", of(a), of(b)),
            Max(a, b) => format!("max({}, {})", of(a), of(b)),
        }
    }

    /// The same for the oracle.
    pub fn formula(&self, spec: &Spec, places: &Places) -> Formula {
        let of = |inner: &Self| Box::new(inner.formula(spec, places));
        let read = |coordinate: Coordinate, rate: bool| match rate {
            true => Formula::Rate(coordinate),
            false => Formula::Value(coordinate),
        };
        let product = Formula::Product;
        let number = |x: f64| Box::new(Formula::Constant(x));
        // ½ (a + b ± |a − b|).
        let extreme = |sign: f64, a: &Self, b: &Self| {
            let difference = Formula::Sum(of(a), Box::new(product(number(-1.0), of(b))));
            let distance = product(number(sign), Box::new(Formula::Abs(Box::new(difference))));
            let sum = Formula::Sum(Box::new(Formula::Sum(of(a), of(b))), Box::new(distance));
            product(number(0.5), Box::new(sum))
        };
        match self {
            Number(quantity) => Formula::Constant(quantity.value),
            Time => Formula::Time,
            Q(index, rate) => {
                read(super::assemble::coordinate(spec, &spec.coordinates[*index], places), *rate)
            }
            Position(point, axis, rate) => {
                read(Coordinate::Position { at: places[point], axis: *axis, sign: 1.0 }, *rate)
            }
            Sum(a, b) => Formula::Sum(of(a), of(b)),
            Difference(a, b) => {
                Formula::Sum(of(a), Box::new(product(Box::new(Formula::Constant(-1.0)), of(b))))
            }
            Product(a, b) => product(of(a), of(b)),
            Quotient(a, b) => product(of(a), Box::new(Formula::Inverse(of(b)))),
            Square(a) => product(of(a), of(a)),
            Sqrt(a) => Formula::Sqrt(of(a)),
            Sin(a) => Formula::Sin(of(a)),
            Cos(a) => Formula::Cos(of(a)),
            Exp(a) => Formula::Exp(of(a)),
            Log(a) => Formula::Log(of(a)),
            Tanh(a) => Formula::Tanh(of(a)),
            Atan(a) => Formula::Atan(of(a)),
            Min(a, b) => extreme(-1.0, a, b),
            Max(a, b) => extreme(1.0, a, b),
            Tan(a) => product(
                Box::new(Formula::Sin(of(a))),
                Box::new(Formula::Inverse(Box::new(Formula::Cos(of(a))))),
            ),
        }
    }
}
