//! Checks of the default run of any model.

mod energy;
mod events;
mod forms;
mod judge;
mod methods;
mod motion;
mod scaling;
mod tolerances;

use crate::registry::{Entry, MethodId, MotionError};
use crate::run_spec::RunSpec;
use liftoff::{LogEntry, LoggedDecision, Trajectory};
use liftoff_verification::cases::Case;
use liftoff_verification::cases::Effort;
use liftoff_verification::cases::event_summary::last;
use liftoff_verification::cases::{Answer, Expectation, Expected, at_most};
use liftoff_verification::judgement::witness;

/// Cases that any model's default run has.
#[derive(Debug)]
pub struct General {
    /// Name of the group, and first part of the ids of its cases.
    pub name: &'static str,
    /// Heading of the group on the page.
    pub title: &'static str,
    /// The cases of a model; empty if it has no default run or its default run does not move.
    pub cases: fn(&'static Entry, Effort) -> Vec<Case>,
}

/// Every general group.
pub const GENERAL: [General; 7] = [
    General { name: "motion", title: "What never moves", cases: motion::cases },
    General { name: "tolerances", title: "Errors against double-double", cases: tolerances::cases },
    General { name: "methods", title: "The same by every method", cases: methods::cases },
    General { name: "forms", title: "Closed form against multipliers", cases: forms::cases },
    General { name: "scaling", title: "The same in other units", cases: scaling::cases },
    General { name: "judge", title: "Before an independent judge", cases: judge::cases },
    General { name: "energy", title: "Energy where nothing drives or damps", cases: energy::cases },
];

/// Text if two runs have the same events.
const SAME: &str = "the same events";

/// Duration, in natural times, of a run that only tests whether the start is valid.
const INSTANT: f64 = 1e-6;

/// Number of equal parts of a run; reactions are compared at their midpoints.
const PARTS: usize = 32;

/// Tolerance of the reference runs.
const TIGHT: f64 = 1e-13;

/// Two runs to compare: whether events agree, and the differences of times, last states and contact
/// reactions, in natural units of the first. `units` are the units of the second run in those of
/// the first.
struct Pair<'a> {
    model: &'a Entry,
    natural: [f64; 3],
    units: [f64; 3],
}

impl Pair<'_> {
    fn compare(&self, one: &Trajectory, other: &Trajectory) -> Answer {
        match events::difference(one, other) {
            None => {
                let mut numbers = vec![self.late(one, other), self.apart(one, other)];
                if has_contacts(self.model) {
                    numbers.push(self.compare_reactions(one, other));
                }
                Answer { text: SAME.to_owned(), numbers }
            }
            Some(difference) => Answer { text: difference, numbers: Vec::new() },
        }
    }

    fn apart(&self, one: &Trajectory, other: &Trajectory) -> f64 {
        let coordinates = self.model.layout().coordinates;
        let ([length, time, _], [l, t, _]) = (self.natural, self.units);
        let powers = |k: usize| if coordinates[k % coordinates.len()].is_angle { 0 } else { 1 };
        let rate = |k: usize| if k < coordinates.len() { 0 } else { 1 };
        let (states, unit) = ((last(one), last(other)), |k| length.powi(powers(k)) / time.powi(rate(k)));
        let size = states.0.iter().enumerate().map(|(k, x)| x.abs() / unit(k));
        let size = size.fold(1.0, f64::max);
        let pairs = states.0.iter().zip(&states.1).enumerate();
        let apart = pairs.map(|(k, (a, b))| (b / (l.powi(powers(k)) / t.powi(rate(k))) - a).abs() / unit(k));
        largest(apart) / size
    }

    /// The largest difference of a reaction at the midpoints of [`PARTS`] equal parts, except
    /// midpoints between the two times of one event.
    fn compare_reactions(&self, one: &Trajectory, other: &Trajectory) -> f64 {
        let force = |[length, time, mass]: [f64; 3]| mass * length / (time * time);
        let (natural, unit, [_, time, _]) = (force(self.natural), force(self.units), self.units);
        let supports = self.model.layout().contacts.iter().flat_map(|contact| contact.supports);
        let names = supports.map(|support| format!("N({support})"));
        let outputs: Vec<_> = names.filter_map(|name| one.output(&name).ok()).collect();
        let [start, end] = one.interval();
        let middle = |k: usize| start + (end - start) * (k as f64 + 0.5) / PARTS as f64;
        let is_between = |t: f64| events::pairs(one, other).any(|(a, b)| (a.t - t) * (b.t / time - t) <= 0.0);
        let pairs = (0..PARTS).map(middle).filter(|&t| !is_between(t)).flat_map(|t| {
            outputs.iter().map(move |output| [one.value(output, t), other.value(output, t * time) / unit])
        });
        let pairs: Vec<_> = pairs.collect();
        let size = pairs.iter().fold(natural, |size, [a, _]| size.max(a.abs()));
        largest(pairs.iter().map(|[a, b]| (b - a).abs())) / size
    }
}

/// Whether there are reactions to compare.
fn has_contacts(model: &Entry) -> bool {
    !model.layout().contacts.is_empty()
}

/// Expected bounds on the differences of two runs.
fn differences(model: &Entry, most: f64) -> Vec<Expectation> {
    let numbers = [at_most("Δ times", most), at_most("Δ state", most), at_most("Δ reactions", most)];
    numbers.into_iter().take(if has_contacts(model) { 3 } else { 2 }).collect()
}

/// The largest; NaN if one is.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most, value| if value.is_nan() { value } else { most.max(value) })
}

/// A case about the default run of a model.
fn case(
    group: &str,
    (model, detail): (&'static Entry, &str),
    scene: String,
    source: &'static str,
    expected: Expected,
    measure: impl FnOnce() -> Result<Answer, MotionError> + Send + 'static,
) -> Case {
    let id = format!("{group}.{} {detail}", model.name());
    let mut case = Case::new(id.trim_end(), scene, source, expected, move |_| measure());
    case.method = MethodId::Auto;
    case
}

/// A run with its specification, for the judge and the audit.
fn shown(spec: &RunSpec, run: Trajectory) -> Trajectory {
    let held: Vec<&str> = spec.hold.iter().map(String::as_str).collect();
    witness(&run, &held);
    run
}

/// The same events, and differences up to this.
fn same(model: &Entry, most: f64) -> Expected {
    Expected::Answer { text: SAME.to_owned(), expectations: differences(model, most) }
}

/// The default run at a tolerance.
fn with_tolerance(model: &Entry, tolerance: f64) -> RunSpec {
    model.default_run().tolerance(tolerance)
}

/// Whether a model has a default run that moves.
fn runs(model: &Entry) -> bool {
    has_default_run(model) && !rests(model)
}

/// Whether the default start is an equilibrium.
fn rests(model: &Entry) -> bool {
    let Ok(simulation) = model.simulation(&model.default_run()) else { return false };
    let end = INSTANT * simulation.scales().time;
    let is_equilibrium = |entry: &LogEntry| entry.decision == LoggedDecision::StartRests;
    simulation.limit(end).run().is_ok_and(|run| run.log().iter().any(is_equilibrium))
}

/// Whether all parameters have values.
fn has_default_run(model: &Entry) -> bool {
    let known = model.default_run().parameters;
    model.layout().parameters.iter().all(|name| known.iter().any(|(known, _)| known == name))
}
