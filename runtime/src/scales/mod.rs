//! Natural scales of a model, from its checked measures: length the largest bar, mass the total, time
//! √(length / gravity), without gravity √(mass / stiffness) of the stiffest spring, else 1. A model without bars has its
//! size from the figure, or else from the pose that it starts from.

#[cfg(feature = "std")]
mod check;

use crate::model::{BarSystem, Coordinate, MeasureKind};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;

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
    /// The scales of a model whose measures are not looked into.
    pub(crate) fn natural<M: BarSystem>(model: &M) -> Self {
        let measures = model.measures();
        let measures = measures.as_ref();
        let of = |kind| measures.iter().filter(move |m| m.kind == kind).map(|m| m.value);
        let length = of(MeasureKind::Length).fold(0.0, f64::max);
        let gravity = of(MeasureKind::Gravity).fold(0.0, |most: f64, g| most.max(g.abs()));
        let mass: f64 = of(MeasureKind::Mass).sum();
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
        Self { length, time, mass, has_bars, gravity, damped }
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

    /// The unit of an entry of a full state.
    pub(crate) fn entry<M: BarSystem>(&self, i: usize) -> f64 {
        let (coordinates, n) = (M::LAYOUT.coordinates, M::LAYOUT.coordinates.len());
        match i {
            _ if i < n => self.coordinate(&coordinates[i]),
            _ if i < 2 * n => self.coordinate(&coordinates[i - n]) / self.time,
            _ => self.time,
        }
    }

    /// The unit of each entry of a full state.
    #[cfg(feature = "std")]
    pub(crate) fn state<M: BarSystem>(&self) -> Vec<f64> {
        let entries = 2 * M::LAYOUT.coordinates.len() + usize::from(M::LAYOUT.timed);
        (0..entries).map(|i| self.entry::<M>(i)).collect()
    }
}

/// The largest coordinate that is a length.
fn size<M: BarSystem>(positions: &[f64]) -> Option<f64> {
    let lengths = positions.iter().zip(M::LAYOUT.coordinates).filter(|(_, c)| !c.is_angle);
    let largest = lengths.fold(0.0, |most: f64, (x, _)| most.max(x.abs()));
    (largest > 0.0 && largest.is_finite()).then_some(largest)
}
