//! Natural scales of a model, from its checked measures: length the largest bar, mass the total,
//! time √(length / gravity), without gravity √(mass / stiffness) of the stiffest spring. Where
//! there is neither, or where a run starts so fast, or is struck so hard, that they hardly matter,
//! the time is that of a natural length or of a radian then. A model without bars has its size from
//! the figure, or else from the pose that it starts from; one that starts at the origin has that by
//! which its weight stretches the stiffest spring, m g/k, and no more than it flies if that is not
//! lost beside it. From a small pose it may fly far: then it is as large as it flies, but no larger
//! than its figure, beside which there may be what it meets.

use crate::model::{Coordinate, Layout, Measure, MeasureKind};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;

/// So many natural lengths or radians in a natural time are swift: the motion has its own time.
const SWIFT: f64 = 100.0;

/// What flies so many times higher than the pose it starts from is large is as large as it flies,
/// or as its figure.
const HIGH: f64 = 1e4;

/// Units in which tolerances are absolute.
#[derive(Debug, Clone, Copy)]
pub struct Scales {
    /// The length of the largest bar.
    pub length: f64,
    /// √(length / gravity), √(mass / stiffness), or that of the motion at the start.
    pub time: f64,
    /// The mass of all bodies.
    pub mass: f64,
    /// Whether the length is that of a bar.
    has_bars: bool,
    /// The size of the figure, or of a disc, a circle, a thread; infinite where they have none.
    figure: f64,
    gravity: f64,
    /// m g/k, with gravity and a spring.
    stretch: Option<f64>,
    /// Whether gravity, a spring or the motion tells the time.
    has_time: bool,
    /// Whether something is damped.
    pub damped: bool,
}

impl Scales {
    /// The scales that follow from measures, which are not looked into, and from the coordinates of
    /// the nominal figure.
    pub fn natural(layout: &Layout, measures: &[Measure], nominal: &[f64]) -> Self {
        let of = |kind| measures.iter().filter(move |m| m.kind == kind).map(|m| m.value);
        let length = of(MeasureKind::Length).fold(0.0, f64::max);
        let gravity = of(MeasureKind::Gravity).fold(0.0, |most: f64, g| most.max(g.abs()));
        let mass: f64 = of(MeasureKind::Mass).sum();
        let has_bars = length > 0.0;
        let figure = of(MeasureKind::Extent).chain(size(layout, nominal)).fold(0.0, f64::max);
        let figure = if figure > 0.0 { figure } else { f64::INFINITY };
        let largest = |kind| of(kind).fold(0.0, f64::max);
        let stiffest: f64 = largest(MeasureKind::Stiffness);
        let stretch = (stiffest > 0.0).then(|| mass * gravity / stiffest).filter(|stretch| *stretch > 0.0);
        let length = if has_bars { length } else { size(layout, nominal).or(stretch).unwrap_or(1.0) };
        let stiffness = stiffest.max(largest(MeasureKind::TorsionalStiffness) / (length * length));
        let time = if gravity > 0.0 {
            (length / gravity).sqrt()
        } else if stiffness > 0.0 {
            (mass / stiffness).sqrt()
        } else {
            1.0
        };
        let damped = of(MeasureKind::Damping).any(|damping| damping > 0.0);
        let has_time = gravity > 0.0 || stiffness > 0.0;
        Self { length, time, mass, has_bars, figure, gravity, stretch, has_time, damped }
    }

    /// The scales of a run from these coordinates and rates, but for its time.
    pub fn sized_at(self, layout: &Layout, positions: &[f64], rates: &[f64]) -> Self {
        let flight = self.flight(layout, rates);
        let slack = self.stretch.map(|length| {
            let known = flight.filter(|height| *height > f64::EPSILON * length);
            known.map_or(length, |height| length.min(height))
        });
        match size(layout, positions).or(slack) {
            Some(length) if !self.has_bars => {
                let high = flight.filter(|height| *height > HIGH * length);
                let length = high.map_or(length, |height| length.max(height.min(self.figure)));
                let time = if self.gravity > 0.0 { (length / self.gravity).sqrt() } else { self.time };
                Self { length, time, ..self }
            }
            _ => self,
        }
    }

