//! Contacts with friction in a collision: how they slip at its end and on the way, and Routh's path
//! of one that strikes alone ([`RouthContact`] has its equations).

use crate::Number;
use crate::collision::Collision;
use crate::model::ReplayModel;
use liftoff::__private::impulse::RouthContact;
use liftoff_core::model::{ContactSet, Layout, Slip, SlipState};

/// Slip velocities below this, in natural units relative to the fastest, are zero.
const STICKS: f64 = 1e-8;
/// Of so many contacts at most all combinations of slips are tried.
const MOST: usize = 5;

/// The slips of a state.
pub(crate) fn slips<S: Number>(model: &ReplayModel<S>, state: &[S]) -> Vec<SlipState<S>> {
    let still = SlipState { velocity: S::ZERO, kinetic: S::ZERO, limit: S::ZERO };
    let mut slips = vec![still; model.layout().frictions.len()];
    model.on.system.slips(state, &mut slips);
    slips
}

/// The same set with the slips of a state that the run has after the collision.
pub(crate) fn ending<S: Number>(model: &ReplayModel<S>, after: &[S], set: ContactSet) -> ContactSet {
    let n = model.layout().coordinates.len();
    let natural = |i: usize| after[n + i].to_f64().abs() / model.units[n + i];
    let fastest = (0..n).map(natural).fold(1.0, f64::max) * model.length / model.time;
    let slips = slips(model, after);
    let frictions = model.layout().frictions.iter().zip(&slips);
    let closed = frictions.filter(|(friction, _)| set.contains(friction.contact));
    closed.fold(set, |set, (friction, slip)| {
        let velocity = slip.velocity.to_f64();
        let slip = match velocity {
            _ if velocity.abs() <= STICKS * fastest => Slip::Stick,
            _ if velocity > 0.0 => Slip::Forward,
            _ => Slip::Backward,
        };
        set.slipping(friction.contact, slip)
    })
}

/// The set with all combinations of slips of its contacts with friction, its own first.
pub(crate) fn modes(layout: &Layout, set: ContactSet) -> Vec<ContactSet> {
    let rubbing = layout.frictions.iter().map(|friction| friction.contact);
    let rubbing: Vec<usize> = rubbing.filter(|&contact| set.contains(contact)).collect();
    let mut all = vec![set];
    if rubbing.len() > MOST {
        return all;
    }
    for contact in rubbing {
        let others = [Slip::Stick, Slip::Forward, Slip::Backward].into_iter();
        let others = others.filter(|slip| *slip != set.slip(contact));
        let further: Vec<_> =
            others.flat_map(|slip| all.iter().map(move |set| set.slipping(contact, slip))).collect();
        all.extend(further);
    }
    all
}

impl<S: Number> Collision<'_, S> {
    /// The rates at the end of Routh's path, where a single contact acts and has friction.
    pub(crate) fn along_path(&self) -> Option<Vec<S>> {
        let layout = self.model.layout();
        let held = layout.guides();
        let mut striking = self.acting.difference(held).iter();
        let (Some(contact), None) = (striking.next(), striking.next()) else { return None };
        let entry = layout.contacts[contact].friction?;
        let tangent = layout.frictions[entry].row;
        let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &held)).collect();
        let columns: Vec<_> = rows.iter().map(|&row| self.equations.jacobian(row).to_vec()).collect();
        let still = vec![S::ZERO; rows.len()];
        let along = |row: usize| self.response((&rows, &columns), self.equations.jacobian(row), &still).0;
        let [by_normal, by_tangent] = [along(contact), along(tangent)];
        let product = |row: usize, by: &[S]| {
            let terms = self.equations.jacobian(row).iter().zip(by);
            terms.fold(S::ZERO, |sum, (&entry, &by)| entry.mul_add(by, sum))
        };
        let striker = RouthContact {
            w_nn: product(contact, &by_normal),
            w_nt: product(contact, &by_tangent),
            w_tt: product(tangent, &by_tangent),
            mu: self.kinetic(entry),
            e: self.restitution(contact),
            law: layout.contacts[contact].law,
        };
        let approach = self.speed(contact, self.before());
        let approach = if approach < S::ZERO { approach } else { S::ZERO };
        let end = *striker.path(approach, self.speed(tangent, self.before()))?.vertices.last()?;
        let changes = by_normal.iter().zip(&by_tangent);
        let changes = changes.map(|(&normal, &tangent)| normal * end.impulse + tangent * end.friction);
        Some(self.before().iter().zip(changes).map(|(&u, change)| u + change).collect())
    }
}
