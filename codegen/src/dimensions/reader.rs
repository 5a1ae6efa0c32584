//! The dimension of an expression, and what its parts demand of each other.

use std::collections::BTreeMap;

use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprMethodCall, Ident, Lit, UnOp};

use super::Dimension;
use super::affine::AffineDimension;
use super::equation::{DimensionEquation, Place, Reason};
use crate::algebra::Rational;
use crate::syntax::{Description, ReadingDeclaration, plain};
use crate::system::whole;

pub(super) const NONE: Dimension = powers(0, 0, 0);
pub(super) const LENGTH: Dimension = powers(1, 0, 0);
const TIME: Dimension = powers(0, 1, 0);
pub(super) const VELOCITY: Dimension = powers(1, -1, 0);
const RATE: Dimension = powers(0, -1, 0);
/// Readings of a point.
const OF_POINTS: [&str; 4] = ["x", "y", "vx", "vy"];

/// Powers of length, time and mass.
pub(super) const fn powers(length: i128, time: i128, mass: i128) -> Dimension {
    [Rational::integer(length), Rational::integer(time), Rational::integer(mass)]
}

/// An expression that is not 0.
#[derive(Clone, Debug)]
struct ExpressionDimension {
    dimension: AffineDimension,
    /// Whether a number in it may have a dimension of its own.
    number: bool,
}

impl ExpressionDimension {
    fn known(dimension: Dimension) -> Self {
        Self { dimension: AffineDimension::known(dimension), number: false }
    }

    fn has_parameters(&self) -> bool {
        !self.dimension.sought.is_empty()
    }

    fn power(&self, exponent: Rational) -> Self {
        Self { dimension: self.dimension.times(exponent), number: self.number }
    }

    /// Its product with a power of another.
    fn times(self, exponent: Rational, other: &Self) -> Self {
        Self {
            dimension: self.dimension.plus(exponent, &other.dimension),
            number: self.number || other.number,
        }
    }
}

/// Expressions while they are read. Of what has every dimension, 0, there is no
/// [`ExpressionDimension`].
pub(super) struct DimensionReader<'d> {
    description: &'d Description,
    constants: BTreeMap<String, Option<ExpressionDimension>>,
    place: Place<'d>,
    /// What was demanded so far.
    pub equations: Vec<DimensionEquation<'d>>,
}

impl<'d> DimensionReader<'d> {
    /// The named constants are read at once.
    pub fn new(description: &'d Description) -> Self {
        let place = Place { what: "constant", owner: None };
        let mut reader = Self { description, constants: BTreeMap::new(), place, equations: Vec::new() };
        for (name, expr) in &description.constants {
            reader.place = Place { what: "the constant", owner: Some(name) };
            let value = reader.infer(expr);
            reader.constants.insert(plain(name), value);
        }
        reader
    }

    /// Demands a dimension of the expression at a place.
    pub fn expect(&mut self, place: Place<'d>, expr: &'d Expr, dimension: Dimension) {
        self.place = place;
        self.need(expr, dimension);
    }

