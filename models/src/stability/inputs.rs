//! What is no number is refused at once, by its name.

use crate::{BouncingBall, models};
use liftoff::catalog::{Failure, Integrator, Model, Record, run};
use liftoff::scene::{Blow, Setup};
use liftoff::stability::Case;
use liftoff::stability::Effort;
use liftoff::stability::{Answer, Expected};

const NONE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

pub(super) fn cases(_: Integrator, _: Effort) -> Vec<Case> {
    let parameters = models().iter().map(|model| all("parameters", model, parameters));
    let starts = models().iter().map(|model| all("start", model, starts));
    let others = [tolerance(), limit(), release(), impulse(), condition()];
    parameters.chain(starts).chain(others).collect()
}

/// A setup, and what its refusal has to name.
type Bad = (Setup, String);

fn parameters(model: &dyn Model) -> Vec<Bad> {
    let setup = model.setup();
    let each = 0..setup.parameters.len();
    let spoilt = each.flat_map(|i| NONE.map(|value| (i, value)));
    let bad = |(i, value): (usize, f64)| {
        let mut setup = setup.clone();
        setup.parameters[i].1 = value;
        let name = format!("parameter `{}` is {value}", setup.parameters[i].0);
        (setup, name)
    };
    spoilt.map(bad).collect()
}

/// Every coordinate and rate.
fn starts(model: &dyn Model) -> Vec<Bad> {
    let setup = model.setup();
    let coordinates = model.layout().coordinates.iter().map(|coordinate| coordinate.name);
    let names = coordinates.flat_map(|name| [name.to_owned(), format!("{name}'")]);
    let spoilt = names.flat_map(|name| NONE.map(|value| (name.clone(), value)));
    let bad = |(name, value): (String, f64)| {
        let mut setup = setup.clone();
        setup.start.retain(|(known, _)| *known != name);
        setup.start.push((name.clone(), value));
        (setup, format!("`{name}` starts at {value}"))
    };
    spoilt.map(bad).collect()
}

/// All of a model's bad setups in one case.
fn all(what: &str, model: &'static dyn Model, bad: fn(&dyn Model) -> Vec<Bad>) -> Case {
    let name = model.name();
    let count = bad(model).len();
    let scene = format!("{name}: each of its {what} NaN, ∞ and −∞");
    let expected = Expected::Answer { said: format!("{count} refused by name"), wants: Vec::new() };
    Case::new(format!("inputs.{what} of {name}"), scene, "mechanics", expected, move |_| {
        let escaped = bad(model).into_iter().find_map(|(setup, name)| escaped(model.run(&setup), &name));
        let said = escaped.unwrap_or_else(|| format!("{count} refused by name"));
        Ok(Answer { said, numbers: Vec::new() })
    })
}

/// What happened instead of a refusal that says this.
fn escaped(outcome: Result<Box<dyn Record>, Failure>, name: &str) -> Option<String> {
    match outcome {
        Err(Failure::Input(text)) if text.contains(name) => None,
        Err(failure) => Some(format!("{name}: {failure}")),
        Ok(_) => Some(format!("{name}: it runs")),
    }
}

fn ball() -> Setup {
    Setup::with(&[("m", 1.0), ("g", 1.0), ("e", 0.5)]).start(&[("y", 1.0), ("x", 0.0)])
}

/// Each value is refused with this text.
fn each(what: &str, values: &'static [f64], text: &'static str, setup: fn(f64) -> Setup) -> Case {
    let said = format!("{} refused", values.len());
    let expected = Expected::Answer { said: said.clone(), wants: Vec::new() };
    let scene = format!("bouncing-ball with {what} of {values:?}");
    Case::new(format!("inputs.{what}"), scene, "mechanics", expected, move |by| {
        let escaped = values.iter().find_map(|&value| escaped(run::<BouncingBall>(by, &setup(value)), text));
        Ok(Answer { said: escaped.unwrap_or(said), numbers: Vec::new() })
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
        let blow = Blow { point: "P".into(), impulse: [0.0, value], at: 0.1 };
        Setup { impulses: vec![blow], ..ball() }
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
