//! A run in a few words, and its parts.

use crate::Event;
use crate::catalog::{Failure, Record};

/// What happened after the start: `open P, Q; stop`.
pub fn story(record: &dyn Record) -> String {
    let told: Vec<_> = after_start(record).iter().map(told).collect();
    told.join("; ")
}

/// The first event after the start, in words.
pub fn first(record: &dyn Record) -> String {
    after_start(record).first().map_or_else(String::new, told)
}

/// The same where a reaction or gap touches zero exactly: no floating point tells that from a crossing within rounding,
/// so that it may be called undecided or not.
pub fn touched(record: &dyn Record) -> String {
    first(record).trim_end_matches(UNDECIDED).to_owned()
}

/// An event after the start, by its place; of the run's last one where there are fewer.
pub fn event(record: &dyn Record, place: usize) -> &Event {
    let events = record.events();
    &events[(place + 1).min(events.len() - 1)]
}

/// Events and crossings of singular positions that are told in the log.
pub fn logged(record: &dyn Record, part: &str) -> usize {
    record.log().iter().filter(|entry| entry.text.contains(part)).count()
}

/// The final state.
pub fn last(record: &dyn Record) -> Vec<f64> {
    record.state(record.interval()[1])
}

/// The greatest departure of an output from its first value, over the ends of all steps.
pub fn drift(record: &dyn Record, output: &str) -> Result<f64, Failure> {
    let value = record.output(output)?;
    let begun = value(record.interval()[0]);
    Ok(record.times().iter().fold(0.0, |most: f64, &t| most.max((value(t) - begun).abs())))
}

/// What a touch is called whose side is not resolved.
const UNDECIDED: &str = " (undecided)";

fn after_start(record: &dyn Record) -> &[Event] {
    record.events().get(1..).unwrap_or_default()
}

/// An event in words.
pub fn told(event: &Event) -> String {
    let undecided = event.note.as_deref().is_some_and(|note| note.contains("undecided"));
    let undecided = if undecided { UNDECIDED } else { "" };
    match event.supports.is_empty() {
        true => format!("{}{undecided}", event.kind),
        false => format!("{} {}{undecided}", event.kind, event.supports.join(", ")),
    }
}
