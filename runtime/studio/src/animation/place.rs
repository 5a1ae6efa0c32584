//! Places and directions, as the page reads them.

use liftoff_core::model::geometry;
use serde::Serialize;

use crate::registry::Configuration;

/// A point, or a place that stands still.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Spot {
    Point(usize),
    Fixed([f64; 2]),
}

/// An angle; from one place to another; the same less an angle.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Direction {
    Fixed(f64),
    Towards(Spot, Spot),
    Axis(usize, usize, f64),
}

impl Spot {
    pub(super) fn new(spot: geometry::Spot, start: &Configuration) -> Self {
        match spot {
            geometry::Spot::Point(point) => Self::Point(point),
            geometry::Spot::Fixed(at) => Self::Fixed(start.position(at)),
        }
    }
}

impl Direction {
    pub fn new(direction: geometry::Direction, start: &Configuration) -> Self {
        match direction {
            geometry::Direction::Fixed(angle) => Self::Fixed(start.number(angle)),
            geometry::Direction::Towards(from, to) => {
                Self::Towards(Spot::new(from, start), Spot::new(to, start))
            }
            geometry::Direction::Axis { ends, step } => {
                let [along, across] = start.position(step);
                Self::Axis(ends[0], ends[1], across.atan2(along))
            }
        }
    }
}
