//! The modes of a hybrid system: contact sets, their degrees of freedom and the changes of one contact between them.
//!
//! Degrees of freedom: coordinates less the rank of J over the closed rows, at a generic position that satisfies them near
//! the nominal figure.

#[cfg(test)]
pub(crate) mod tests;
mod text;

use nalgebra::DMatrix;

use crate::error::ModelError;
use crate::integration::phase_point::RunContext;
use crate::model::{ContactSet, Layout};
use crate::scales::scales_of;
use crate::simulation::Switch;
use crate::system::Model;

/// With more contacts than this only the sets that have own code are listed.
const ALL: usize = 12;
/// Distance of the generic position from the nominal figure, in natural units.
const NEAR: f64 = 1e-2;
/// Gaps below this natural length are closed, singular values below this fraction of the largest are zero: redundant
/// rows are so to rounding, independent ones differ as the position does from special ones.
const RANK: f64 = 1e-8;

/// The contact sets of a model and how they follow one another.
#[derive(Debug, Clone)]
pub struct Modes {
    layout: &'static Layout,
    /// The sets, free motion first.
    pub modes: Vec<Mode>,
    /// The changes by one contact.
    pub transitions: Vec<Transition>,
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
    /// The closed contacts.
    pub set: ContactSet,
    /// Their labels.
    pub closed: Vec<&'static str>,
    /// Degrees of freedom.
    pub degrees: usize,
    /// Whether the model has equations of its own for it; other sets share the full ones with multipliers.
    pub own_code: bool,
}

/// Two modes that differ by one contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Transition {
    /// The contact's label.
    pub contact: &'static str,
    /// Index of the mode with it open.
    pub open: usize,
    /// Index of the mode with it closed.
    pub closed: usize,
}

/// The modes of a model with its present parameters.
///
/// # Errors
/// If the parameters make no mechanical system.
pub fn modes(model: impl Into<Model>) -> Result<Modes, ModelError> {
    let model = model.into();
    let context = RunContext { scales: scales_of(&model)?, switches: Switch::all(model.layout())?, model };
    let layout = context.layout();
    let complete = layout.contacts.len() <= ALL;
    let sets = sets(layout, complete);
    let modes: Vec<Mode> = sets
        .iter()
        .map(|&set| Mode {
            set,
            closed: set.iter().map(|i| layout.contacts[i].label).collect(),
            degrees: context.degrees(set),
            own_code: layout.closed_forms.contains(&set),
        })
        .collect();
    Ok(Modes { layout, transitions: transitions(layout, &sets), modes, complete })
}

/// The sets to list, small ones first.
fn sets(layout: &'static Layout, complete: bool) -> Vec<ContactSet> {
    let mut sets = if complete {
        (0..1 << layout.contacts.len()).map(ContactSet::from_bits).collect()
    } else {
        layout.closed_forms.to_vec()
    };
    sets.sort_by_key(|set: &ContactSet| (set.len(), *set));
    sets
}

fn transitions(layout: &'static Layout, sets: &[ContactSet]) -> Vec<Transition> {
    let mut all = Vec::new();
    for (i, contact) in layout.contacts.iter().enumerate() {
        for (open, set) in sets.iter().enumerate().filter(|(_, set)| !set.contains(i)) {
            if let Some(closed) = sets.iter().position(|other| *other == set.with(i)) {
                all.push(Transition { contact: contact.label, open, closed });
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
        n - jacobian.singular_values().iter().filter(|&&value| value > RANK).count()
    }

    /// A generic position on the closed rows; where they cannot all be closed near the nominal figure, one that leaves them
    /// open.
    fn position(&self, set: ContactSet) -> Vec<f64> {
        let (layout, nominal) = (self.layout(), &self.model.nominal);
        let unit = self.scales.state(layout);
        // Multiples of the golden ratio, their whole parts dropped, keep clear of special positions.
        let aside = |i: usize| NEAR * ((i + 1) as f64 * 0.618_033_988_749_894_9).fract();
        let near = |i: usize| nominal.get(i).map_or(0.0, |start| start + aside(i) * unit[i]);
        let beside: Vec<f64> = (0..layout.entries()).map(near).collect();
        let mut on = beside.clone();
        for _ in 0..2 {
            self.system().project(set, &mut on, self.scales.length);
        }
        let gaps = self.system().equations(&on);
        let closed = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set));
        let satisfied = closed.map(|row| gaps.gap()[row].abs()).all(|gap| gap <= RANK * self.scales.length);
        if satisfied && on.iter().all(|x| x.is_finite()) { on } else { beside }
    }
}
