//! The modes of a hybrid system: contact sets, their degrees of freedom and the changes of one
//! contact between them. A closed contact with friction slides or sticks.
//!
//! Degrees of freedom: coordinates less the rank of J over the closed rows, at a generic position
//! that satisfies them near the nominal figure.

#[cfg(test)]
pub(crate) mod tests;
mod text;

use nalgebra::DMatrix;

use crate::context::{RunContext, scales_of};
use crate::error::ModelError;
use crate::expression::Switches;
use crate::model::{Contact, ContactKind, ContactSet, Layout, Slip};
use crate::numerics::decomposition::singular_values;
use crate::system::Model;

/// Above this, list only sets with emitted equations.
const MAX_ENUMERATED_SETS: usize = 4096;
/// Distance of the generic position from the nominal figure, in natural units.
const NEAR: f64 = 1e-2;
/// Gaps below this natural length are closed, singular values below this fraction of the largest
/// are zero: redundant rows are so to rounding, independent ones differ as the position does from
/// special ones.
const RANK: f64 = 1e-8;

/// The contact sets of a model and how they follow one another.
#[derive(Debug, Clone)]
pub struct Modes {
    layout: &'static Layout,
    /// The sets, free motion first.
    pub modes: Vec<Mode>,
    /// The changes by one contact.
    pub transitions: Vec<ModeTransition>,
    /// Whether all sets are listed, or only those that have code of their own.
    pub complete: bool,
}

impl Modes {
    /// Names of the model.
    pub fn layout(&self) -> &'static Layout {
        self.layout
    }
}

/// A set of closed contacts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mode {
    /// The closed contacts; those with friction stick, or slide either way.
    pub set: ContactSet,
    /// Their labels, `A sticking` and `A sliding` of those with friction.
    pub closed: Vec<String>,
    /// Degrees of freedom.
    pub degrees: usize,
    /// Whether the model has equations of its own for it; other sets share the full ones with
    /// multipliers.
    pub own_code: bool,
}

/// Two modes that differ by one contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModeTransition {
    /// The contact's label.
    pub contact: &'static str,
    /// What it does on the way.
    pub change: Change,
    /// Index of the mode before, with more freedom.
    pub from: usize,
    /// Index of the mode after.
    pub to: usize,
}

/// What a contact does from one mode to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// It closes; on the way back it opens.
    Closes,
    /// It closes and slides; on the way back it opens.
    ClosesSliding,
    /// It closes and sticks; on the way back it opens.
    ClosesSticking,
    /// It slid and sticks; on the way back it slips.
    Sticks,
}

/// The modes of a model with its present parameters.
///
/// # Errors
/// If the parameters make no mechanical system.
pub fn modes(model: impl Into<Model>) -> Result<Modes, ModelError> {
    let model = model.into();
    Switches::from_layout(model.layout())?;
    let context = RunContext { scales: scales_of(&model)?, model };
    let layout = context.layout();
    let complete = number_of_sets(layout).is_some_and(|sets| sets <= MAX_ENUMERATED_SETS);
    let sets = sets(layout, complete);
    let modes: Vec<Mode> = sets
        .iter()
        .map(|&set| Mode {
            set,
            closed: set.iter().map(|i| label(&layout.contacts[i], set.slip(i))).collect(),
            degrees: context.degrees(set),
            own_code: layout.closed_forms.contains(&set),
        })
        .collect();
    Ok(Modes { layout, transitions: transitions(layout, &sets), modes, complete })
}

/// The sets to list, small ones first.
fn sets(layout: &'static Layout, complete: bool) -> Vec<ContactSet> {
    let mut sets = if complete { all_sets(layout) } else { layout.closed_forms.to_vec() };
    sets.sort_unstable_by_key(|set: &ContactSet| (set.len(), *set));
    sets
}

/// How many sets there are; none if more than a number holds.
fn number_of_sets(layout: &Layout) -> Option<usize> {
    let states = |contact: &Contact| match contact.kind {
        ContactKind::Guide | ContactKind::Hinge { .. } => 2,
        _ => 2 + usize::from(contact.friction.is_some()),
    };
    let mut states = layout.contacts.iter().map(states);
    states.try_fold(1_usize, usize::checked_mul)
}

