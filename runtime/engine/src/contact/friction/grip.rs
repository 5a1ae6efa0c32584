//! How far contacts that share their load are from slipping: the margin s of limit analysis
//! ([`limit`]), with an edge `aₑ = J_N ± μ_s J_t` for each side of the cone of a contact that
//! sticks, `J_N − σ μ J_t` of one that slides and J_N of one without friction. At s = 0 the
//! contacts slip or open together, however they have shared their load before.

use nalgebra::DVector;

use super::limit::{Limit, find_limit, row_space};
use super::modes::SlipDirection;
use crate::contact::closed_rows::ClosedRows;
use crate::context::{Slips, slips};
use crate::model::{ContactSet, Layout, Slip, SlipState};
use crate::numerics::zero::{MARGIN, roundoff};
use crate::system::System;

/// A friction force below this part of the largest reaction is rounding: beside the limit of a
/// small coefficient it would be large.
const ROUNDED: f64 = roundoff(16.0);

/// The closed contacts of a phase whose reactions are not determined by the motion.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct SharedFriction {
    /// Those with friction that stick: they slip when no reactions within the cones are left.
    pub(crate) sticking: ContactSet,
    /// Those beside and among them whose normal reaction is not determined: they open when no
    /// reactions within the cones are left, and not when the shortest ones vanish.
    pub(crate) normals: ContactSet,
}

/// How far the contacts of a grip are from slipping.
#[derive(Debug, Clone, Default)]
pub(crate) struct SharedFrictionMargin {
    /// s, N: negative where they have to slip.
    pub(crate) value: f64,
    /// Those that slip at s = 0, with their senses.
    pub(crate) leaving: Vec<(usize, SlipDirection)>,
    /// Those that bear nothing at s = 0.
    pub(crate) unloaded: ContactSet,
}

/// An edge of a cone: its column in natural coordinates, and the slip that follows at it.
struct ConeEdge {
    column: DVector<f64>,
    load: f64,
    contact: usize,
    /// `None` without friction.
    slip: Option<SlipDirection>,
}

impl SharedFriction {
    /// Of the closed contacts at a state.
    pub(crate) fn compute(system: &dyn System, state: &[f64], closed: &ContactSet) -> Self {
        let layout = system.layout();
        let sticks = |contact: usize| closed.contains(contact) && closed.slip(contact) == Slip::Stick;
        let mut grip = Self::default();
        // Hinges bear by their forces, which are no rows: each contact beside them has its own
        // limit, by the reactions that move the system.
        if layout.has_hinges() || !layout.frictions.iter().any(|friction| sticks(friction.contact)) {
            return grip;
        }
        let rows = bent_rows(system, state, closed, &slips(system, state));
        let undetermined = rows.undetermined();
        let is_free = |row: usize| rows.find_index(row).is_some_and(|place| undetermined[place]);
        for friction in layout.frictions.iter().filter(|friction| sticks(friction.contact)) {
            if is_free(friction.contact) || is_free(friction.row) {
                grip.sticking = grip.sticking.with(friction.contact);
            }
        }
        if !grip.sticking.is_empty() {
            let smooth = |contact: usize| layout.contacts[contact].friction.is_none();
            let shares = |contact: &usize| (sticks(*contact) || smooth(*contact)) && is_free(*contact);
            grip.normals = closed.iter().filter(shares).collect();
        }
        grip
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.sticking.is_empty()
    }
}

/// The rows of what sticks, and of all that shares its load, bent where they slide.
fn bent_rows(
    system: &dyn System,
    state: &[f64],
    closed: &ContactSet,
    slips: &[SlipState<f64>],
) -> ClosedRows {
    let mut rows = ClosedRows::compute(system, state, closed);
    for (entry, friction) in system.layout().sliding(closed) {
        rows.bend(friction, closed.sense(friction.contact) as f64 * slips[entry].kinetic);
    }
    let layout = system.layout();
    let sticks = |contact: usize| closed.contains(contact) && closed.slip(contact) == Slip::Stick;
    rows.connected_with(|row| layout.contact_of(row).is_some_and(sticks))
}

/// The last margin and what it followed from: contacts at rest beside others that move are looked
/// at once.
#[derive(Default)]
pub(crate) struct LastMargin {
    from: Vec<f64>,
    value: f64,
}

impl LastMargin {
    /// s of the contacts that share their load at a state, given the reactions there.
    pub(crate) fn value(
        &mut self,
        system: &dyn System,
        state: &[f64],
        closed: &ContactSet,
        reactions: &[f64],
    ) -> f64 {
        let shared = SharedLoad::compute(system, state, closed);
        let from = shared.numbers(reactions);
        if from != self.from {
            self.from = from;
            self.value = shared.margin(reactions).value;
        }
        self.value
    }
}

/// The margin of the contacts that share their load, given reactions of all closed contacts that
/// hold the motion.
pub(crate) fn margin(
    system: &dyn System,
    state: &[f64],
    closed: &ContactSet,
    reactions: &[f64],
) -> SharedFrictionMargin {
    SharedLoad::compute(system, state, closed).margin(reactions)
}

