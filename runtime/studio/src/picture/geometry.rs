//! A model at one instant with all that its declaration says of its looks: springs, threads, outlines, what coordinates
//! measure. None of that is in a program that draws nothing, so it is read again from the declaration.

use super::DrawingError;
use crate::registry::Configuration;
use core::f64::consts::FRAC_PI_2;
use liftoff_codegen::algebra::{Angle, Series, Symbol};
use liftoff_codegen::kinematics::{Coordinate, Kinematics};
use liftoff_codegen::system::{OneSided, System};

/// A model's parts by their indices, and where they are.
pub(super) struct Geometry<'a> {
    pub configuration: &'a Configuration,
    pub system: System,
    /// All coordinates, in the layout's order.
    pub coordinates: Vec<Coordinate>,
}

/// A straight support and the point over it.
pub(super) struct Line {
    pub point: [f64; 2],
    pub through: [f64; 2],
    pub angle: f64,
}

impl<'a> Geometry<'a> {
    /// Reads the declaration of the model again.
    pub fn of(configuration: &'a Configuration) -> Result<Self, DrawingError> {
        let failed = |reason: String| DrawingError { figure: configuration.layout.name.to_owned(), reason };
        let tokens =
            configuration.layout.declaration.parse().map_err(|mistake| failed(format!("{mistake}")))?;
        let system = liftoff_codegen::resolve(tokens).map_err(|e| failed(e.to_string()))?;
        let coordinates = Kinematics::of(&system).map_err(|e| failed(e.to_string()))?.coordinates;
        Ok(Self { configuration, system, coordinates })
    }

    /// Where a point is.
    pub fn point(&self, index: usize) -> [f64; 2] {
        self.configuration.points[index]
    }

    /// The value of what parameters determine.
    pub fn number(&self, series: &Series) -> f64 {
        self.system.parameter_value(series, &self.configuration.parameters)
    }

    /// The same of a position.
    pub fn place(&self, at: &[Series; 2]) -> [f64; 2] {
        [self.number(&at[0]), self.number(&at[1])]
    }

    /// The same of an angle, rad.
    pub fn angle(&self, angle: &Angle) -> f64 {
        let quarters = f64::from(angle.quarter_turns()) * FRAC_PI_2;
        let term = |&(symbol, k): &(Symbol, i16)| f64::from(k) * self.number(&Series::symbol(symbol));
        quarters + angle.terms().iter().map(term).sum::<f64>()
    }

    /// The direction of a body's frame, rad.
    pub fn direction(&self, body: usize) -> f64 {
        let [from, to] = self.ends(body);
        let [a, b] = [from, to].map(|end| self.point(end));
        let [p, q] = [from, to].map(|end| self.place(&self.system.local(body, end)));
        (b[1] - a[1]).atan2(b[0] - a[0]) - (q[1] - p[1]).atan2(q[0] - p[0])
    }

    /// The first and the last point of a body.
    pub fn ends(&self, body: usize) -> [usize; 2] {
        let body = &self.system.bodies[body];
        [body.from, body.to]
    }

    /// Whether the ground holds a point.
    pub fn is_pinned(&self, point: usize) -> bool {
        self.system.pins.iter().any(|pin| pin.point == point)
    }

    /// Whether two bodies are joined there without turning about each other.
    pub fn is_welded(&self, point: usize) -> bool {
        let on = |body: usize| self.system.points[point].on.iter().any(|(other, _)| *other == body);
        self.system.welds.iter().any(|weld| on(weld.body) && weld.to.is_some_and(on))
    }

    /// The lines that points are kept above.
    pub fn lines(&self) -> impl Iterator<Item = Line> + '_ {
        self.system.supports.iter().filter_map(|support| match &support.contact {
            OneSided::Line { point, through, direction } => Some(Line {
                point: self.point(*point),
                through: self.place(through),
                angle: self.angle(direction),
            }),
            _ => None,
        })
    }

    /// A length or the like in print: `½ l`; none of a plain number.
    pub fn text(&self, series: &Series) -> Option<String> {
        series.as_constant().is_none().then(|| series.text(&self.system.names()))
    }
}
