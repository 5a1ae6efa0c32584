//! What the figure settled, as measures that are not negative where it holds with a model's own
//! parameters.

use super::measure::{Measure, MeasureKind, MeasureValue, Turned};
use crate::Analysis;
use crate::algebra::{Angle, Series, Symbol};
use crate::phases::AngleBranch;
use crate::program::{Id, Lowering};
use crate::system::{Settled, Settles};

/// What is to be checked.
pub(super) struct Open<'a> {
    analysis: &'a Analysis,
    lengths: Vec<&'a Settled>,
    branches: Vec<(String, &'a AngleBranch)>,
}

impl<'a> Open<'a> {
    /// Everything that was settled for samples of the parameters.
    pub fn new(analysis: &'a Analysis) -> Self {
        let mut branches: Vec<(String, &AngleBranch)> = Vec::new();
        for elimination in analysis.phases.iter().flat_map(|phase| &phase.eliminated) {
            let known = |branch: &AngleBranch| branches.iter().any(|(_, other)| *other == branch);
            if let Some(branch) = elimination.branch.as_ref().filter(|branch| !known(branch)) {
                branches.push((row(analysis, elimination.row), branch));
            }
        }
        let lengths = analysis.system.settled.iter().chain(&analysis.kinematics.settled).collect();
        Self { analysis, lengths, branches }
    }

    /// Lengths and what they are multiplied by, then the constants of both angles of each branch.
    pub fn lowered(&self, lowering: &mut Lowering) -> Vec<Id> {
        let mut ids = Vec::new();
        for settled in &self.lengths {
            ids.extend([&settled.length, &settled.factor].map(|series| lowering.series(series)));
        }
        for (_, branch) in &self.branches {
            ids.extend([&branch.zero, &branch.other].map(|angle| lowering.angle(&self.constant(angle))));
        }
        ids
    }

    /// Whether the coordinates of the figure are asked for.
    pub fn reads_figure(&self) -> bool {
        !self.branches.is_empty()
    }

    /// A measure each, of numbers from `first` on.
    pub fn entries(&self, first: usize) -> Vec<Measure> {
        let lengths = self.lengths.iter().zip((first..).step_by(2)).map(|(settled, k)| {
            let kind = match settled.settles {
                Settles::Sign => MeasureKind::Sign,
                Settles::Side => MeasureKind::Side,
                Settles::Direction => MeasureKind::Direction,
            };
            let plain = settled.factor == Series::one();
            let value = if plain { MeasureValue::Number(k) } else { MeasureValue::Quotient(k, k + 1) };
            Measure { of: settled.name.clone(), kind, value }
        });
        let lengths: Vec<Measure> = lengths.collect();
        let branches = self.branches.iter().zip((first + 2 * lengths.len()..).step_by(2));
        let branches = branches.map(|((name, branch), k)| {
            let turned = |angle, constant| Turned { constant, terms: self.terms(angle).collect() };
            let value = MeasureValue::Branch([turned(&branch.zero, k), turned(&branch.other, k + 1)]);
            Measure { of: name.clone(), kind: MeasureKind::Branch, value }
        });
        lengths.into_iter().chain(branches).collect()
    }

    /// Coordinates of an angle and their multipliers.
    fn terms<'b>(&'b self, angle: &'b Angle) -> impl Iterator<Item = (usize, i16)> + 'b {
        let all = (0..self.analysis.motion.n).map(|i| (i, angle.coefficient(Symbol::coordinate(i))));
        all.filter(|(_, k)| *k != 0)
    }

    /// An angle without its coordinates.
    fn constant(&self, angle: &Angle) -> Angle {
        self.terms(angle).fold(angle.clone(), |rest, (i, k)| {
            &rest - &Angle::from_symbol(Symbol::coordinate(i)).scale(i32::from(k))
        })
    }
}

/// The name of a contact or joint.
fn row(analysis: &Analysis, row: usize) -> String {
    let contacts = &analysis.motion.contacts;
    match contacts.get(row) {
        Some(contact) => contact.label(&analysis.system),
        None => analysis.kinematics.joints[row - contacts.len()].name.clone(),
    }
}
