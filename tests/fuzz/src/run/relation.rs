//! Another way to the same motion.

use std::{iter, slice};

use liftoff::Trajectory;
use liftoff_core::model::{Form, Layout};
use liftoff_models::models;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Dimension, MethodId};
use liftoff_studio::run_spec::{PointImpulse, Values};
use liftoff_tests::random::Source;

use super::compare::{Course, converged, paired, parts_from, same, struck_in_turn};
use super::task::Task;
use crate::Finding;
use crate::subject::Fate;

/// What must agree with a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relation {
    /// Nothing: it is looked at by itself.
    None,
    /// The run by another method.
    Method(MethodId),
    /// The run in the other form.
    Form,
    /// The run in units of length, time and mass larger by these powers of two.
    Units([i32; 3]),
    /// The run stopped at this part of its time, and started again from there.
    Split(f64),
    /// The model that has both halves of a symmetric one.
    Halves,
}

/// A symmetric model, its full one, and the coordinates of the full one by those of the half.
type Half = (&'static str, &'static str, &'static [(&'static str, &'static str)]);

/// Symmetric models, with those that have both halves, and which coordinates of these are those.
const HALVES: [Half; 2] = [
    ("falling-pair", "falling-pair-full", &[("phi_left", "phi"), ("phi_right", "phi"), ("y", "y")]),
    (
        "zigzag",
        "zigzag-full",
        &[
            ("phi_ab", "phi_outer"),
            ("phi_bc", "phi_inner"),
            ("phi_cd", "phi_inner"),
            ("phi_de", "phi_outer"),
            ("y", "y"),
        ],
    ),
];

/// Times of other units are the same to so much.
const UNITS: f64 = 1e-10;
/// Two ways that agree to so many tolerances need no second look.
const AT_ONCE: f64 = 100.0;
/// Two ways that differ by less than this, or by so many of their finer tolerances, are the same.
const FLOOR: f64 = 1e-9;
const AGREED: f64 = 10.0;
/// The finest tolerance of a comparison, and how much coarser the other one is.
const FINEST: f64 = 1e-13;
const COARSER: f64 = 30.0;

/// Gaps at a start below this in natural lengths are closed, or below ten tolerances; below the
/// other they are zero.
const CLOSED: f64 = 1e-10;
const ROUNDED: f64 = 1e-14;

/// By how much the first bar of a neighbour of a symmetric motion is turned, rad.
const NUDGE: f64 = 1e-8;

/// For half of the runs, one that fits.
pub(super) fn draw(task: &Task, source: &mut Source) -> Relation {
    let spec = &task.spec;
    let free = spec.until.is_empty() && spec.cut.is_empty();
    let alone = free && spec.release.is_empty() && spec.impulses.is_empty();
    let other = source.choose(&MethodId::ALL);
    let power = [0; 3].map(|_: i32| source.choose(&[-30, -10, 0, 2, 30]));
    if !free || task.is_wild() {
        return Relation::None;
    }
    match source.below(12) {
        0 | 1 if other != task.method => Relation::Method(other),
        2 if task.model.layout().closed_forms.iter().len() > 0 => Relation::Form,
        3 | 4 if task.model.dimensions().is_some() => Relation::Units(power),
        5 if alone && !reads_time(task.model.layout()) => Relation::Split(source.range(0.05, 0.95)),
        _ if alone && spec.hold.is_empty() && half(task).is_some() => Relation::Halves,
        _ => Relation::None,
    }
}

/// Whether the motion is the same by the other way too.
///
/// # Errors
/// It is another.
pub(super) fn check(task: &Task, run: &Trajectory) -> Result<Fate, Finding> {
    let seen = |fate: &'static str| Ok(vec![fate]);
    let whole = course(task, run);
    if task.relation == Relation::None {
        return Ok(Vec::new());
    }
    let Some(other) = other_way(task, run) else {
        return match task.relation {
            Relation::Units(powers) => Err(Finding(format!("in other units: {}", refusal(task, powers)))),
            _ => seen("not compared: the other way is refused or stops"),
        };
    };
    let [whole, other] = paired([whole, other]);
    if let Relation::Units(_) = task.relation {
        return same([&whole, &other], UNITS).map(|()| vec!["compared: units"]);
    }
    let tolerance = task.spec.tolerance;
    let within = AT_ONCE * tolerance.max(1e-12);
    if same([&whole.united(within), &other.united(within)], within).is_ok() {
        return seen(word(task.relation));
    }
    let fine = FINEST.max(tolerance / COARSER);
    let ways = |task: Task| {
        let run = task.run()?;
        let within = AT_ONCE * task.spec.tolerance.max(1e-11);
        let other = other_way(&task, &run)?;
        let known = unstable_from(&task, &run).unwrap_or(f64::INFINITY);
        let other = other.until(known).united(within);
        Some(paired([course(&task, &run).united(within), other]))
    };
    let (Some(known), Some(coarse)) =
        (ways(task.with_tolerance(fine)), ways(task.with_tolerance(fine * COARSER)))
    else {
        return seen("not compared: a second tolerance is refused or stops");
    };
    let floor = FLOOR.max(AGREED * fine);
    let by_tolerance = converged(&known, slice::from_ref(&coarse), floor);
    by_tolerance
        .or_else(|_| {
            let rounded =
                [1.0, -1.0].into_iter().filter_map(|sign| ways(task.with_tolerance(fine).rounded(sign)));
            converged(&known, &iter::once(coarse).chain(rounded).collect::<Vec<_>>(), floor)
        })
        .map(|()| vec![word(task.relation)])
}

/// Why a run in other units is refused or stops.
fn refusal(task: &Task, powers: [i32; 3]) -> String {
    let Some(spec) = in_units(task, powers.map(|power| 2f64.powi(power))) else {
        return "a dimension has another power than halves".to_owned();
    };
    match task.with_spec(spec).simulation().map(|simulation| simulation.run()) {
        Err(error) => error.to_string(),
        Ok(Err(error)) => error.cause().to_string(),
        Ok(Ok(_)) => "not a second time".to_owned(),
    }
}

fn word(relation: Relation) -> &'static str {
    match relation {
        Relation::None => "not compared",
        Relation::Method(_) => "compared: method",
        Relation::Form => "compared: form",
        Relation::Units(_) => "compared: units",
        Relation::Split(_) => "compared: split",
        Relation::Halves => "compared: halves",
    }
}

