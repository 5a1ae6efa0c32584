//! `liftoff run --json`, and what all JSON is written by.

use crate::CommandError;
use crate::options::samples::Row;
use crate::options::sampling::{Sampling, precedes_jump, values_at};
use liftoff::__private::expression::unrounded;
use liftoff::Trajectory;
use liftoff::{Event, Reaction};
use liftoff_core::model::{Energy, Layout};
use liftoff_studio::registry::run_notes;
use liftoff_studio::run_spec::RunSpec;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Serialize)]
struct Run<'a> {
    model: &'a str,
    parameters: Map<String, Value>,
    events: Vec<EventJson>,
    final_state: Map<String, Value>,
    /// What bears on the numbers: reactions that are not unique, say.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    samples: Vec<Sample>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
}

#[derive(Serialize)]
struct EventJson {
    t: f64,
    kind: String,
    supports: Vec<&'static str>,
    state: Map<String, Value>,
    energy: Map<String, Value>,
    reactions: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    friction: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    impulses: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    friction_impulses: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    joint_impulses: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    outputs: Map<String, Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    before: Option<BeforeJson>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// What an impact or an impulse found.
#[derive(Serialize)]
struct BeforeJson {
    state: Map<String, Value>,
    energy: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    outputs: Map<String, Value>,
}

/// The motion at a time that was asked for.
#[derive(Serialize)]
struct Sample {
    t: f64,
    /// Whether it is the side before an impact or an impulse; the sample behind it has the side after.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    before: bool,
    state: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    outputs: Map<String, Value>,
}

/// What looks at the motion: coordinates and rates, then the outputs asked for.
pub fn columns(layout: &Layout, sampling: &Sampling) -> Vec<String> {
    layout.names_of_motion().chain(sampling.outputs().iter().cloned()).collect()
}

/// Model, parameters, events, final state and what else was asked for; the error of a run that stopped short.
pub fn text(
    model: &str,
    spec: &RunSpec,
    sampling: &Sampling,
    (record, rows): (&Trajectory, &[Row]),
    error: Option<&str>,
) -> Result<String, CommandError> {
    let size = record.layout().names_of_motion().count();
    let outputs = |values: &[f64]| -> Map<String, Value> {
        let values = values.get(size..).unwrap_or_default();
        sampling.outputs().iter().cloned().zip(values.iter().map(|value| Value::from(*value))).collect()
    };
    let sample = |row: &Row| Sample {
        t: row.t,
        before: row.is_before,
        state: named(record, row.values.get(..size).unwrap_or_default(), row.t),
        outputs: outputs(&row.values),
    };
    let largest = [largest(record, |event| &event.reactions), largest(record, |event| &event.impulses)];
    let event = |(k, event): (usize, &Event)| {
        let sides = [precedes_jump(record.events(), k), true];
        let [outputs, before] = sides.map(|is_before| outputs(&values_at(rows, event.t, is_before)));
        event_json(event, record, [outputs, before], largest)
    };
    let run = Run {
        model,
        parameters: spec.parameters.iter().map(|(name, value)| (name.clone(), Value::from(*value))).collect(),
        events: record.events().iter().enumerate().map(event).collect(),
        final_state: state(record, &record.final_state(), record.end_time()),
        notes: run_notes(record),
        samples: rows.iter().filter(|row| row.is_requested).map(sample).collect(),
        error,
    };
    pretty(&run)
}

/// A value as JSON for people too, with the end of its last line.
pub fn pretty(value: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(value);
    text.map(|text| text + "\n").map_err(|error| CommandError::Failed(error.to_string()))
}

fn event_json(
    event: &Event,
    record: &Trajectory,
    [outputs, outputs_before]: [Map<String, Value>; 2],
    largest: [f64; 2],
) -> EventJson {
    let before = event.before.as_ref().map(|before| BeforeJson {
        state: state(record, &before.state, event.t),
        energy: energy(record, before.energy),
        outputs: outputs_before,
    });
    EventJson {
        t: event.t,
        kind: event.kind.to_string(),
        supports: event.supports.clone(),
        state: state(record, &event.state, event.t),
        energy: energy(record, event.energy),
        reactions: by_support(&event.reactions, normal, largest[0]),
        friction: by_support(&event.reactions, friction, largest[0]),
        impulses: by_support(&event.impulses, normal, largest[1]),
        friction_impulses: by_support(&event.impulses, friction, largest[1]),
        joint_impulses: joint_impulses(record, event, largest[1]),
        outputs,
        before,
        note: event.note.as_ref().map(ToString::to_string),
    }
}

fn joint_impulses(record: &Trajectory, event: &Event, largest: f64) -> Map<String, Value> {
    let all = record.joint_impulses(event).into_iter();
    all.map(|(name, value)| (name.to_owned(), Value::from(unrounded(value, largest)))).collect()
}

fn normal(reaction: &Reaction) -> Option<f64> {
    Some(reaction.value)
}

fn friction(reaction: &Reaction) -> Option<f64> {
    reaction.friction
}

/// What there is of them, by name, zero in place of what is rounding beside the largest of the run.
fn by_support(all: &[Reaction], of: fn(&Reaction) -> Option<f64>, largest: f64) -> Map<String, Value> {
    let value = |r: &Reaction| Some((r.label.to_owned(), Value::from(unrounded(of(r)?, largest))));
    all.iter().filter_map(value).collect()
}

fn largest<'a>(record: &'a Trajectory, of: fn(&'a Event) -> &'a [Reaction]) -> f64 {
    let values = record.events().iter().flat_map(of).map(|r| r.value.abs());
    values.filter(|value| value.is_finite()).fold(0.0, f64::max)
}

/// T, V and their sum.
fn energy(record: &Trajectory, Energy { kinetic, potential }: Energy<f64>) -> Map<String, Value> {
    let unit = record.scales().force() * record.scales().length;
    let all = [("T", kinetic), ("V", potential), ("E", kinetic + potential)];
    all.into_iter().map(|(name, value)| (name.to_owned(), Value::from(unrounded(value, unit)))).collect()
}

/// Coordinates by name, then rates with a prime; those that follow them behind, and what of
/// supports a start there must say.
fn state(record: &Trajectory, state: &[f64], t: f64) -> Map<String, Value> {
    named(record, &record.with_dependent(state), t)
}

fn named(record: &Trajectory, values: &[f64], t: f64) -> Map<String, Value> {
    let names = record.layout().names_of_motion();
    let motion = names.zip(record.unrounded(values)).map(|(name, value)| (name, Value::from(value)));
    let below = record.find_below(values, t).into_iter();
    motion.chain(below.map(|support| (format!("below({support})"), Value::from(1.0)))).collect()
}
