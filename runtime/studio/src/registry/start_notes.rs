//! What a start allows and hardly means.

use super::Entry;
use super::crossed_outline::crossed_outline;
use super::line_violation::line_violation;
use crate::run_spec::{RunSpec, Values};
use core::f64::consts::TAU;
use liftoff_core::model::Layout;

/// What is allowed of the start of a run, and hardly meant.
pub fn start_notes(model: &Entry, spec: &RunSpec) -> Vec<String> {
    let mut notes: Vec<String> = turned(model.layout(), &spec.start).collect();
    let nominal = RunSpec { start: Vec::new(), energy_of: Vec::new(), ..spec.clone() };
    if let (Ok(start), Ok(nominal)) = (model.configuration(spec), model.configuration(&nominal)) {
        notes.extend(line_violation(&start, &nominal).map(|behind| behind.to_string()));
        notes.extend(crossed_outline(&start));
    }
    notes
}

/// Angles of more than a turn, which may be degrees.
fn turned(layout: &Layout, start: &Values) -> impl Iterator<Item = String> {
    let angles = start.iter().filter(|(name, value)| value.abs() > TAU && layout.is_angle(name));
    angles.map(|(name, value)| {
        let turns = value.abs() / TAU;
        format!("{name} starts at {value} rad, {turns:.1} turns; degrees have their unit, `{value}deg`")
    })
}
