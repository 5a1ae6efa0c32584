//! Taylor series of expressions from those of coordinates, rates, reactions and gaps.

use super::condition::Condition;
use super::environment::{Environment, Variable};
use super::tree::{Expression, Function, Operator};
use crate::numerics::root_isolation::{self, TERMS};
use crate::scalar::{Jet, Real};

/// Σ cₖ θᵏ.
type TermSeries = Jet<f64, TERMS>;

/// Quantities of which a method may provide series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SeriesQuantity {
    /// A coordinate, order 0, or its rate, order 1.
    Coordinate { index: usize, order: usize },
    /// The reaction of a contact.
    Reaction(usize),
    /// The gap of an open contact.
    Gap(usize),
    /// The time.
    Time,
}

/// Writes the first terms of a quantity's series; none if it is not known.
pub(crate) type Source<'a> = &'a dyn Fn(SeriesQuantity, &mut [f64; TERMS]) -> Option<()>;

/// The sides of a condition.
pub(crate) struct Sides {
    difference: [f64; TERMS],
    /// How many of these count; the others are zero.
    length: usize,
    tail: f64,
    size: f64,
    /// The difference at the end of the step.
    end: f64,
}

impl Sides {
    fn from_terms(sides: &[Term; 2]) -> Self {
        let mut difference = sides[0].coefficients();
        match &sides[1] {
            Term::Constant(value) => difference[0] -= value,
            Term::Varying(series) => (0..TERMS).for_each(|k| difference[k] -= series.coefficient(k)),
        }
        let tail = sides.iter().map(Term::tail).sum();
        let size = sides.iter().map(Term::size).fold(0.0, f64::max);
        Self { difference, length: TERMS, tail, size, end: end(&difference) }
    }

    /// Of a series and a constant.
    fn against(mut terms: [f64; TERMS], value: f64) -> Self {
        let (tail, end) = (root_isolation::tail(&terms), end(&terms));
        let size = terms[0].abs().max(end.abs()).max(value.abs());
        terms[0] -= value;
        let length = root_isolation::without_zeros(&terms).len().max(1);
        Self { difference: terms, length, tail, size, end: end - value }
    }

    /// Left side less right side.
    pub(crate) fn difference(&self) -> &[f64] {
        &self.difference[..self.length]
    }

    /// What the terms left out of both sides may sum to; infinite where they do not shrink, and
    /// then nothing that follows from the series is known.
    pub(crate) fn tail(&self) -> f64 {
        self.tail
    }

    /// The larger side at the start and at the end of the step.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// Left side less right side at the end of the step.
    pub(crate) fn end(&self) -> f64 {
        self.end
    }
}

/// The value of a series at the end of the step.
fn end(terms: &[f64; TERMS]) -> f64 {
    let (fours, last) = terms.as_chunks::<4>();
    let sums = fours.iter().fold([0.0; 4], |sums, four| core::array::from_fn(|k| sums[k] + four[k]));
    sums.iter().chain(last).sum()
}

impl Condition {
    /// The sides over a step, if they are made of what is known.
    pub(crate) fn sides(&self, parameters: &[f64], known: Source) -> Option<Sides> {
        if let Some((quantity, value)) = self.against_constant(parameters).and_then(leaf) {
            let mut terms = [0.0; TERMS];
            known(quantity, &mut terms)?;
            return Some(Sides::against(terms, value));
        }
        self.values(&StepEnvironment { parameters, known }).ok().map(|sides| Sides::from_terms(&sides))
    }
}

/// A quantity by itself on the left side.
fn leaf((expression, value): (&Expression, f64)) -> Option<(SeriesQuantity, f64)> {
    match *expression {
        Expression::Coordinate { index, order } => Some((SeriesQuantity::Coordinate { index, order }, value)),
        Expression::Gap(contact) => Some((SeriesQuantity::Gap(contact), value)),
        _ => None,
    }
}

/// A step of a method that has series.
struct StepEnvironment<'a> {
    parameters: &'a [f64],
    known: Source<'a>,
}

/// A part of an expression; what is constant is calculated in numbers.
#[expect(
    clippy::large_enum_variant,
    reason = "a few live at a time, in the loop over steps that allocates nothing"
)]
enum Term {
    Constant(f64),
    Varying(TermSeries),
}

/// The method has no series of a part of the expression.
struct NoSeries;

impl Term {
    fn coefficients(&self) -> [f64; TERMS] {
        match self {
            Self::Constant(value) => core::array::from_fn(|k| if k == 0 { *value } else { 0.0 }),
            Self::Varying(series) => core::array::from_fn(|k| series.coefficient(k)),
        }
    }

    fn tail(&self) -> f64 {
        match self {
            Self::Constant(_) => 0.0,
            Self::Varying(_) => root_isolation::tail(&self.coefficients()),
        }
    }

    /// The larger of its values at both ends of the step.
    fn size(&self) -> f64 {
        match self {
            Self::Constant(value) => value.abs(),
            Self::Varying(_) => {
                let terms = self.coefficients();
                terms[0].abs().max(end(&terms).abs())
            }
        }
    }

    fn series(self) -> TermSeries {
        match self {
            Self::Constant(value) => TermSeries::constant(value),
            Self::Varying(series) => series,
        }
    }
}

impl Environment for StepEnvironment<'_> {
    type Value = Term;
    type Error = NoSeries;

    fn number(&self, x: f64) -> Term {
        Term::Constant(x)
    }

    fn get_value(&self, variable: Variable) -> Result<Term, NoSeries> {
        let known = match variable {
            Variable::Parameter(i) => {
                return self.parameters.get(i).map(|value| Term::Constant(*value)).ok_or(NoSeries);
            }
            Variable::Time => SeriesQuantity::Time,
            Variable::Coordinate { index, order } => SeriesQuantity::Coordinate { index, order },
            Variable::Reaction(contact) => SeriesQuantity::Reaction(contact),
            Variable::Gap(contact) => SeriesQuantity::Gap(contact),
            _ => return Err(NoSeries),
        };
        let mut terms = [0.0; TERMS];
        (self.known)(known, &mut terms).ok_or(NoSeries)?;
        Ok(Term::Varying(TermSeries::new(terms)))
    }

    fn apply(&self, function: Function, x: Term) -> Result<Term, NoSeries> {
        let x = match x {
            Term::Constant(x) => return Ok(Term::Constant(function.apply(x))),
            Term::Varying(x) => x,
        };
        Ok(Term::Varying(match function {
            Function::Negate => -x,
            Function::Sin => x.sin_cos().0,
            Function::Cos => x.sin_cos().1,
            // An exponential may begin as small as 0 and grow beyond all terms.
            Function::Sqrt
            | Function::Tan
            | Function::Abs
            | Function::Exp
            | Function::Log
            | Function::Tanh
            | Function::Atan
            | Function::Sign => return Err(NoSeries),
        }))
    }

    fn join(&self, operator: Operator, a: Term, b: Term) -> Result<Term, NoSeries> {
        Ok(Term::Varying(match (operator, a, b) {
            (_, Term::Constant(a), Term::Constant(b)) => return Ok(Term::Constant(operator.apply(a, b))),
            (Operator::Divide, a, Term::Constant(b)) => a.series() * TermSeries::constant(1.0 / b),
            (Operator::Add, a, b) => a.series() + b.series(),
            (Operator::Subtract, a, b) => a.series() - b.series(),
            (Operator::Multiply, a, b) => a.series() * b.series(),
            _ => return Err(NoSeries),
        }))
    }
}
