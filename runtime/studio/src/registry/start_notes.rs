//! What a start allows and hardly means.

use super::Entry;
use super::crossed_outline::crossed_outline;
use super::line_violation::line_violation;
use crate::run_spec::{RunSpec, Values};
use core::f64::consts::TAU;
use liftoff_core::model::Layout;

/// What is allowed of the start of a run, and hardly meant; nothing of a start that is refused.
pub fn start_notes(model: &Entry, spec: &RunSpec) -> Vec<String> {
    let nominal = RunSpec { start: Vec::new(), energy_of: Vec::new(), ..spec.clone() };
    let (Ok(start), Ok(nominal)) = (model.configuration(spec), model.configuration(&nominal)) else {
        return Vec::new();
    };
    let behind = line_violation(&start, &nominal).map(|behind| behind.to_string());
    angle_notes(model.layout(), &spec.start).chain(behind).chain(crossed_outline(&start)).collect()
}

/// Angles of more than a turn, which may be degrees.
pub fn angle_notes(layout: &Layout, start: &Values) -> impl Iterator<Item = String> {
    let angles = start.iter().filter(|(name, value)| value.abs() > TAU && layout.is_angle(name));
    angles.map(|(name, value)| {
        let turns = value.abs() / TAU;
        format!("{name} starts at {value} rad, {turns:.1} turns; degrees have their unit, `{value}deg`")
    })
}
