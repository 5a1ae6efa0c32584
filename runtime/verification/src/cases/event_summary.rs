//! The events of a run as text, and single values of it.

use crate::MotionError;
use liftoff::Event;
use liftoff::{LoggedDecision, Trajectory};

/// The events after the start, joined by semicolons: `open P, Q; stop`.
pub fn event_summary(record: &Trajectory) -> String {
    let texts: Vec<_> = after_start(record).iter().map(describe).collect();
    texts.join("; ")
}

/// The first event after the start; empty if there is none.
pub fn first(record: &Trajectory) -> String {
    after_start(record).first().map_or_else(String::new, describe)
}

/// The same where a reaction or gap touches zero exactly: no floating point tells that from a
/// crossing within rounding, so that it may be called undecided or not.
pub fn touched(record: &Trajectory) -> String {
    after_start(record).first().map_or_else(String::new, kind_and_supports)
}

/// An event after the start, by its place; of the run's last one where there are fewer.
pub fn event(record: &Trajectory, place: usize) -> &Event {
    let events = record.events();
    &events[(place + 1).min(events.len() - 1)]
}

/// Number of times that a run logged this decision.
pub fn logged(record: &Trajectory, decision: &LoggedDecision) -> usize {
    record.log().iter().filter(|entry| entry.decision == *decision).count()
}

/// The state at the end of the run: coordinates, then rates.
pub fn last(record: &Trajectory) -> Vec<f64> {
    record.state(record.interval()[1])
}

/// Largest absolute deviation of an output from its initial value, over the ends of all steps.
pub fn drift(record: &Trajectory, output: &str) -> Result<f64, MotionError> {
    let value = record.function(output)?;
    let begun = value(record.interval()[0]);
    Ok(record.times().iter().fold(0.0, |most: f64, &t| most.max((value(t) - begun).abs())))
}

fn after_start(record: &Trajectory) -> &[Event] {
    record.events().get(1..).unwrap_or_default()
}

/// One event: kind and supports, `open P, Q`; ` (undecided)` after a touch whose side is not
/// resolved.
pub fn describe(event: &Event) -> String {
    let undecided = if event.is_undecided() { " (undecided)" } else { "" };
    kind_and_supports(event) + undecided
}

fn kind_and_supports(event: &Event) -> String {
    match event.supports.is_empty() {
        true => event.kind.to_string(),
        false => format!("{} {}", event.kind, event.supports.join(", ")),
    }
}
