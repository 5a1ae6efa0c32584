//! The stability suite: stiff, extreme and degenerate scenes, each with the outcome that a closed form, a quadrature or
//! plain mechanics demands, the outcome measured, and a verdict. `liftoff stability` runs it; so do the tests.

mod answer;
mod case;
mod chart;
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
    cases: fn(Effort) -> Vec<Case>,
}

impl Group {
    /// Its cases, to be judged.
    pub fn cases(&self, effort: Effort) -> Vec<Case> {
        (self.cases)(effort)
    }
}

/// Every group.
pub const GROUPS: [Group; 15] = [
    Group { name: "springs", title: "Stiff springs, with and without damping", cases: springs::cases },
    Group { name: "ratios", title: "Ratios of masses", cases: ratios::cases },
    Group { name: "massless", title: "Massless bars", cases: massless::cases },
    Group { name: "starts", title: "Starts beside a degenerate equilibrium", cases: starts::cases },
    Group { name: "units", title: "Units of length, time and mass", cases: units::cases },
    Group { name: "feet", title: "Two roots of a reaction close together", cases: feet::cases },
    Group { name: "grazing", title: "Grazing from both sides", cases: grazing::cases },
    Group { name: "zeno", title: "Infinitely many impacts", cases: zeno::cases },
    Group { name: "together", title: "Events within one rounding of each other", cases: together::cases },
    Group { name: "edges", title: "Events at the ends of steps and runs", cases: edges::cases },
    Group { name: "long", title: "Long runs", cases: long::cases },
    Group { name: "loops", title: "Closed loops through singular positions", cases: loops::cases },
    Group { name: "chart", title: "A closed form towards the end of its chart", cases: chart::cases },
    Group { name: "extremes", title: "Ends of floating point, of steps and of time", cases: extremes::cases },
    Group { name: "inputs", title: "No numbers", cases: inputs::cases },
];