/// Whether a motion depends on when it begins.
fn reads_time(layout: &Layout) -> bool {
    let contacts = layout.contacts.iter().filter_map(|contact| contact.armed);
    let loads = layout.switches.iter().map(|switch| switch.condition);
    let names_it =
        |text: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == "t");
    layout.timed || contacts.chain(loads).any(names_it)
}

/// What of a run has a counterpart in the other one.
fn course(task: &Task, run: &Trajectory) -> Course {
    let whole = Course::from_run(run, 1.0, 0.0);
    match task.relation {
        Relation::Split(part) => whole.after(part * run.end_time()),
        Relation::Halves => whole.nameless(),
        _ => whole,
    }
}

/// The motion by the other way, in the times of the run.
fn other_way(task: &Task, run: &Trajectory) -> Option<Course> {
    let form = match task.form {
        Form::Reduced => Form::Multipliers,
        Form::Multipliers => Form::Reduced,
    };
    match task.relation {
        Relation::None => None,
        Relation::Method(method) => Some(Course::from_run(&Task { method, ..task.clone() }.run()?, 1.0, 0.0)),
        Relation::Form => Some(Course::from_run(&Task { form, ..task.clone() }.run()?, 1.0, 0.0)),
        Relation::Units(powers) => {
            let units = powers.map(|power| 2f64.powi(power));
            Some(Course::from_run(&task.with_spec(in_units(task, units)?).run()?, 1.0 / units[1], 0.0))
        }
        Relation::Split(part) => {
            let at = part * run.end_time();
            let limit = task.spec.limit.map(|limit| limit - at);
            let start = named(task, run, &run.state(at));
            let rest = RunSpec { start, limit, energy_of: Vec::new(), ..task.spec.clone() };
            let rest = task.with_spec(rest).run()?;
            let course = Course::from_run(&rest, 1.0, at).after(at);
            Some(if closes_alike(run, &rest, at) { course } else { course.until(at) })
        }
        Relation::Halves => Some(Course::from_run(&both_halves(task, run)?.run()?, 1.0, 0.0).nameless()),
    }
}

/// Whether a run that starts from a state of another has the same contacts closed: one that is open
/// by no more than the bound of a start is closed there, or is not seen to close.
fn closes_alike(run: &Trajectory, rest: &Trajectory, at: f64) -> bool {
    let before = run.segments().into_iter().find(|segment| (segment.t0..=segment.t1).contains(&at));
    let behind = rest.segments().into_iter().next();
    let bound = 10.0 * run.tolerance().max(rest.tolerance()) * run.scales().length;
    let gaps = gaps(run, &run.state(at), at);
    let mut near = (0..gaps.len()).filter(|&contact| gaps[contact].abs() <= bound);
    before.zip(behind).is_none_or(|(before, behind)| {
        before.closed == behind.closed && near.all(|contact| before.set.contains(contact))
    })
}