/// The closed contacts that stick with all that shares their load.
struct SharedLoad<'a> {
    layout: &'a Layout,
    closed: &'a ContactSet,
    rows: ClosedRows,
    slips: Slips,
}

impl<'a> SharedLoad<'a> {
    fn compute(system: &'a dyn System, state: &[f64], closed: &'a ContactSet) -> Self {
        let slips = slips(system, state);
        Self { layout: system.layout(), closed, rows: bent_rows(system, state, closed, &slips), slips }
    }

    /// All that the margin follows from.
    fn numbers(&self, reactions: &[f64]) -> Vec<f64> {
        let Self { layout, closed, rows, slips } = self;
        let shared = closed.iter().filter(|&contact| rows.find_index(contact).is_some());
        let loads = shared.flat_map(|contact| {
            let friction = layout.contacts[contact].friction;
            let own = friction.map(|entry| [reactions[layout.contacts.len() + entry], slips[entry].limit]);
            own.into_iter().flatten().chain([reactions[contact]])
        });
        rows.jacobian.iter().copied().chain(loads).collect()
    }

    fn margin(&self, reactions: &[f64]) -> SharedFrictionMargin {
        let Self { layout, closed, rows, slips } = self;
        let undetermined = rows.undetermined();
        let (edges, taken) = edges(layout, closed, (rows, &undetermined), slips, reactions);
        if edges.is_empty() {
            // At this position the motion determines all of them: none can go before its own
            // reaction does.
            return SharedFrictionMargin {
                value: reactions.iter().fold(0.0, |most, load| load.abs().max(most)),
                ..SharedFrictionMargin::default()
            };
        }
        let others = (0..rows.rows.len()).filter(|place| !taken.contains(place));
        let others: Vec<DVector<f64>> = others.map(|place| rows.jacobian.row(place).transpose()).collect();
        let columns: Vec<DVector<f64>> = edges.iter().map(|edge| edge.column.clone()).collect();
        let loads = DVector::from_iterator(edges.len(), edges.iter().map(|edge| edge.load));
        let Some(Limit { margin: value, velocities, .. }) = find_limit(&row_space(&columns, &others), &loads)
        else {
            // Internal forces hold the contacts under any load.
            return SharedFrictionMargin { value: loads.amax(), ..SharedFrictionMargin::default() };
        };
        let least = MARGIN * velocities.amax();
        let moves = |place: &usize| velocities[*place] > least;
        let rests = |contact| (0..edges.len()).any(|k| edges[k].contact == contact && !moves(&k));
        let moving = || (0..edges.len()).filter(moves).map(|place| &edges[place]);
        let slips = moving().filter(|edge| rests(edge.contact));
        SharedFrictionMargin {
            value,
            leaving: slips.filter_map(|edge| edge.slip.map(|sense| (edge.contact, sense))).collect(),
            unloaded: moving().map(|edge| edge.contact).filter(|contact| !rests(*contact)).collect(),
        }
    }
}

/// The edges of all contacts whose reactions are not determined, and the places of their rows.
fn edges(
    layout: &Layout,
    closed: &ContactSet,
    (rows, undetermined): (&ClosedRows, &[bool]),
    slips: &[SlipState<f64>],
    reactions: &[f64],
) -> (Vec<ConeEdge>, Vec<usize>) {
    let (mut edges, mut taken) = (Vec::new(), Vec::new());
    let rounding = ROUNDED * reactions.iter().fold(0.0, |most: f64, load| most.max(load.abs()));
    for contact in closed.iter() {
        let Some(normal) = rows.find_index(contact) else { continue };
        let entry = layout.contacts[contact].friction.filter(|_| closed.slip(contact) == Slip::Stick);
        let tangent = entry.and_then(|entry| Some((entry, rows.find_index(layout.frictions[entry].row)?)));
        if !undetermined[normal] && !tangent.is_some_and(|(_, place)| undetermined[place]) {
            continue;
        }
        taken.push(normal);
        let side = f64::from(closed.side(contact).sign());
        let (pressing, bearing) = (rows.jacobian.row(normal).transpose() * side, side * reactions[contact]);
        let Some((entry, place)) = tangent else {
            edges.push(ConeEdge { column: pressing, load: bearing, contact, slip: None });
            continue;
        };
        taken.push(place);
        let (limit, friction) = (slips[entry].limit, reactions[layout.contacts.len() + entry]);
        // Where R = −μ λ_N the edge J_N + μ J_t bears nothing, and moves as the contact slips
        // forward.
        for (sign, sense) in [(1.0, SlipDirection::Forward), (-1.0, SlipDirection::Backward)] {
            let column = &pressing + rows.jacobian.row(place).transpose() * (sign * limit);
            let bears = limit > 0.0 && friction.abs() > rounding;
            let across = if bears { sign * friction / limit } else { 0.0 };
            let load = 0.5 * (bearing + across);
            edges.push(ConeEdge { column, load, contact, slip: Some(sense) });
        }
    }
    (edges, taken)
}

#[cfg(test)]
mod tests;
