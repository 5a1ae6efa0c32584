//! What a run of a model takes where nothing is said.

use crate::output::style::{LABEL, styled};
use liftoff_core::model::Layout;
use liftoff_studio::explain::meanings;
use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::{PointImpulse, RunSpec, Values};
use std::fmt::Write;

/// The default run, line by line: what it is, and the value.
pub fn lines(model: &Entry) -> Vec<(&'static str, String)> {
    let spec = model.default_run();
    let lines = [
        ("parameters", parameters(model)),
        ("start", start(&spec)),
        ("until", listed(&spec.until, " or ", Clone::clone)),
        ("limit", limit(model, &spec)),
        ("tolerance", format!("{:e}", spec.tolerance)),
        ("held", spec.hold.join(", ")),
        ("released", listed(&spec.release, ", ", |(support, at)| format!("{support} at t = {at}"))),
        ("cut", listed(&spec.cut, ", ", |(thread, condition)| format!("{thread} at {condition}"))),
        ("impulses", listed(&spec.impulses, ", ", impulse)),
        ("impacts", if spec.stop_at_impacts { "end the run".to_owned() } else { String::new() }),
    ];
    lines.into_iter().filter(|(_, value)| !value.is_empty()).collect()
}

/// The lines as a block of a help or a list.
pub fn block(model: &Entry) -> String {
    lines(model).iter().fold(String::new(), |mut text, (label, value)| {
        let _ = writeln!(text, "  {} {value}", styled(LABEL, &format!("{label:<11}")));
        text
    })
}

/// What coordinates measure, with their units: `phi (rad): angle of AB from the right`.
pub fn measured(layout: &Layout) -> String {
    let meanings = meanings(layout).unwrap_or_default();
    let one = |(i, name): (usize, &'static str)| {
        let unit = if layout.is_angle(name) { "rad" } else { "m" };
        match meanings.get(i) {
            Some(meaning) => format!("{name} ({unit}): {meaning}"),
            None => format!("{name} ({unit})"),
        }
    };
    layout.names_of_positions().enumerate().map(one).collect::<Vec<_>>().join("; ")
}

/// With their defaults, where the model has a default run, and their units, where it declares them.
pub fn parameters(model: &Entry) -> String {
    let (layout, defaults) = (model.layout(), model.default_run().parameters);
    let one = |(i, name): (usize, &&str)| {
        let unit = layout.defaults.unit(i);
        match defaults.iter().find(|(known, _)| known == name) {
            Some((_, value)) => format!("{name} = {value} {unit}").trim_end().to_owned(),
            None => (*name).to_owned(),
        }
    };
    layout.parameters.iter().enumerate().map(one).collect::<Vec<_>>().join(", ")
}

fn start(spec: &RunSpec) -> String {
    let told = |values: &Values| listed(values, ", ", |(name, value)| format!("{name} = {value}"));
    let level = match told(&spec.energy_of) {
        pose if pose.is_empty() => String::new(),
        pose => format!(" with the energy of {pose} at rest"),
    };
    match told(&spec.start) {
        start if start.is_empty() => format!("the nominal figure{level}"),
        start => start + &level,
    }
}

/// The latest end.
fn limit(model: &Entry, spec: &RunSpec) -> String {
    match (spec.limit, model.simulation(spec)) {
        (Some(limit), _) => format!("t = {limit}"),
        (None, Ok(simulation)) => format!("t = {:.4}", simulation.time_limit()),
        (None, Err(_)) => "a thousand natural times".to_owned(),
    }
}

fn impulse(PointImpulse { point, impulse: [x, y], at }: &PointImpulse) -> String {
    format!("({x}, {y}) N s at {point} at t = {at}")
}

fn listed<T>(values: &[T], between: &str, one: impl Fn(&T) -> String) -> String {
    values.iter().map(one).collect::<Vec<_>>().join(between)
}
