//! The energy of phases that nothing drives or damps, as their equations tell at the ends and in
//! the middle of each.

use super::{Effort, case, largest, runs, shown, with_tolerance};
use crate::checks::{Answer, Case, Expected, at_most};
use crate::registry::{Entry, MotionError};
use crate::run_spec::RunSpec;
use liftoff::Segment;
use liftoff::Trajectory;

const TOLERANCE: f64 = 1e-12;
/// Tolerances by which the energy may be off, in natural units.
const MOST: f64 = 1e2;
/// A power below this, in natural units, is rounding of a difference.
const NONE: f64 = 1e-6;
/// Of a run that has no such phase.
const EXCUSE: &str = "driven or damped";

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let expectations = vec![at_most("drift of E", MOST * TOLERANCE)];
    let expected = Expected::Unless { text: String::new(), expectations, excuse: EXCUSE };
    let scene = format!("default run at {TOLERANCE:e}, phase by phase");
    vec![case("energy", (model, ""), scene, "energy", expected, move || drift(model))]
}

fn drift(model: &Entry) -> Result<Answer, MotionError> {
    let spec = with_tolerance(model, TOLERANCE);
    let record = shown(&spec, model.run(&spec)?);
    let [length, time, mass] = model.units(&spec)?;
    let unit = mass * (length / time).powi(2);
    let energy = record.function("E")?;
    let mut drifts = Vec::new();
    for segment in record.segments() {
        if power(model, &spec, &record, &segment)? * time < NONE * unit {
            drifts.push(phase(&record, &segment, &energy) / unit);
        }
    }
    match drifts.is_empty() {
        true => Err(MotionError::Input(format!("{EXCUSE} all the time"))),
        false => Ok(Answer { text: String::new(), numbers: vec![largest(drifts.into_iter())] }),
    }
}

/// The greatest |Ė| of a phase that is looked at.
fn power(
    model: &Entry,
    spec: &RunSpec,
    record: &Trajectory,
    &Segment { set, t0, t1, .. }: &Segment,
) -> Result<f64, MotionError> {
    let inside = [0.01, 0.3, 0.5, 0.8, 0.99].map(|part| t0 + part * (t1 - t0));
    let powers: Result<Vec<_>, _> =
        inside.iter().map(|&t| model.energy_rate(spec, set, t, &record.state(t))).collect();
    Ok(largest(powers?.into_iter().map(f64::abs)))
}

/// How far the energy of a phase departs from what it begins with. At its ends the energy is that
/// of the neighbours.
fn phase(record: &Trajectory, &Segment { t0, t1, .. }: &Segment, energy: &dyn Fn(f64) -> f64) -> f64 {
    let times = record.times();
    let inside = times.iter().filter(|t| (t0..t1).contains(*t)).map(|t| energy(*t));
    let begun = energy(t0);
    largest(inside.map(|now| (now - begun).abs()))
}
