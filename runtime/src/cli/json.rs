//! `liftoff run --json`.

use super::CommandError;
use crate::Event;
use crate::Reaction;
use crate::catalog::Record;
use crate::scene::Setup;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Serialize)]
struct Run<'a> {
    model: &'a str,
    parameters: Map<String, Value>,
    events: Vec<Happened>,
    final_state: Map<String, Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
}

#[derive(Serialize)]
struct Happened {
    t: f64,
    kind: String,
    supports: Vec<&'static str>,
    state: Map<String, Value>,
    reactions: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    impulses: Map<String, Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// Model, parameters, events and final state; the error of a run that stopped short.
pub fn text(
    model: &str,
    setup: &Setup,
    record: &dyn Record,
    error: Option<&str>,
) -> Result<String, CommandError> {
    let run = Run {
        model,
        parameters: setup
            .parameters
            .iter()
            .map(|(name, value)| (name.clone(), Value::from(*value)))
            .collect(),
        events: record.events().iter().map(|event| happened(event, record)).collect(),
        final_state: state(record, &record.state(record.interval()[1])),
        error,
    };
    let text = serde_json::to_string_pretty(&run).map_err(|error| CommandError::Failed(error.to_string()))?;
    Ok(text + "\n")
}

fn happened(event: &Event, record: &dyn Record) -> Happened {
    Happened {
        t: event.t,
        kind: event.kind.to_string(),
        supports: event.supports.clone(),
        state: state(record, &event.state),
        reactions: by_support(&event.reactions),
        impulses: by_support(&event.impulses),
        note: event.note.clone(),
    }
}

fn by_support(values: &[Reaction]) -> Map<String, Value> {
    values.iter().map(|r| (r.label.clone(), Value::from(r.value))).collect()
}

/// Coordinates by name, then rates with a prime.
fn state(record: &dyn Record, values: &[f64]) -> Map<String, Value> {
    let names = record.layout().coordinates.iter().map(|coordinate| coordinate.name);
    let rates = names.clone().map(|name| format!("{name}'"));
    let all = names.map(str::to_owned).chain(rates);
    all.zip(values).map(|(name, value)| (name, Value::from(*value))).collect()
}
