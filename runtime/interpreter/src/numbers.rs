//! Measures, the nominal figure and the numbers of a drawing for values of the parameters.

use liftoff_codegen::Analysis;
use liftoff_codegen::geometry::Geometry;
use liftoff_codegen::numbers::{
    self, MeasureValue, Nominal, NominalDirection, NominalReading, NominalReference, ParameterProgram, Turned,
};
use liftoff_core::figure::{direction, wrapped};
use liftoff_core::model::{Measure, MeasureKind};

use crate::layout::text;

/// What parameters alone determine, as arithmetic.
#[derive(Debug)]
pub(crate) struct ParameterNumbers {
    measures: ParameterProgram,
    entries: Vec<(&'static str, MeasureKind, MeasureValue)>,
    nominal: Nominal,
    drawn: ParameterProgram,
}

impl ParameterNumbers {
    pub fn from_analysis(analysis: &Analysis) -> Self {
        let measures = numbers::measures(analysis);
        let entries = measures.entries.into_iter();
        let drawn = Geometry::from_system(&analysis.system, &analysis.kinematics.coordinates);
        Self {
            entries: entries.map(|entry| (text(&entry.of), kind(entry.kind), entry.value)).collect(),
            measures: measures.numbers,
            nominal: numbers::nominal(analysis),
            drawn: numbers::drawn(analysis, &drawn),
        }
    }

    pub fn drawn(&self, parameters: &[f64]) -> Vec<f64> {
        self.drawn.evaluate(parameters)
    }

    /// The coordinates of the nominal figure.
    pub fn nominal(&self, parameters: &[f64]) -> Vec<f64> {
        let numbers = self.nominal.numbers.evaluate(parameters);
        let between = |ends: [[usize; 2]; 2]| {
            let [from, to] = ends.map(|place| place.map(|number| numbers[number]));
            direction(from, to)
        };
        let turned = |direction: &NominalDirection| match direction.own {
            Some(own) => between(direction.seen) - between(own),
            None => between(direction.seen),
        };
        let value = |reading: &NominalReading| {
            let (value, is_opposite) = match reading {
                NominalReading::Position { number, is_opposite } => (numbers[*number], *is_opposite),
                NominalReading::Angle { from, to, is_opposite } => {
                    let from = match from {
                        NominalReference::Ground(constant) => numbers[*constant],
                        NominalReference::Body(other) => turned(other),
                    };
                    (wrapped(turned(to) - from), *is_opposite)
                }
            };
            if is_opposite { -value } else { value }
        };
        self.nominal.readings.iter().map(value).collect()
    }

    pub fn measures(&self, parameters: &[f64], nominal: &[f64]) -> Vec<Measure> {
        let numbers = self.measures.evaluate(parameters);
        let distance = |Turned { constant, terms }: &Turned| {
            let turned = terms.iter().map(|&(i, k)| f64::from(k) * nominal[i]);
            wrapped(turned.fold(numbers[*constant], |sum, term| sum + term)).abs()
        };
        let value = |value: &MeasureValue| match value {
            MeasureValue::Number(k) => numbers[*k],
            MeasureValue::Quotient(a, b) => numbers[*a] / numbers[*b],
            MeasureValue::Branch([zero, other]) => distance(other) - distance(zero),
        };
        let measure = |(of, kind, given): &(&'static str, MeasureKind, MeasureValue)| Measure {
            of,
            kind: *kind,
            value: value(given),
        };
        self.entries.iter().map(measure).collect()
    }
}

fn kind(kind: numbers::MeasureKind) -> MeasureKind {
    match kind {
        numbers::MeasureKind::Mass => MeasureKind::Mass,
        numbers::MeasureKind::Length => MeasureKind::Length,
        numbers::MeasureKind::Extent => MeasureKind::Extent,
        numbers::MeasureKind::Margin => MeasureKind::Margin,
        numbers::MeasureKind::Inertia => MeasureKind::Inertia,
        numbers::MeasureKind::Gravity => MeasureKind::Gravity,
        numbers::MeasureKind::Stiffness => MeasureKind::Stiffness,
        numbers::MeasureKind::TorsionalStiffness => MeasureKind::TorsionalStiffness,
        numbers::MeasureKind::Damping => MeasureKind::Damping,
        numbers::MeasureKind::Sign => MeasureKind::Sign,
        numbers::MeasureKind::Side => MeasureKind::Side,
        numbers::MeasureKind::Direction => MeasureKind::Direction,
        numbers::MeasureKind::Branch => MeasureKind::Branch,
    }
}
