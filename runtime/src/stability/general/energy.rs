//! The energy of phases that nothing drives or damps, as their equations tell at the ends and in the middle of each.

use super::{Effort, at, case, largest, runs};
use crate::Segment;
use crate::catalog::{Failure, Model, Record};
use crate::scene::Setup;
use crate::stability::{Answer, Case, Expected, at_most};

const TOLERANCE: f64 = 1e-12;
/// Tolerances by which the energy may be off, in natural units.
const MOST: f64 = 1e2;
/// A power below this, in natural units, is rounding of a difference.
const NONE: f64 = 1e-6;
/// Of a run that has no such phase.
const EXCUSE: &str = "driven or damped";

pub(super) fn cases(model: &'static dyn Model, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let wants = vec![at_most("drift of E", MOST * TOLERANCE)];
    let expected = Expected::Unless { said: String::new(), wants, excuse: EXCUSE };
    let scene = format!("default run at {TOLERANCE:e}, phase by phase");
    vec![case("energy", (model, ""), scene, "energy", expected, move || drift(model))]
}

fn drift(model: &dyn Model) -> Result<Answer, Failure> {
    let setup = at(model, TOLERANCE);
    let record = model.run(&setup)?;
    let [length, time, mass] = model.units(&setup)?;
    let unit = mass * (length / time).powi(2);
    let energy = record.output("E")?;
    let mut drifts = Vec::new();
    for segment in record.segments() {
        if power(model, &setup, &*record, &segment)? * time < NONE * unit {
            drifts.push(phase(&*record, &segment, &*energy) / unit);
        }
    }
    match drifts.is_empty() {
        true => Err(Failure::Input(format!("{EXCUSE} all the time"))),
        false => Ok(Answer { said: String::new(), numbers: vec![largest(drifts.into_iter())] }),
    }
}

/// The greatest |Ė| of a phase that is looked at.
fn power(
    model: &dyn Model,
    setup: &Setup,
    record: &dyn Record,
    &Segment { set, t0, t1, .. }: &Segment,
) -> Result<f64, Failure> {
    let inside = [0.01, 0.3, 0.5, 0.8, 0.99].map(|part| t0 + part * (t1 - t0));
    let powers: Result<Vec<_>, _> =
        inside.iter().map(|&t| model.power(setup, set, t, &record.state(t))).collect();
    Ok(largest(powers?.into_iter().map(f64::abs)))
}

/// How far the energy of a phase departs from what it begins with. At its ends the energy is that of the neighbours.
fn phase(record: &dyn Record, &Segment { t0, t1, .. }: &Segment, energy: &dyn Fn(f64) -> f64) -> f64 {
    let times = record.times();
    let inside = times.iter().filter(|t| (t0..t1).contains(*t)).map(|t| energy(*t));
    let begun = energy(t0);
    largest(inside.map(|now| (now - begun).abs()))
}
