//! `liftoff run --json`.

use crate::CommandError;
use crate::options::sampling::Sampling;

use liftoff::Trajectory;
use liftoff::{Event, Reaction};
use liftoff_studio::run_spec::RunSpec;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Serialize)]
struct Run<'a> {
    model: &'a str,
    parameters: Map<String, Value>,
    events: Vec<EventJson>,
    final_state: Map<String, Value>,
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
    reactions: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    impulses: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    outputs: Map<String, Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// The motion at a time that was asked for.
#[derive(Serialize)]
struct Sample {
    t: f64,
    state: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    outputs: Map<String, Value>,
}

/// The outputs asked for, at a time.
type Outputs<'a> = &'a dyn Fn(f64) -> Map<String, Value>;

/// Model, parameters, events, final state and what else was asked for; the error of a run that stopped short.
pub fn text(
    model: &str,
    spec: &RunSpec,
    sampling: &Sampling,
    record: &Trajectory,
    error: Option<&str>,
) -> Result<String, CommandError> {
    let values: Result<Vec<_>, _> = sampling.outputs().iter().map(|text| record.function(text)).collect();
    let values = values?;
    let outputs = |t: f64| {
        let named = sampling.outputs().iter().zip(&values);
        named.map(|(name, value)| (name.clone(), Value::from(value(t)))).collect()
    };
    let sample = |t| Sample { t, state: state(record, &record.state(t)), outputs: outputs(t) };
    let run = Run {
        model,
        parameters: spec.parameters.iter().map(|(name, value)| (name.clone(), Value::from(*value))).collect(),
        events: record.events().iter().map(|event| event_json(event, record, &outputs)).collect(),
        final_state: state(record, &record.state(record.interval()[1])),
        samples: sampling.times(record.interval())?.into_iter().map(sample).collect(),
        error,
    };
    let text = serde_json::to_string_pretty(&run).map_err(|error| CommandError::Failed(error.to_string()))?;
    Ok(text + "\n")
}

fn event_json(event: &Event, record: &Trajectory, outputs: Outputs) -> EventJson {
    EventJson {
        t: event.t,
        kind: event.kind.to_string(),
        supports: event.supports.clone(),
        state: state(record, &event.state),
        reactions: by_support(&event.reactions),
        impulses: by_support(&event.impulses),
        outputs: outputs(event.t),
        note: event.note.as_ref().map(ToString::to_string),
    }
}

fn by_support(values: &[Reaction]) -> Map<String, Value> {
    values.iter().map(|r| (r.label.clone(), Value::from(r.value))).collect()
}

/// Coordinates by name, then rates with a prime.
fn state(record: &Trajectory, values: &[f64]) -> Map<String, Value> {
    let names = record.layout().coordinates.iter().map(|coordinate| coordinate.name);
    let rates = names.clone().map(|name| format!("{name}'"));
    let all = names.map(str::to_owned).chain(rates);
    all.zip(values).map(|(name, value)| (name, Value::from(*value))).collect()
}