    /// Demands one dimension of two sides, if it is known what all names in them are.
    pub fn compared(&mut self, what: &'static str, owner: &'d Ident, sides: [&'d Expr; 2]) {
        if !sides.iter().all(|side| self.knows(side)) {
            return;
        }
        self.place = Place { what, owner: Some(owner) };
        if let (Some(a), Some(b)) = (self.infer(sides[0]), self.infer(sides[1])) {
            self.sum(a, b, sides[1]);
        }
    }

    fn knows(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Lit(_) => true,
            Expr::Paren(inner) => self.knows(&inner.expr),
            Expr::Unary(unary) => self.knows(&unary.expr),
            Expr::Binary(binary) => self.knows(&binary.left) && self.knows(&binary.right),
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| {
                let is = |other: &Ident| other == name;
                let constant = self.constants.contains_key(&plain(name)) || name == "t" || name == "pi";
                constant || self.description.fields.iter().any(is) || self.coordinate(name).is_some()
            }),
            Expr::Call(call) => match &*call.func {
                Expr::Path(path) if OF_POINTS.iter().any(|name| path.path.is_ident(name)) => true,
                _ => call.args.iter().all(|argument| self.knows(argument)),
            },
            Expr::MethodCall(call) => self.knows(&call.receiver),
            _ => false,
        }
    }

    fn need(&mut self, expr: &'d Expr, needed: Dimension) {
        if let Some(value) = self.infer(expr) {
            let numeric = value.number || !value.has_parameters();
            let zero = value.dimension.plus(-Rational::ONE, &AffineDimension::known(needed));
            self.demand(zero, numeric, expr, Reason::Needed(needed));
        }
    }

    fn demand(&mut self, zero: AffineDimension, numeric: bool, at: &'d Expr, reason: Reason) {
        self.equations.push(DimensionEquation { zero, numeric, at, reason, place: self.place });
    }

    fn infer(&mut self, expr: &'d Expr) -> Option<ExpressionDimension> {
        match expr {
            Expr::Lit(literal) if is_zero(&literal.lit) => None,
            Expr::Paren(inner) => self.infer(&inner.expr),
            Expr::Group(inner) => self.infer(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.infer(&unary.expr),
            Expr::Binary(binary) => self.binary(&binary.left, &binary.op, &binary.right),
            Expr::Path(path) => path.path.get_ident().and_then(|name| self.name(name)),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            _ => Some(ExpressionDimension { dimension: AffineDimension::known(NONE), number: true }),
        }
    }

    fn name(&self, name: &Ident) -> Option<ExpressionDimension> {
        let named = |other: &Ident| other == name;
        if let Some(i) = self.description.fields.iter().position(named) {
            return Some(ExpressionDimension { dimension: AffineDimension::parameter(i), number: false });
        }
        match self.constants.get(&plain(name)) {
            Some(constant) => constant.clone(),
            None if name == "t" => Some(ExpressionDimension::known(TIME)),
            None if name == "v" => {
                Some(ExpressionDimension::known(self.coordinate(name).unwrap_or(VELOCITY)))
            }
            None => Some(ExpressionDimension::known(self.coordinate(name).unwrap_or(NONE))),
        }
    }

    /// The dimension of a declared coordinate.
    pub fn coordinate(&self, name: &Ident) -> Option<Dimension> {
        let declared = self.description.coordinates.iter().find(|coordinate| coordinate.name == *name)?;
        Some(match declared.reading {
            ReadingDeclaration::Angle { .. } => NONE,
            ReadingDeclaration::Position { .. } => LENGTH,
        })
    }

    fn binary(&mut self, left: &'d Expr, op: &BinOp, right: &'d Expr) -> Option<ExpressionDimension> {
        let (a, b) = (self.infer(left), self.infer(right));
        match op {
            BinOp::Mul(_) => Some(a?.times(Rational::ONE, &b?)),
            BinOp::Div(_) => Some(a?.times(-Rational::ONE, &b?)),
            _ => match (a, b) {
                (Some(a), Some(b)) => Some(self.sum(a, b, right)),
                (a, b) => a.or(b),
            },
        }
    }

    /// The sum of two values: like that without a number in it, if it is one of parameters.
    fn sum(
        &mut self,
        a: ExpressionDimension,
        b: ExpressionDimension,
        right: &'d Expr,
    ) -> ExpressionDimension {
        let zero = b.dimension.clone().plus(-Rational::ONE, &a.dimension);
        let number = a.number || b.number;
        let numeric = number || !(a.has_parameters() || b.has_parameters());
        self.demand(zero, numeric, right, Reason::Added(a.dimension.clone()));
        let like = if a.number { b } else { a };
        ExpressionDimension { number: like.number || number && !like.has_parameters(), ..like }
    }

    fn call(&mut self, call: &'d ExprCall) -> Option<ExpressionDimension> {
        let argument = call.args.first()?;
        let Expr::Path(function) = &*call.func else { return None };
        match plain(function.path.get_ident()?).as_str() {
            "x" | "y" => Some(ExpressionDimension::known(LENGTH)),
            "vx" | "vy" => Some(ExpressionDimension::known(VELOCITY)),
            "rate" => {
                let coordinate = match argument {
                    Expr::Path(path) => path.path.get_ident().and_then(|name| self.coordinate(name)),
                    _ => None,
                };
                let length = coordinate == Some(LENGTH);
                Some(ExpressionDimension::known(if length { VELOCITY } else { RATE }))
            }
            "if" => {
                self.condition(argument);
                self.alike(&mut call.args.iter().skip(1))
            }
            "atan2" => {
                self.alike(&mut call.args.iter());
                Some(ExpressionDimension::known(NONE))
            }
            // Its values are numbers, whatever they stand for.
            "table" => {
                self.infer(argument);
                Some(ExpressionDimension { number: true, ..ExpressionDimension::known(NONE) })
            }
            "sign" => {
                self.infer(argument);
                Some(ExpressionDimension::known(NONE))
            }
            "min" | "max" | "clamp" => self.alike(&mut call.args.iter()),
            name => self.function(name, argument),
        }
    }

    /// Alike, as the terms of a sum.
    fn alike(&mut self, values: &mut dyn Iterator<Item = &'d Expr>) -> Option<ExpressionDimension> {
        let first = self.infer(values.next()?);
        values.fold(first, |known, value| match (known, self.infer(value)) {
            (Some(known), Some(other)) => Some(self.sum(known, other, value)),
            (known, other) => known.or(other),
        })
    }

    /// What a condition compares.
    fn condition(&mut self, condition: &'d Expr) {
        match condition {
            Expr::Paren(inner) => self.condition(&inner.expr),
            Expr::Binary(ExprBinary { left, op: BinOp::And(_) | BinOp::Or(_), right, .. }) => {
                self.condition(left);
                self.condition(right);
            }
            comparison => {
                self.infer(comparison);
            }
        }
    }

    fn method(&mut self, call: &'d ExprMethodCall) -> Option<ExpressionDimension> {
        let Some(exponent) = call.args.first() else {
            return self.function(&call.method.to_string(), &call.receiver);
        };
        let base = self.infer(&call.receiver);
        match whole(exponent).ok()? {
            0 => Some(ExpressionDimension::known(NONE)),
            exponent => Some(base?.power(Rational::integer(exponent.into()))),
        }
    }

    fn function(&mut self, name: &str, argument: &'d Expr) -> Option<ExpressionDimension> {
        if name == "sqrt" {
            return Some(self.infer(argument)?.power(Rational::HALF));
        }
        if name == "abs" {
            return self.infer(argument);
        }
        self.need(argument, NONE);
        Some(ExpressionDimension::known(NONE))
    }
}

fn is_zero(literal: &Lit) -> bool {
    match literal {
        Lit::Int(int) => int.base10_parse::<i128>().is_ok_and(|n| n == 0),
        Lit::Float(float) => float.base10_parse::<f64>().is_ok_and(|x| x == 0.0),
        _ => false,
    }
}