fn all_sets(layout: &Layout) -> Vec<ContactSet> {
    let closed = |set: &ContactSet, i: usize| match layout.contacts[i].friction {
        Some(_) => vec![set.slipping(i, Slip::Forward), set.slipping(i, Slip::Stick)],
        None => vec![set.with(i)],
    };
    (0..layout.contacts.len()).fold(vec![ContactSet::EMPTY], |mut sets, i| {
        let more: Vec<ContactSet> = sets.iter().flat_map(|set| closed(set, i)).collect();
        if matches!(layout.contacts[i].kind, ContactKind::Guide | ContactKind::Hinge { .. }) {
            sets.clear();
        }
        sets.extend(more);
        sets
    })
}

fn label(contact: &Contact, slip: Slip) -> String {
    match (contact.friction, slip) {
        (None, _) => contact.label.to_owned(),
        (Some(_), Slip::Stick) => format!("{} sticking", contact.label),
        (Some(_), Slip::Forward | Slip::Backward) => format!("{} sliding", contact.label),
    }
}

fn transitions(layout: &'static Layout, sets: &[ContactSet]) -> Vec<ModeTransition> {
    let mut all = Vec::new();
    for (i, contact) in layout.contacts.iter().enumerate() {
        let ways: &[(Change, Option<Slip>)] = match contact.friction {
            None => &[(Change::Closes, None)],
            Some(_) => {
                &[(Change::ClosesSliding, Some(Slip::Forward)), (Change::ClosesSticking, Some(Slip::Stick))]
            }
        };
        let mut add = |change, from, to: ContactSet| {
            let to = sets.iter().position(|set| *set == to);
            all.extend(to.map(|to| ModeTransition { contact: contact.label, change, from, to }));
        };
        for (from, set) in sets.iter().enumerate() {
            if !set.contains(i) {
                for &(change, slip) in ways {
                    add(change, from, slip.map_or_else(|| set.with(i), |slip| set.slipping(i, slip)));
                }
            } else if contact.friction.is_some() && set.slip(i) != Slip::Stick {
                add(Change::Sticks, from, set.slipping(i, Slip::Stick));
            }
        }
    }
    all
}

impl RunContext {
    /// Degrees of freedom with the contacts of a set closed.
    fn degrees(&self, set: ContactSet) -> usize {
        let (layout, n) = (self.layout(), self.model.nominal.len());
        let equations = self.system().equations(&self.position(set));
        let closed: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
        let unit = self.scales.state(layout);
        let mut jacobian =
            DMatrix::from_fn(closed.len(), n, |i, j| equations.jacobian(closed[i])[j] * unit[j]);
        for mut row in jacobian.row_iter_mut() {
            let size = row.norm();
            row /= if size > 0.0 { size } else { 1.0 };
        }
        if closed.is_empty() {
            return n;
        }
        n - singular_values(jacobian).iter().filter(|&&value| value > RANK).count()
    }

    /// A generic position on the closed rows; where they cannot all be closed near the nominal
    /// figure, one that leaves them open.
    fn position(&self, set: ContactSet) -> Vec<f64> {
        let (layout, nominal) = (self.layout(), &self.model.nominal);
        let unit = self.scales.state(layout);
        // Multiples of the golden ratio, their whole parts dropped, keep clear of special
        // positions.
        let aside = |i: usize| NEAR * ((i + 1) as f64 * 0.618_033_988_749_894_9).fract();
        let near = |i: usize| nominal.get(i).map_or(0.0, |start| start + aside(i) * unit[i]);
        let beside: Vec<f64> = (0..layout.entries()).map(near).collect();
        let mut on = beside.clone();
        for _ in 0..2 {
            self.system().project(set, &mut on, self.scales.length);
        }
        let gaps = self.system().equations(&on);
        let mut closed = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set));
        let unit = |row: usize| layout.unit(row, self.scales.length);
        let satisfied = closed.all(|row| gaps.gap()[row].abs() <= RANK * unit(row));
        if satisfied && on.iter().all(|x| x.is_finite()) { on } else { beside }
    }
}
