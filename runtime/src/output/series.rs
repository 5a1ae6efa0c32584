//! Taylor series of expressions from those of coordinates, rates, reactions and gaps.

use super::condition::Condition;
use super::expression::{Expression, Function, Operator};
use crate::guard::{self, TERMS};
use crate::scalar::{Jet, Real};

/// Σ cₖ θᵏ.
type Series = Jet<f64, TERMS>;

/// What a method may have the series of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Known {
    /// A coordinate, order 0, or its rate, order 1.
    Coordinate { index: usize, order: usize },
    /// The reaction of a contact.
    Reaction(usize),
    /// The gap of an open contact.
    Gap(usize),
    /// The time.
    Time,
}

/// Writes the first terms of what it knows.
pub(crate) type Source<'a> = &'a dyn Fn(Known, &mut [f64; TERMS]) -> Option<()>;

/// The sides of a condition.
pub(crate) struct Sides {
    left: Series,
    right: Series,
    difference: [f64; TERMS],
}

impl Sides {
    /// Left side less right side.
    pub(crate) fn difference(&self) -> &[f64; TERMS] {
        &self.difference
    }

    /// What the terms left out of both sides may sum to; infinite where they do not shrink, and then nothing that follows from
    /// the series is known.
    pub(crate) fn tail(&self) -> f64 {
        let of = |side: &Series| guard::tail(&core::array::from_fn::<_, TERMS, _>(|k| side.coefficient(k)));
        of(&self.left) + of(&self.right)
    }

    /// The larger side at the start and at the end of the step.
    pub(crate) fn size(&self) -> f64 {
        let end = |side: &Series| (0..TERMS).map(|k| side.coefficient(k)).sum::<f64>();
        let ends = [&self.left, &self.right].map(|side| side.coefficient(0).abs().max(end(side).abs()));
        ends[0].max(ends[1])
    }
}

impl Condition {
    /// The sides over a step, if they are made of what is known.
    pub(crate) fn sides(&self, parameters: &[f64], known: Source) -> Option<Sides> {
        let left = self.left.series(parameters, known)?;
        let right = self.right.series(parameters, known)?;
        let difference = left - right;
        Some(Sides { left, right, difference: core::array::from_fn(|k| difference.coefficient(k)) })
    }
}

impl Expression {
    fn series(&self, parameters: &[f64], known: Source) -> Option<Series> {
        let of = |x: &Self| x.series(parameters, known);
        let read = |what| {
            let mut terms = [0.0; TERMS];
            known(what, &mut terms)?;
            Some(Series::new(terms))
        };
        if let Some(value) = self.constant(parameters) {
            return Some(Series::constant(value));
        }
        Some(match self {
            Self::Time => read(Known::Time)?,
            Self::Coordinate { index, order } => read(Known::Coordinate { index: *index, order: *order })?,
            Self::Reaction { contact, share } => {
                read(Known::Reaction(*contact))? * Series::constant(1.0 / share)
            }
            Self::Gap(contact) => read(Known::Gap(*contact))?,
            Self::Apply(Function::Negate, x) => -of(x)?,
            Self::Apply(Function::Sin, x) => of(x)?.sin_cos().0,
            Self::Apply(Function::Cos, x) => of(x)?.sin_cos().1,
            Self::Join(Operator::Add, a, b) => of(a)? + of(b)?,
            Self::Join(Operator::Subtract, a, b) => of(a)? - of(b)?,
            Self::Join(Operator::Multiply, a, b) => of(a)? * of(b)?,
            Self::Join(Operator::Divide, a, b) => of(a)? * Series::constant(1.0 / b.constant(parameters)?),
            _ => return None,
        })
    }
}
