//! The stability suite: stiff, extreme and degenerate scenes, each with the outcome that a closed
//! form, a quadrature or plain mechanics demands, the outcome measured, and a verdict.
//! `liftoff stability` runs it; so do the tests.

mod chart;
mod contacts;
mod edges;
mod extremes;
mod feet;
mod friction;
mod grazing;
mod inputs;
mod long;
mod loops;
mod massless;
mod near;
mod ratios;
mod reference;
mod scenes;
mod springs;
mod starts;
mod together;
mod units;
mod upright;
mod zeno;

use crate::models;
use liftoff::Trajectory;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, MethodId, MotionError, RunOptions};
use liftoff_verification::cases::{Case, Effort, Group};

const STIFF: &[MethodId] = &[MethodId::Radau, MethodId::Auto, MethodId::Dop853];
const MULTIPLIERS: &[MethodId] = &[MethodId::Dop853, MethodId::Radau];
const SYMMETRIC: &[MethodId] = &[MethodId::Gauss];
const EXPLICIT: &[MethodId] = &[MethodId::Dop853, MethodId::Taylor];
/// For what does not depend on the method.
const ONE: &[MethodId] = &[MethodId::Dop853];

const fn group(
    name: &'static str,
    title: &'static str,
    methods: &'static [MethodId],
    cases: fn(MethodId, Effort) -> Vec<Case>,
) -> Group {
    Group { name, title, methods, cases }
}

/// Every group.
pub static GROUPS: [Group; 23] = [
    group("springs", "Stiff springs, with and without damping", STIFF, springs::cases),
    group("ratios", "Ratios of masses", MULTIPLIERS, ratios::cases),
    group("massless", "Massless bars", MULTIPLIERS, massless::cases),
    group("starts", "Starts beside a degenerate equilibrium", EXPLICIT, starts::cases),
    group("units", "Units of length, time and mass", EXPLICIT, units::cases),
    group("feet", "Two roots of a reaction close together", EXPLICIT, feet::cases),
    group("grazing", "Grazing from both sides", EXPLICIT, grazing::cases),
    group("zeno", "Infinitely many impacts", EXPLICIT, zeno::cases),
    group("together", "Events within one rounding of each other", EXPLICIT, together::cases),
    group("edges", "Events at the ends of steps and runs", EXPLICIT, edges::cases),
    group("long", "Long runs", SYMMETRIC, long::cases),
    group("loops", "Closed loops through singular positions", ONE, loops::cases),
    group("near", "Closed loops near singular positions", ONE, near::loops),
    group("drives", "Drives near singular positions", ONE, near::drives),
    group("chart", "A closed form towards the end of its chart", ONE, chart::cases),
    group("extremes", "Ends of floating point, of steps and of time", EXPLICIT, extremes::cases),
    group("friction", "Dry friction", EXPLICIT, friction::cases),
    group("buffers", "Stiff springs that act on one side", EXPLICIT, contacts::buffers),
    group("dependent", "Nearly dependent contacts", EXPLICIT, upright::cases),
    group("redundant", "Redundant supports", EXPLICIT, contacts::redundant),
    group("loads", "Narrow loads", EXPLICIT, contacts::loads),
    group("impacts", "Very many impacts", EXPLICIT, contacts::impacts),
    group("inputs", "No numbers", ONE, inputs::cases),
];

/// A scene of the suite, or a model.
fn find(name: &str) -> Result<&'static Entry, MotionError> {
    scenes::find(name).map_or_else(|| models().find(name), Ok)
}

/// Runs a scene or a model by a method, for a case that the judge follows.
fn run(name: &str, by: MethodId, spec: &RunSpec) -> Result<Trajectory, MotionError> {
    find(name)?.run_witnessed(by, spec)
}

/// The same for a case that is beyond the judge, which would spend all it may before it says so.
fn run_unjudged(name: &str, by: MethodId, spec: &RunSpec) -> Result<Trajectory, MotionError> {
    find(name)?.run_by(RunOptions::by(by), spec)
}