    /// The scales of a run from these rates. What drives accelerate, in natural lengths or radians,
    /// counts where nothing else tells the time: their rates may be what rounding makes of zero.
    pub fn starting_at(self, layout: &Layout, rates: &[f64], driven: f64) -> Self {
        let fastest = self.fastest(layout, rates);
        if self.has_time {
            return self.at_rate(fastest);
        }
        Self { has_time: fastest > 0.0, ..self.at_rate(fastest.max(driven.sqrt())) }
    }

    /// The scales of a motion that may have become much faster since its start.
    #[must_use]
    pub fn moving_at(self, layout: &Layout, rates: &[f64]) -> Self {
        // Without bars the length is that of the start, which a flight may exceed by far.
        let fastest = if self.has_bars { self.fastest(layout, rates) } else { 0.0 };
        Self { time: self.time.min(1.0 / fastest), ..self }
    }

    /// The scales of a run whose drives alone tell the time, by the rates that they give at its
    /// start and what they accelerate there.
    pub fn driven_at(self, layout: &Layout, rates: &[f64], driven: f64) -> Self {
        if self.has_time { self } else { self.at_rate(self.fastest(layout, rates).max(driven.sqrt())) }
    }

    /// The largest rate, in natural lengths or radians.
    pub fn fastest(&self, layout: &Layout, rates: &[f64]) -> f64 {
        let natural = rates.iter().zip(layout.coordinates).map(|(u, c)| (u / self.coordinate(c)).abs());
        natural.filter(|rate| rate.is_finite()).fold(0.0, f64::max)
    }

    /// v²/g of the fastest coordinate that is a length.
    fn flight(&self, layout: &Layout, rates: &[f64]) -> Option<f64> {
        size(layout, rates).filter(|_| self.gravity > 0.0).map(|speed| speed * speed / self.gravity)
    }

    /// The scales where the fastest coordinate has this rate, in natural lengths or radians.
    fn at_rate(self, fastest: f64) -> Self {
        // Without bars the length is that of the start, which a flight may exceed by far.
        let outruns = self.has_bars && fastest * self.time > SWIFT;
        let swift = outruns || !self.has_time && fastest > 0.0;
        if swift { Self { time: 1.0 / fastest, has_time: true, ..self } } else { self }
    }

    /// The scales of a run in which something is struck by an impulse of this size.
    pub fn struck(self, impulse: f64) -> Self {
        let rate = impulse / (self.mass * self.length);
        if rate.is_finite() { self.at_rate(rate) } else { self }
    }

    /// length / time.
    pub fn speed(&self) -> f64 {
        self.length / self.time
    }

    /// length / time².
    pub fn acceleration(&self) -> f64 {
        self.speed() / self.time
    }

    /// The weight, or what accelerates the mass by one natural length in one natural time.
    pub fn force(&self) -> f64 {
        self.mass * self.acceleration()
    }

    /// The unit of a coordinate.
    pub fn coordinate(&self, coordinate: &Coordinate) -> f64 {
        if coordinate.is_angle { 1.0 } else { self.length }
    }

    /// The unit of an entry of a full state.
    pub fn entry(&self, layout: &Layout, i: usize) -> f64 {
        let (coordinates, n) = (layout.coordinates, layout.coordinates.len());
        match i {
            _ if i < n => self.coordinate(&coordinates[i]),
            _ if i < 2 * n => self.coordinate(&coordinates[i - n]) / self.time,
            _ if i < layout.switch(0) => self.time,
            _ => 1.0,
        }
    }

    /// The unit of each entry of a full state.
    #[cfg(feature = "std")]
    pub fn state(&self, layout: &Layout) -> Vec<f64> {
        (0..layout.entries()).map(|i| self.entry(layout, i)).collect()
    }
}

/// The largest coordinate that is a length.
fn size(layout: &Layout, positions: &[f64]) -> Option<f64> {
    let lengths = positions.iter().zip(layout.coordinates).filter(|(_, c)| !c.is_angle);
    let largest = lengths.fold(0.0, |most: f64, (x, _)| most.max(x.abs()));
    (largest > 0.0 && largest.is_finite()).then_some(largest)
}
