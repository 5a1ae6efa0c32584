//! Natural scales of a model, from its checked measures: length the largest bar, mass the total, time
//! √(length / gravity), without gravity √(mass / stiffness) of the stiffest spring, else 1. A model without bars has its
//! size from the figure, or else from the pose that it starts from.

use crate::error::ModelError;
use crate::model::{BarSystem, Coordinate, Layout, Measure, MeasureKind};

/// Units in which tolerances are absolute.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scales {
    pub(crate) length: f64,
    pub(crate) time: f64,
    pub(crate) mass: f64,
    /// Whether the length is that of a bar.
    has_bars: bool,
    gravity: f64,
    /// Whether something is damped.
    pub(crate) damped: bool,
}

impl Scales {
    /// Refuses parameters that are no numbers, negative masses and lengths that are not positive.
    pub(crate) fn of<M: BarSystem>(model: &M) -> Result<Self, ModelError> {
        for (name, value) in M::LAYOUT.parameters.iter().zip(model.parameters().as_ref()) {
            if !value.is_finite() {
                let value = *value;
                return Err(ModelError::Parameter { name: (*name).to_owned(), value });
            }
        }
        let measures = model.measures();
        let measures = measures.as_ref();
        measures.iter().try_for_each(check)?;
        check_restitution(M::LAYOUT, model.restitution().as_ref())?;
        let of = |kind| measures.iter().filter(move |m| m.kind == kind).map(|m| m.value);
        let length = of(MeasureKind::Length).fold(0.0, f64::max);
        let gravity = of(MeasureKind::Gravity).fold(0.0, |most: f64, g| most.max(g.abs()));
        let mass: f64 = of(MeasureKind::Mass).sum();
        if mass <= 0.0 {
            return Err(ModelError::Massless);
        }
        let has_bars = length > 0.0;
        let length = if has_bars { length } else { size::<M>(model.nominal().as_ref()).unwrap_or(1.0) };
        let largest = |kind| of(kind).fold(0.0, f64::max);
        let stiffness =
            largest(MeasureKind::Stiffness).max(largest(MeasureKind::TorsionalStiffness) / (length * length));
        let time = if gravity > 0.0 {
            (length / gravity).sqrt()
        } else if stiffness > 0.0 {
            (mass / stiffness).sqrt()
        } else {
            1.0
        };
        let damped = of(MeasureKind::Damping).any(|damping| damping > 0.0);
        Ok(Self { length, time, mass, has_bars, gravity, damped })
    }

    /// The scales of a run from these coordinates.
    pub(crate) fn starting_at<M: BarSystem>(self, positions: &[f64]) -> Self {
        match size::<M>(positions) {
            Some(length) if !self.has_bars => {
                let time = if self.gravity > 0.0 { (length / self.gravity).sqrt() } else { self.time };
                Self { length, time, ..self }
            }
            _ => self,
        }
    }

    pub(crate) fn speed(&self) -> f64 {
        self.length / self.time
    }

    pub(crate) fn acceleration(&self) -> f64 {
        self.speed() / self.time
    }

    /// The weight, or what accelerates the mass by one natural length in one natural time.
    pub(crate) fn force(&self) -> f64 {
        self.mass * self.acceleration()
    }

    /// The unit of a coordinate.
    pub(crate) fn coordinate(&self, coordinate: &Coordinate) -> f64 {
        if coordinate.is_angle { 1.0 } else { self.length }
    }

    /// The unit of each entry of a full state.
    pub(crate) fn state<M: BarSystem>(&self) -> Vec<f64> {
        let positions = M::LAYOUT.coordinates.iter().map(|c| self.coordinate(c));
        let rates = positions.clone().map(|x| x / self.time);
        positions.chain(rates).chain(M::LAYOUT.timed.then_some(self.time)).collect()
    }
}

/// The largest coordinate that is a length.
fn size<M: BarSystem>(positions: &[f64]) -> Option<f64> {
    let lengths = positions.iter().zip(M::LAYOUT.coordinates).filter(|(_, c)| !c.is_angle);
    let largest = lengths.fold(0.0, |most: f64, (x, _)| most.max(x.abs()));
    (largest > 0.0 && largest.is_finite()).then_some(largest)
}

fn check(measure: &Measure) -> Result<(), ModelError> {
    let (of, value) = (measure.of.to_owned(), measure.value);
    if !value.is_finite() {
        return Err(ModelError::NotFinite { of: named(measure), value });
    }
    match measure.kind {
        MeasureKind::Mass if value < 0.0 => Err(ModelError::NegativeMass { of, value }),
        MeasureKind::Inertia if value < 0.0 => Err(ModelError::NegativeInertia { of, value }),
        MeasureKind::Margin if value < 0.0 => Err(ModelError::OffBar { of, beyond: -value }),
        MeasureKind::Length | MeasureKind::Extent if value <= 0.0 => Err(ModelError::Length { of, value }),
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness if value < 0.0 => {
            Err(ModelError::NegativeStiffness { of, value })
        }
        MeasureKind::Damping if value < 0.0 => Err(ModelError::NegativeDamping { of, value }),
        _ => Ok(()),
    }
}

fn named(measure: &Measure) -> String {
    match measure.kind {
        MeasureKind::Inertia => format!("moment of inertia of {}", measure.of),
        MeasureKind::Length => format!("length of {}", measure.of),
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness => format!("stiffness of {}", measure.of),
        MeasureKind::Damping => format!("damping of {}", measure.of),
        MeasureKind::Mass | MeasureKind::Extent | MeasureKind::Margin | MeasureKind::Gravity => {
            measure.of.to_owned()
        }
    }
}

fn check_restitution(layout: &Layout, values: &[f64]) -> Result<(), ModelError> {
    match layout.contacts.iter().zip(values).find(|(_, value)| !(0.0..=1.0).contains(*value)) {
        Some((contact, &value)) => Err(ModelError::Restitution { contact: contact.label.to_owned(), value }),
        None => Ok(()),
    }
}
