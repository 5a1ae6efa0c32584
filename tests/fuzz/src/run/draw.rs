//! Runs from seeds.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use liftoff_core::model::{Coordinate, Form, Layout};
use liftoff_models::models;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, MethodId};
use liftoff_studio::run_spec::{PointImpulse, Values};
use liftoff_tests::random::Source;

use super::relation::{self, Relation};
use super::task::Task;

/// As near to a special value as a start may be without being it.
const NEAR: [f64; 4] = [1e-8, -1e-8, 1e-12, -1e-5];

pub(super) fn task(source: &mut Source) -> Task {
    let all: Vec<&'static Entry> = models().iter().collect();
    let model = source.choose(&all);
    let mut spec = model.default_run();
    parameters(model.layout(), &mut spec.parameters, source);
    let units = model.units(&RunSpec::with(&[]).parameters_of(&spec)).unwrap_or([1.0; 3]);
    if source.chance(0.85) {
        spec.energy_of.clear();
        start(model.layout(), &mut spec.start, units, source);
    }
    plan(model.layout(), &mut spec, units, source);
    spec.tolerance = digits(10f64.powf(source.range(-13.0, -4.0)));
    let form = if source.chance(0.15) { Form::Multipliers } else { Form::Reduced };
    let mut task =
        Task { model, spec, method: source.choose(&MethodId::ALL), form, relation: Relation::None };
    task.relation = relation::draw(&task, source);
    task
}

/// The parameters of a run.
trait ParametersOf {
    fn parameters_of(self, other: &RunSpec) -> Self;
}

impl ParametersOf for RunSpec {
    fn parameters_of(self, other: &RunSpec) -> Self {
        Self { parameters: other.parameters.clone(), ..self }
    }
}

/// Mostly as they are or some times that, often by powers of ten up to nine, now and then by any
/// that doubles have.
fn parameters(layout: &Layout, values: &mut Values, source: &mut Source) {
    if values.is_empty() {
        return;
    }
    match source.below(20) {
        0..9 => {}
        9..15 => {
            for (_, value) in values.iter_mut() {
                if source.chance(0.5) {
                    *value = digits(*value * source.range(-1.2, 1.2).exp());
                }
            }
        }
        15..18 => {
            let at = source.below(values.len());
            values[at].1 *= source.choose(&[1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9]);
        }
        18 => {
            let at = source.below(values.len());
            values[at].1 *= 10f64.powf(source.range(-300.0, 300.0));
        }
        _ => values.iter_mut().for_each(|(_, value)| *value *= source.choose(&[1e-9, 1e-3, 1.0, 1e3, 1e9])),
    }
    for (name, value) in values {
        let ratio = layout.parameters.iter().position(|known| known == name);
        let restitution = ratio.is_some_and(|i| layout.dimensions[i].is_some_and(|d| d.numerators == [0; 3]));
        if restitution && source.chance(0.7) {
            let any = source.unit();
            *value = source.choose(&[0.0, 0.5, 0.999, 1.0, any, any]);
        }
    }
}

/// A number with so few digits that it can be read.
fn digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// Some coordinates and rates; the others follow.
fn start(layout: &Layout, values: &mut Values, [length, time, _]: [f64; 3], source: &mut Source) {
    let given = std::mem::take(values);
    let nudged = source.chance(0.2);
    let share = source.choose(&[0.2, 0.6, 1.0]);
    for coordinate in layout.coordinates {
        let unit = if coordinate.is_angle { 1.0 } else { length };
        let old = given.iter().find(|(name, _)| name == coordinate.name).map(|(_, value)| *value);
        if nudged {
            if let Some(old) = old {
                values.push((
                    coordinate.name.to_owned(),
                    old + unit * source.choose(&[0.0, 1e-8, -1e-8, 0.1, -0.2]),
                ));
            }
        } else if source.chance(share) {
            values.push((coordinate.name.to_owned(), unit * position(coordinate, source)));
        }
        if source.chance(0.45) {
            values.push((format!("{}'", coordinate.name), unit / time * rate(source)));
        }
    }
}

fn position(coordinate: &Coordinate, source: &mut Source) -> f64 {
    let special = if coordinate.is_angle {
        [
            0.0,
            FRAC_PI_2,
            PI,
            -FRAC_PI_2,
            FRAC_PI_4,
            2.0 * PI / 3.0,
            0.1,
            (source.below(13) as f64 - 4.0) * FRAC_PI_2,
        ]
    } else {
        [0.0, 0.0, 0.5, 1.0, -0.5, 0.1, 2.0, 0.3]
    };
    let near = source.choose(&NEAR);
    match source.below(10) {
        0..4 => source.choose(&special),
        4 => source.choose(&special) + near,
        5 => source.range(-30.0, 30.0),
        _ if coordinate.is_angle => source.range(-3.3, 3.3),
        _ => source.range(-1.0, 2.0),
    }
}

fn rate(source: &mut Source) -> f64 {
    let any = source.range(-1.0, 1.0);
    match source.below(12) {
        0..3 => 0.0,
        3 => source.choose(&NEAR),
        4 => source.choose(&[1.0, -1.0]),
        5 => source.choose(&[30.0, -100.0, 1e3]),
        6..10 => 3.0 * any,
        _ => 10.0 * any,
    }
}

/// When it ends, and what is done to it.
fn plan(layout: &'static Layout, spec: &mut RunSpec, [length, time, mass]: [f64; 3], source: &mut Source) {
    spec.limit = Some(digits(time * source.choose(&[0.5, 2.0, 5.0, 10.0])));
    if source.chance(0.7) {
        spec.until.clear();
    }
    if source.chance(0.5) {
        (spec.hold, spec.release, spec.cut) = (Vec::new(), Vec::new(), Vec::new());
    }
    let supports: Vec<&str> = layout.contacts.iter().flat_map(|contact| contact.supports).copied().collect();
    if !supports.is_empty() && source.chance(0.05) {
        spec.hold.push(source.choose(&supports).to_owned());
    }
    if !supports.is_empty() && source.chance(0.05) {
        spec.release.push((source.choose(&supports).to_owned(), digits(time * source.range(0.0, 3.0))));
    }
    if !layout.points.is_empty() && source.chance(0.05) {
        let unit = mass * length / time;
        let impulse = [source.range(-2.0, 2.0), source.choose(&[0.0, 1.0, -1.0])].map(|p| digits(p * unit));
        let at = digits(time * source.range(0.0, 3.0));
        spec.impulses.push(PointImpulse { point: source.choose(layout.points).to_owned(), impulse, at });
    }
}
