//! The stability suite: stiff, extreme and degenerate scenes, each with the outcome that a closed form, a quadrature or
//! plain mechanics demands, the outcome measured, and a verdict. `liftoff stability` runs it; so do the tests.

mod answer;
mod case;
mod chart;
pub(crate) mod command;
mod edges;
mod extremes;
mod feet;
mod grazing;
mod inputs;
mod long;
mod loops;
mod massless;
mod page;
mod ratios;
mod reference;
mod springs;
mod starts;
mod story;
mod table;
mod together;
mod units;
mod verdict;
mod zeno;

pub use case::Case;
pub use page::html;
pub use table::{summary, text};
pub use verdict::Verdict;

use liftoff::catalog::Integrator;

/// How long the long cases run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Effort {
    /// As in the tables: a million periods.
    Full,
    /// The same scenes, shortened so that an unoptimised program does them in seconds.
    Short,
}

/// Cases about one difficulty.
pub struct Group {
    /// Its name, and the first part of the ids of its cases.
    pub name: &'static str,
    /// What is difficult.
    pub title: &'static str,
    methods: &'static [Integrator],
    cases: fn(Integrator, Effort) -> Vec<Case>,
}

impl Group {
    /// Its cases by each of its methods, to be judged.
    pub fn cases(&self, effort: Effort) -> Vec<Case> {
        let by =
            |&method: &Integrator| (self.cases)(method, effort).into_iter().map(move |case| case.by(method));
        self.methods.iter().flat_map(by).collect()
    }
}

const STIFF: &[Integrator] = &[Integrator::Radau, Integrator::Auto, Integrator::Dop853];
const MULTIPLIERS: &[Integrator] = &[Integrator::Dop853, Integrator::Radau];
const SYMMETRIC: &[Integrator] = &[Integrator::Gauss];
const EXPLICIT: &[Integrator] = &[Integrator::Dop853, Integrator::Taylor];
/// For what does not depend on the method.
const ONE: &[Integrator] = &[Integrator::Dop853];

const fn group(
    name: &'static str,
    title: &'static str,
    methods: &'static [Integrator],
    cases: fn(Integrator, Effort) -> Vec<Case>,
) -> Group {
    Group { name, title, methods, cases }
}

/// Every group.
pub const GROUPS: [Group; 15] = [
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
    group("chart", "A closed form towards the end of its chart", ONE, chart::cases),
    group("extremes", "Ends of floating point, of steps and of time", EXPLICIT, extremes::cases),
    group("inputs", "No numbers", ONE, inputs::cases),
];
