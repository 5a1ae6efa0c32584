//! Cases about one difficulty.

use super::case::Case;
use super::verdict::Verdict;
use liftoff::method::MethodId;

/// How long the long cases run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Effort {
    /// As in the tables: a hundred thousand periods.
    Full,
    /// The same scenes, shortened so that an unoptimised program does them in seconds.
    Short,
}

/// Cases about one difficulty.
#[derive(Debug)]
pub struct Group {
    /// Name on the command line, and the first part of the ids of the cases.
    pub name: &'static str,
    /// Heading on the page: what is difficult about the scenes.
    pub title: &'static str,
    /// Every scene is run by each of these.
    pub methods: &'static [MethodId],
    /// The cases for a method.
    pub cases: fn(MethodId, Effort) -> Vec<Case>,
}

impl Group {
    /// Its cases by each of its methods, to be judged.
    pub fn cases(&self, effort: Effort) -> Vec<Case> {
        let by =
            |&method: &MethodId| (self.cases)(method, effort).into_iter().map(move |case| case.by(method));
        self.methods.iter().flat_map(by).collect()
    }
}

/// A group with the verdicts on its cases.
#[derive(Clone, Debug)]
pub struct GroupResult {
    /// Name of the group on the command line.
    pub name: &'static str,
    /// Heading on the page: what is difficult about the scenes.
    pub title: &'static str,
    /// In the order of the cases.
    pub verdicts: Vec<Verdict>,
}