/// Those of all contacts.
fn gaps(run: &Trajectory, state: &[f64], t: f64) -> Vec<f64> {
    let equations = run.model().system.equations(&run.layout().state_at(state, t));
    equations.gap()[..run.layout().contacts.len()].to_vec()
}

/// The run of the model that has both halves; none where it hangs on the bound of a start.
fn both_halves(task: &Task, run: &Trajectory) -> Option<Task> {
    let (_, full, coordinates) = half(task)?;
    let start = run.events().first()?;
    let bound = CLOSED.max(10.0 * run.tolerance()) * run.scales().length;
    let rounding = ROUNDED * run.scales().length;
    // Which of these are closed, and how the pose moves for it, each model decides by itself.
    if gaps(run, &start.state, start.t).iter().any(|gap| (rounding..2.0 * bound).contains(&gap.abs())) {
        return None;
    }
    let state = named(task, run, &start.state);
    let value = |name: &str| state.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let mut start = vec![("x".to_owned(), 0.0), ("x'".to_owned(), 0.0)];
    for (name, own) in *coordinates {
        start.push(((*name).to_owned(), value(own)?));
        start.push((format!("{name}'"), value(&format!("{own}'"))?));
    }
    let spec = RunSpec { start, energy_of: Vec::new(), ..task.spec.clone() };
    Some(Task { model: models().find(full).ok()?, spec, ..task.clone() })
}

/// From when the other way is one of rounding: a symmetric motion from which one parts that starts
/// beside it.
fn unstable_from(task: &Task, run: &Trajectory) -> Option<f64> {
    let whole = (task.relation == Relation::Halves).then(|| both_halves(task, run))??;
    let mut beside = whole.clone();
    let turned = beside.spec.start.iter_mut().find(|(name, _)| *name != "x" && *name != "x'")?;
    turned.1 += NUDGE;
    let run = whole.run()?;
    let parts = beside.run().map_or(f64::INFINITY, |beside| parts_from([&run, &beside], NUDGE));
    Some(parts.min(struck_in_turn(&run)))
}

fn half(task: &Task) -> Option<&'static Half> {
    HALVES.iter().find(|(symmetric, ..)| *symmetric == task.model.name())
}

/// A state as values of a start. What is below the rounding of its unit in the run is zero: by
/// itself it would be the largest length that a model without any has.
fn named(task: &Task, run: &Trajectory, state: &[f64]) -> Values {
    let all = task.model.layout().names_of_state();
    let units = run.scales().state(run.layout());
    let rounded = |(i, value): (usize, &f64)| {
        if value.abs() < f64::EPSILON * units[i] { 0.0 } else { *value }
    };
    all.zip(run.layout().public_state(state).iter().enumerate().map(rounded)).collect()
}

/// The same run with its numbers in units so much smaller; none where a dimension has another power
/// than halves.
fn in_units(task: &Task, units: [f64; 3]) -> Option<RunSpec> {
    let dimensions = task.model.dimensions()?;
    let layout = task.model.layout();
    let unit = |dimension: Dimension| -> f64 {
        dimension.iter().zip(units).map(|(p, unit)| unit.powf(*p)).product()
    };
    let mut spec = task.spec.clone();
    for (name, value) in &mut spec.parameters {
        let place = layout.parameters.iter().position(|known| known == name)?;
        *value *= unit(dimensions[place]);
    }
    for (name, value) in spec.start.iter_mut().chain(&mut spec.energy_of) {
        let bare = name.trim_end_matches('\'');
        let coordinate = layout.coordinates.iter().find(|known| known.name == bare)?;
        let length = if coordinate.is_angle { 0.0 } else { 1.0 };
        *value *= unit([length, if bare == name { 0.0 } else { -1.0 }, 0.0]);
    }
    let time = units[1];
    spec.release.iter_mut().for_each(|(_, at)| *at *= time);
    spec.limit = spec.limit.map(|limit| limit * time);
    for PointImpulse { impulse, at, .. } in &mut spec.impulses {
        *impulse = impulse.map(|p| p * unit([1.0, -1.0, 1.0]));
        *at *= time;
    }
    Some(spec)
}
