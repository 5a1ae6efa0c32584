//! Cases about one difficulty.

use super::case::Case;
use super::verdict::Verdict;
use crate::catalog::Integrator;

/// How long the long cases run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Effort {
    /// As in the tables: a million periods.
    Full,
    /// The same scenes, shortened so that an unoptimised program does them in seconds.
    Short,
}

/// Cases about one difficulty.
#[derive(Debug)]
pub struct Group {
    /// Its name, and the first part of the ids of its cases.
    pub name: &'static str,
    /// What is difficult.
    pub title: &'static str,
    /// By which methods its scenes are run.
    pub methods: &'static [Integrator],
    /// Its cases for a method.
    pub cases: fn(Integrator, Effort) -> Vec<Case>,
}

impl Group {
    /// Its cases by each of its methods, to be judged.
    pub fn cases(&self, effort: Effort) -> Vec<Case> {
        let by =
            |&method: &Integrator| (self.cases)(method, effort).into_iter().map(move |case| case.by(method));
        self.methods.iter().flat_map(by).collect()
    }
}

/// A group with the verdicts on its cases.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The group's name.
    pub name: &'static str,
    /// What is difficult.
    pub title: &'static str,
    /// In the order of the cases.
    pub verdicts: Vec<Verdict>,
}
