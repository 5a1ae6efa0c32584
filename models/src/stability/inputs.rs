//! What is no number is refused at once, by its name.

use super::run;
use crate::models;
use liftoff::Trajectory;
use liftoff_studio::registry::{Entry, MethodId, MotionError};
use liftoff_studio::run_spec::{PointImpulse, RunSpec};
use liftoff_verification::cases::{Answer, Case, Effort, Expected};

const NONE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let parameters = models().iter().map(|model| all("parameters", model, parameters));
    let starts = models().iter().map(|model| all("start", model, starts));
    let others = [tolerance(), limit(), release(), impulse(), condition()];
    parameters.chain(starts).chain(others).collect()
}

/// A run, and what its refusal has to name.
type Bad = (RunSpec, String);

fn parameters(model: &Entry) -> Vec<Bad> {
    let spec = model.default_run();
    let each = 0..spec.parameters.len();
    let spoilt = each.flat_map(|i| NONE.map(|value| (i, value)));
    let bad = |(i, value): (usize, f64)| {
        let mut spec = spec.clone();
        spec.parameters[i].1 = value;
        let name = format!("parameter `{}` is {value}", spec.parameters[i].0);
        (spec, name)
    };
    spoilt.map(bad).collect()
}

/// Every coordinate and rate.
fn starts(model: &Entry) -> Vec<Bad> {
    let spec = model.default_run();
    let coordinates = model.layout().coordinates.iter().map(|coordinate| coordinate.name);
    let names = coordinates.flat_map(|name| [name.to_owned(), format!("{name}'")]);
    let spoilt = names.flat_map(|name| NONE.map(|value| (name.clone(), value)));
    let bad = |(name, value): (String, f64)| {
        let mut spec = spec.clone();
        spec.start.retain(|(known, _)| *known != name);
        spec.start.push((name.clone(), value));
        (spec, format!("`{name}` starts at {value}"))
    };
    spoilt.map(bad).collect()
}

/// All of a model's bad runs in one case.
fn all(what: &str, model: &'static Entry, bad: fn(&Entry) -> Vec<Bad>) -> Case {
    let name = model.name();
    let count = bad(model).len();
    let scene = format!("{name}: each of its {what} NaN, ∞ and −∞");
    let expected = Expected::Answer { text: format!("{count} refused by name"), expectations: Vec::new() };
    Case::new(format!("inputs.{what} of {name}"), scene, "mechanics", expected, move |_| {
        let escaped = bad(model).into_iter().find_map(|(spec, name)| escaped(model.run(&spec), &name));
        let outcome = escaped.unwrap_or_else(|| format!("{count} refused by name"));
        Ok(Answer { text: outcome, numbers: Vec::new() })
    })
}

/// What happened instead of a refusal that says this.
fn escaped(outcome: Result<Trajectory, MotionError>, name: &str) -> Option<String> {
    match outcome {
        Err(MotionError::Input(text)) if text.contains(name) => None,
        Err(failure) => Some(format!("{name}: {failure}")),
        Ok(_) => Some(format!("{name}: it runs")),
    }
}

fn ball() -> RunSpec {
    RunSpec::with(&[("m", 1.0), ("g", 1.0), ("e", 0.5)]).start(&[("y", 1.0), ("x", 0.0)])
}

/// Each value is refused with this text.
fn each(what: &str, values: &'static [f64], text: &'static str, spec: fn(f64) -> RunSpec) -> Case {
    let outcome = format!("{} refused", values.len());
    let expected = Expected::Answer { text: outcome.clone(), expectations: Vec::new() };
    let scene = format!("bouncing-ball with {what} of {values:?}");
    Case::new(format!("inputs.{what}"), scene, "mechanics", expected, move |by| {
        let escaped = values.iter().find_map(|&value| escaped(run("bouncing-ball", by, &spec(value)), text));
        Ok(Answer { text: escaped.unwrap_or(outcome), numbers: Vec::new() })
    })
}

fn tolerance() -> Case {
    const VALUES: [f64; 6] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, 1.0];
    each("a tolerance", &VALUES, "tolerance", |value| ball().tolerance(value))
}

fn limit() -> Case {
    const VALUES: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0];
    each("a time limit", &VALUES, "time limit", |value| ball().limit(value))
}

fn release() -> Case {
    const VALUES: [f64; 4] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0];
    each("a time of release", &VALUES, "released", |value| ball().release("P", value))
}

fn impulse() -> Case {
    each("an impulse", &NONE, "impulse", |value| {
        let blow = PointImpulse { point: "P".into(), impulse: [0.0, value], at: 0.1 };
        RunSpec { impulses: vec![blow], ..ball() }
    })
}

/// Conditions that hold always or never.
fn condition() -> Case {
    const VALUES: [f64; 4] = [f64::NAN, f64::NEG_INFINITY, -1.0, 0.0];
    each("a time to stop at", &VALUES, "cannot end a run", |value| match value {
        value if value.is_nan() => ball().until("t = 0 / 0"),
        value if value.is_infinite() => ball().until("t = -1 / 0"),
        value => ball().until(&format!("t = {value}")),
    })
}
