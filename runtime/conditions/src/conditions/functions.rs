//! An energy level as rational functions, and what follows from them.

use liftoff_codegen::algebra::{Quotient, Series, Symbol, SymbolNames};
use liftoff_codegen::math::{Equation, Math};

use super::{Coincidence, Condition, Request};
use crate::algebra::critical::{Pair, double_roots};
use crate::algebra::form::Form;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::error::ConditionError;
use crate::level::Level;
use crate::numeric::chart::Place;
use crate::numeric::values::Values;
use crate::numeric::zeros::{Numbers, OnLevel, Reaction};
use crate::phase::Named;
use crate::written::Written;

/// The level as rational functions.
pub(super) struct Functions<'a> {
    named: &'a Named<'a>,
    pub level: &'a Level,
    pub ring: Ring,
    rate_squared: Form,
    acceleration: Form,
    pub reactions: Vec<(usize, Form)>,
}

impl<'a> Functions<'a> {
    pub fn new(named: &'a Named<'a>, level: &'a Level) -> Self {
        let quotients = [&level.rate_squared, &level.acceleration];
        let quotients = quotients.into_iter().chain(level.reactions.iter().map(|(_, reaction)| reaction));
        let series = quotients.flat_map(|q| q.factors().iter().map(|(f, _)| f).chain([q.numerator()]));
        let ring = Ring::new(&[level.coordinate, level.start], series);
        Self {
            named,
            level,
            rate_squared: Form::from_quotient(&ring, &level.rate_squared),
            acceleration: Form::from_quotient(&ring, &level.acceleration),
            reactions: level.reactions.iter().map(|(row, r)| (*row, Form::from_quotient(&ring, r))).collect(),
            ring,
        }
    }

    fn written(&self) -> Written<'_> {
        Written { ring: &self.ring, names: self.named }
    }

    /// The coordinate or its derivative of this order.
    pub fn symbol(&self, order: u8) -> Math {
        let Symbol::Coordinate { index, .. } = self.level.coordinate else { return Math::ONE };
        Series::symbol(Symbol::Coordinate { index, order }).math(self.named)
    }

    pub fn motion(&self) -> Vec<Equation> {
        vec![
            Equation::new(self.symbol(1).power(2), self.written().form(&self.rate_squared)),
            Equation::new(self.symbol(2), self.written().form(&self.acceleration)),
        ]
    }

    pub fn label(&self, row: usize) -> String {
        self.named.analysis.motion.contacts[row].label(&self.named.analysis.system)
    }

    fn zeros(&self, factor: &Polynomial) -> Equation {
        let [left, right] = self.written().zeros(factor);
        Equation::new(left, right)
    }

    pub fn conditions(&self) -> Vec<Condition> {
        let condition = |(row, form): &(usize, Form)| {
            let polynomial = form.condition(&self.ring, self.level.coordinate);
            let double = double_roots(&self.ring, self.level.coordinate, &polynomial);
            let factors = form.vanishing(&self.ring, self.level.coordinate);
            Condition {
                label: self.label(*row),
                total: self.named.writer.total(*row),
                reaction: Equation::new(self.named.reaction(*row as u16), self.written().form(form)),
                vanishes: (!factors.is_empty())
                    .then(|| Equation::new(Math::ZERO, self.written().product(&factors))),
                double: double.map(|all| all.iter().map(|factor| self.zeros(factor)).collect()),
            }
        };
        self.reactions.iter().map(condition).collect()
    }

    pub fn pairs(&self) -> Vec<Coincidence> {
        let pairs =
            (0..self.reactions.len()).flat_map(|i| (i + 1..self.reactions.len()).map(move |j| (j, i)));
        pairs.map(|(i, j)| self.pair(&self.reactions[i], &self.reactions[j])).collect()
    }

    fn pair(&self, (row, one): &(usize, Form), (other_row, other): &(usize, Form)) -> Coincidence {
        let pair = Pair::compute(&self.ring, self.level.coordinate, [one, other]);
        let multiple = |[above, below]: [Polynomial; 2]| {
            let ratio = self.written().quotient(&above, &below);
            let ratio = if ratio.contains_sum() { ratio.group() } else { ratio };
            let [left, right] = [row, other_row].map(|row| self.named.reaction(*row as u16));
            Equation::new(left, Math::product([ratio, right]))
        };
        let proportional = pair.proportional.into_iter();
        Coincidence {
            labels: [self.label(*row), self.label(*other_row)],
            proportional: proportional
                .map(|(factor, ratio)| (self.zeros(&factor), ratio.map(multiple)))
                .collect(),
            always: pair.always.map(multiple),
            together: pair.together.map(|factors| factors.iter().map(|factor| self.zeros(factor)).collect()),
        }
    }

    pub fn numbers(
        &self,
        coordinate: usize,
        request: &Request,
        place: &Place,
        rate: f64,
    ) -> Result<Numbers, ConditionError> {
        let analysis = self.named.analysis;
        let values = Values::new(analysis, &request.parameters, coordinate, place, rate)?;
        let slope = |quotient: &Quotient| {
            Form::from_quotient(&self.ring, &quotient.derivative(self.level.coordinate))
        };
        let reactions = self.reactions.iter().zip(&self.level.reactions);
        let reactions = reactions.map(|((row, form), (_, r))| Reaction {
            label: self.label(*row),
            form,
            slope: slope(r),
        });
        let asked = OnLevel {
            ring: &self.ring,
            values: &values,
            coordinate: self.level.coordinate,
            start: place,
            rate_squared: &self.rate_squared,
            reactions: reactions.collect(),
        };
        asked.numbers().ok_or_else(|| ConditionError::Transcendental {
            phase: self.named.title(),
            coordinate: self.coordinate_name(),
        })
    }

    fn coordinate_name(&self) -> String {
        match self.level.coordinate {
            Symbol::Coordinate { index, .. } => self.named.coordinate(index),
            _ => String::new(),
        }
    }
}
