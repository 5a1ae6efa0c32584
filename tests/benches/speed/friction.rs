//! Stick and slip of a block on a belt: the run against event code by hand over the same stepper,
//! which knows that there are two phases, two guards, and that none of them turns within a step.
//!
//! Of one event at a tolerance of 1e-9, ten steps of Dop853, by counts of instructions: the steps
//! three tenths, two fifths of that their dense outputs, which the trajectory keeps and event code
//! by hand has of the last step only; the guards, polynomials by these, a tenth; what is proved of
//! them and the place of the event a fifth; the decision and its record a sixth; the rest
//! beginnings and ends of phases and the work of friction. By hand a guard is one comparison a
//! step, and all of it an eighth. Taylor's method has series of its own, half as many steps, and
//! takes three quarters of that.

use liftoff::method;
use liftoff::prelude::*;
use serde_json::{Value, json};

use crate::Result;
use crate::stick_slip::{BELT, by_hand, simulation};
use crate::timing::nanoseconds;

/// A row for each tolerance.
pub fn rows() -> Result<Vec<Value>> {
    [1e-6, 1e-9, 1e-12].map(row).into_iter().collect()
}

fn row(tolerance: f64) -> Result<Value> {
    let simulation = simulation(tolerance)?;
    let by_series = simulation.clone().method(method::Taylor);
    let simulation = simulation.method(method::Dop853);
    let record = simulation.run()?;
    let (events, _) = by_hand(&BELT, tolerance);
    let found = record.events().iter().filter(|it| matches!(it.kind, EventKind::Slip | EventKind::Stick));
    let ns = nanoseconds([
        &mut || drop(simulation.run()),
        &mut || {
            std::hint::black_box(by_hand(&BELT, tolerance));
        },
        &mut || drop(by_series.run()),
    ]);
    Ok(json!({
        "tolerance": tolerance,
        "events": found.count(),
        "events_by_hand": events,
        "us": ns[0] / 1e3,
        "us_by_hand": ns[1] / 1e3,
        "ratio": ns[0] / ns[1],
        "us_by_series": ns[2] / 1e3,
        "ratio_by_series": ns[2] / ns[1],
    }))
}
