//! Fig. 1b strict: A, C and E watched one by one, inner and outer angles free to differ.

pub mod asymmetry;
pub mod comparison;
mod figure;
pub mod map;

use super::ReportError;
use super::published::{Ratio, normalised};
use super::quantity::{Quantity, Value};
use super::reading::{coordinate, events_of};
use crate::models;
use liftoff::prelude::*;
use liftoff_studio::RunSpec;

pub(super) const MODEL: &str = "zigzag";

pub(super) const RATIOS: [Ratio; 5] =
    [("0.10", 0.1), ("0.25", 0.25), ("0.50", 0.5), ("0.75", 0.75), ("0.90", 0.9)];

/// The run of one mass ratio.
pub struct Run {
    ratio: Ratio,
    flight: Trajectory,
}

/// The run with this mass ratio.
pub fn spec(ratio: f64, tolerance: f64) -> Result<RunSpec, ReportError> {
    Ok(normalised(models().find(MODEL)?.default_run().tolerance(tolerance), ratio))
}

impl Run {
    /// The runs of every ratio with a reference.
    pub fn all(tolerance: f64) -> Result<Vec<Self>, ReportError> {
        RATIOS.into_iter().map(|ratio| Self::new(ratio, tolerance)).collect()
    }

    /// The run of this ratio.
    pub fn new(ratio: Ratio, tolerance: f64) -> Result<Self, ReportError> {
        Ok(Self { ratio, flight: models().find(MODEL)?.run(&spec(ratio.1, tolerance)?)? })
    }

    fn openings(&self) -> impl Iterator<Item = &Event> {
        events_of(&self.flight, EventKind::Open)
    }

    fn closing(&self) -> Option<&Event> {
        events_of(&self.flight, EventKind::Close).next()
    }

    fn angle(&self, event: Option<&Event>, name: &str) -> Option<f64> {
        coordinate(&self.flight, &event?.state, name)
    }

    /// The numbers of `references.json` for this ratio; null where there is no second opening.
    pub fn quantities(&self) -> Vec<Quantity> {
        let id = |name: &str| format!("strict.{name}[{}]", self.ratio.0);
        let mut openings = self.openings();
        let (first, second, closing) = (openings.next(), openings.next(), self.closing());
        let number = |name, quantity, event, coordinate| {
            Quantity::number(id(name), MODEL, quantity, "rad", self.angle(event, coordinate))
        };
        vec![
            number("phi_first", "angle at the first opening", first, "phi_inner"),
            Quantity {
                id: id("first"),
                model: MODEL,
                quantity: "supports that open first",
                unit: "supports",
                computed: first.map(|event| Value::Supports(names(event))),
            },
            number("phi_inner_second", "inner angle at the second opening", second, "phi_inner"),
            number("phi_outer_second", "outer angle at the second opening", second, "phi_outer"),
            number("phi_inner_touch", "inner angle as B and D reach the floor", closing, "phi_inner"),
            number("phi_outer_touch", "outer angle as B and D reach the floor", closing, "phi_outer"),
        ]
    }
}

/// The supports of an event in alphabetical order.
fn names(event: &Event) -> String {
    let mut names = event.supports.clone();
    names.sort_unstable();
    names.join(", ")
}
