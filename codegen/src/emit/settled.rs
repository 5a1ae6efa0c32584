//! What the figure settled, as measures that are not negative where it holds with a model's own parameters.

use proc_macro2::TokenStream;

use super::count;
use super::numbers::entry;
use crate::Analysis;
use crate::algebra::{Angle, Series, Symbol};
use crate::phases::Branch;
use crate::program::{Id, Lowering};
use crate::system::{Settled, Settles};

/// What is to be checked.
pub(super) struct Open<'a> {
    analysis: &'a Analysis,
    lengths: Vec<&'a Settled>,
    branches: Vec<(String, &'a Branch)>,
}

/// Everything that was settled for samples of the parameters.
pub(super) fn of(analysis: &Analysis) -> Open<'_> {
    let mut branches: Vec<(String, &Branch)> = Vec::new();
    for elimination in analysis.phases.iter().flat_map(|phase| &phase.eliminated) {
        let known = |branch: &Branch| branches.iter().any(|(_, other)| *other == branch);
        if let Some(branch) = elimination.branch.as_ref().filter(|branch| !known(branch)) {
            branches.push((row(analysis, elimination.row), branch));
        }
    }
    let lengths = analysis.system.settled.iter().chain(&analysis.kinematics.settled).collect();
    Open { analysis, lengths, branches }
}

/// The name of a contact or joint.
fn row(analysis: &Analysis, row: usize) -> String {
    let contacts = &analysis.motion.contacts;
    match contacts.get(row) {
        Some(contact) => contact.label(&analysis.system),
        None => analysis.kinematics.joints[row - contacts.len()].name.clone(),
    }
}

impl Open<'_> {
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

    /// The coordinates of the figure, if they are asked for.
    pub fn nominal(&self) -> TokenStream {
        let asked = !self.branches.is_empty();
        if asked { quote!(let nominal = BarSystem::nominal(self);) } else { TokenStream::new() }
    }

    /// A measure each.
    pub fn entries(&self, lowered: &[TokenStream]) -> Vec<TokenStream> {
        let (lengths, constants) = lowered.split_at(2 * self.lengths.len());
        let lengths = self.lengths.iter().zip(lengths.chunks(2)).map(|(settled, values)| {
            let (length, factor) = (&values[0], &values[1]);
            let kind = match settled.settles {
                Settles::Sign => quote!(Sign),
                Settles::Side => quote!(Side),
                Settles::Direction => quote!(Direction),
            };
            let value =
                if settled.factor == Series::one() { quote!(#length) } else { quote!((#length) / (#factor)) };
            entry(&settled.name, &kind, &value)
        });
        let branches = self.branches.iter().zip(constants.chunks(2)).map(|((name, branch), constants)| {
            let zero = self.distance(&branch.zero, &constants[0]);
            let other = self.distance(&branch.other, &constants[1]);
            entry(name, &quote!(Branch), &quote!(#other - #zero))
        });
        lengths.chain(branches).collect()
    }

    /// How far an angle is from zero in the figure.
    fn distance(&self, angle: &Angle, constant: &TokenStream) -> TokenStream {
        let runtime = &self.analysis.system.runtime;
        let terms = self.terms(angle).map(|(i, k)| {
            let (i, k) = (count(i), f64::from(k));
            quote!(+ #k * nominal[#i])
        });
        quote!(#runtime::figure::wrapped(#constant #(#terms)*).abs())
    }

    /// Coordinates of an angle and their multipliers.
    fn terms<'b>(&'b self, angle: &'b Angle) -> impl Iterator<Item = (usize, i16)> + 'b {
        let all = (0..self.analysis.motion.n).map(|i| (i, angle.coefficient(Symbol::coordinate(i))));
        all.filter(|(_, k)| *k != 0)
    }

    /// An angle without its coordinates.
    fn constant(&self, angle: &Angle) -> Angle {
        self.terms(angle)
            .fold(angle.clone(), |rest, (i, k)| &rest - &Angle::of(Symbol::coordinate(i)).scale(i32::from(k)))
    }
}
