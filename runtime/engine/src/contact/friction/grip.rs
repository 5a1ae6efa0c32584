//! How far contacts that share their load are from slipping: of all reactions that hold the motion,
//! those that keep farthest within their cones,
//!
//! ```text
//! s → max,    Σ aₑ (xₑ + s) = Jᵀ λ,    xₑ ≥ 0
//! ```
//!
//! with an edge `aₑ = J_N ± μ_s J_t` for each side of the cone of a contact that sticks,
//! `J_N − σ μ J_t` of one that slides and J_N of one without friction. At s = 0 no reactions within
//! the cones are left: the contacts slip together, however they have shared their load before. The
//! dual is the kinematic theorem of limit analysis: s is the least power `Jᵀ λ · w` of a virtual
//! velocity w with `aₑ · w ≥ 0` and `Σ aₑ · w = 1`, and the contacts slip or open with it (Drucker,
//! *Coulomb friction, plasticity, and limit loads*, J. Appl. Mech. 21, 1954).

use nalgebra::{DMatrix, DVector};

use super::lemke;
use super::modes::Sense;
use crate::contact::closed_rows::ClosedRows;
use crate::context::{Slips, slips};
use crate::model::{ContactSet, Layout, Slip, SlipState};
use crate::numerics::decomposition::{self, range};
use crate::numerics::zero::{MARGIN, RANK, roundoff};
use crate::system::System;

/// A friction force below this part of the largest reaction is rounding: beside the limit of a
/// small coefficient it would be large.
const ROUNDED: f64 = roundoff(16.0);

/// So many edges are looked at before others.
const FEW: usize = 16;

/// The closed contacts of a phase whose reactions are not determined by the motion.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Grip {
    /// Those with friction that stick: they slip when no reactions within the cones are left.
    pub(crate) sticking: ContactSet,
    /// Those among them whose normal reaction is not determined either.
    pub(crate) normals: ContactSet,
}

/// How far the contacts of a grip are from slipping.
#[derive(Debug, Clone, Default)]
pub(crate) struct Margin {
    /// s, N: negative where they have to slip.
    pub(crate) value: f64,
    /// Those that slip at s = 0, with their senses.
    pub(crate) leaving: Vec<(usize, Sense)>,
}

/// An edge of a cone: its column in natural coordinates, and the slip that follows at it.
struct Edge {
    column: DVector<f64>,
    load: f64,
    slip: Option<(usize, Sense)>,
}

impl Grip {
    /// Of the closed contacts at a state.
    pub(crate) fn of(system: &dyn System, state: &[f64], closed: &ContactSet) -> Self {
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
        let is_free = |row: usize| rows.place(row).is_some_and(|place| undetermined[place]);
        for friction in layout.frictions.iter().filter(|friction| sticks(friction.contact)) {
            let normal = is_free(friction.contact);
            if normal || is_free(friction.row) {
                grip.sticking = grip.sticking.with(friction.contact);
            }
            if normal {
                grip.normals = grip.normals.with(friction.contact);
            }
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
    let mut rows = ClosedRows::of(system, state, closed);
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
        let shared = SharedLoad::of(system, state, closed);
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
pub(crate) fn margin(system: &dyn System, state: &[f64], closed: &ContactSet, reactions: &[f64]) -> Margin {
    SharedLoad::of(system, state, closed).margin(reactions)
}

/// The closed contacts that stick with all that shares their load.
struct SharedLoad<'a> {
    layout: &'a Layout,
    closed: &'a ContactSet,
    rows: ClosedRows,
    slips: Slips,
}

impl<'a> SharedLoad<'a> {
    fn of(system: &'a dyn System, state: &[f64], closed: &'a ContactSet) -> Self {
        let slips = slips(system, state);
        Self { layout: system.layout(), closed, rows: bent_rows(system, state, closed, &slips), slips }
    }

    /// All that the margin follows from.
    fn numbers(&self, reactions: &[f64]) -> Vec<f64> {
        let Self { layout, closed, rows, slips } = self;
        let shared = closed.iter().filter(|&contact| rows.place(contact).is_some());
        let loads = shared.flat_map(|contact| {
            let friction = layout.contacts[contact].friction;
            let own = friction.map(|entry| [reactions[layout.contacts.len() + entry], slips[entry].limit]);
            own.into_iter().flatten().chain([reactions[contact]])
        });
        rows.jacobian.iter().copied().chain(loads).collect()
    }

    fn margin(&self, reactions: &[f64]) -> Margin {
        let Self { layout, closed, rows, slips } = self;
        let undetermined = rows.undetermined();
        let (edges, taken) = edges(layout, closed, (rows, &undetermined), slips, reactions);
        if edges.is_empty() {
            // At this position the motion determines all of them: none can go before its own
            // reaction does.
            return Margin {
                value: reactions.iter().fold(0.0, |most, load| load.abs().max(most)),
                leaving: Vec::new(),
            };
        }
        let others = (0..rows.rows.len()).filter(|place| !taken.contains(place));
        let others: Vec<DVector<f64>> = others.map(|place| rows.jacobian.row(place).transpose()).collect();
        let columns: Vec<DVector<f64>> = edges.iter().map(|edge| edge.column.clone()).collect();
        let loads = DVector::from_iterator(edges.len(), edges.iter().map(|edge| edge.load));
        let Some((value, velocities)) = limit(&row_space(&columns, &others), &loads) else {
            // Internal forces hold the contacts under any load.
            return Margin { value: loads.amax(), leaving: Vec::new() };
        };
        let least = MARGIN * velocities.amax();
        let moving = edges.iter().zip(velocities.iter()).filter(|(_, v)| **v > least);
        let slips: Vec<(usize, Sense)> = moving.filter_map(|(edge, _)| edge.slip).collect();
        let opens = |contact: usize| slips.iter().filter(|(other, _)| *other == contact).count() > 1;
        Margin { value, leaving: slips.iter().copied().filter(|(contact, _)| !opens(*contact)).collect() }
    }
}

/// The edges of all contacts whose reactions are not determined, and the places of their rows.
fn edges(
    layout: &Layout,
    closed: &ContactSet,
    (rows, undetermined): (&ClosedRows, &[bool]),
    slips: &[SlipState<f64>],
    reactions: &[f64],
) -> (Vec<Edge>, Vec<usize>) {
    let (mut edges, mut taken) = (Vec::new(), Vec::new());
    let rounding = ROUNDED * reactions.iter().fold(0.0, |most: f64, load| most.max(load.abs()));
    for contact in closed.iter() {
        let Some(normal) = rows.place(contact) else { continue };
        let entry = layout.contacts[contact].friction.filter(|_| closed.slip(contact) == Slip::Stick);
        let tangent = entry.and_then(|entry| Some((entry, rows.place(layout.frictions[entry].row)?)));
        if !undetermined[normal] && !tangent.is_some_and(|(_, place)| undetermined[place]) {
            continue;
        }
        taken.push(normal);
        let side = f64::from(closed.side(contact).sign());
        let (pressing, bearing) = (rows.jacobian.row(normal).transpose() * side, side * reactions[contact]);
        let Some((entry, place)) = tangent else {
            edges.push(Edge { column: pressing, load: bearing, slip: None });
            continue;
        };
        taken.push(place);
        let (limit, friction) = (slips[entry].limit, reactions[layout.contacts.len() + entry]);
        // Where R = −μ λ_N the edge J_N + μ J_t bears nothing, and moves as the contact slips
        // forward.
        for (sign, sense) in [(1.0, Sense::Forward), (-1.0, Sense::Backward)] {
            let column = &pressing + rows.jacobian.row(place).transpose() * (sign * limit);
            let bears = limit > 0.0 && friction.abs() > rounding;
            let across = if bears { sign * friction / limit } else { 0.0 };
            let load = 0.5 * (bearing + across);
            edges.push(Edge { column, load, slip: Some((contact, sense)) });
        }
    }
    (edges, taken)
}

/// An orthonormal basis of the combinations of edges' loads that the motion determines, while other
/// rows bear anything.
fn row_space(edges: &[DVector<f64>], others: &[DVector<f64>]) -> DMatrix<f64> {
    let mut columns = DMatrix::from_columns(edges);
    if !others.is_empty() {
        let basis = range(&DMatrix::from_columns(others));
        columns -= &basis * basis.tr_mul(&columns);
    }
    range(&columns.transpose())
}

/// s for loads of the edges, and the velocities of the edges in the motion that follows at s = 0.
/// `None` where s has no bound. A few edges are solved for first; an edge that their motion
/// violates is added.
fn limit(space: &DMatrix<f64>, loads: &DVector<f64>) -> Option<(f64, DVector<f64>)> {
    let (m, size) = (space.nrows(), loads.amax());
    if size == 0.0 {
        return Some((0.0, DVector::zeros(m)));
    }
    // Loads that are shifted alike on all edges shift s, which is then positive.
    let shift = 1.0 - loads.min().min(0.0) / size;
    let held = space.tr_mul(&(loads / size).add_scalar(shift));
    let mut asked = spread(m, FEW);
    loop {
        let Some((s, velocities)) = limit_by(space, &asked, &held) else {
            if asked.len() == m {
                return None;
            }
            asked = spread(m, 2 * asked.len());
            continue;
        };
        let worst = velocities.argmin().0;
        if velocities[worst] >= -RANK * velocities.amax() || asked.contains(&worst) {
            return Some(((s - shift) * size, velocities));
        }
        asked.push(worst);
    }
}

/// So many of some places, the first and the last among them.
fn spread(places: usize, count: usize) -> Vec<usize> {
    let count = count.min(places);
    (0..count).map(|k| k * (places - 1) / (count - 1).max(1)).collect()
}

/// The same where some of the edges alone bound s.
fn limit_by(space: &DMatrix<f64>, asked: &[usize], held: &DVector<f64>) -> Option<(f64, DVector<f64>)> {
    let (m, r) = (asked.len(), space.ncols());
    let edge = |i: usize, j: usize| if i < m { space[(asked[i], j)] } else { space.column(j).sum() };
    let bounds = DMatrix::from_fn(m + 1, r, edge);
    let mut matrix = DMatrix::zeros(2 * r + m + 1, 2 * r + m + 1);
    for (start, sign) in [(0, 1.0), (r, -1.0)] {
        matrix.view_mut((start, 2 * r), (r, m + 1)).copy_from(&(bounds.transpose() * -sign));
        matrix.view_mut((2 * r, start), (m + 1, r)).copy_from(&(&bounds * sign));
    }
    let mut q = DVector::zeros(2 * r + m + 1);
    q.rows_mut(0, r).copy_from(held);
    q.rows_mut(r, r).copy_from(&-held);
    q[2 * r + m] = -1.0;
    let basic = lemke::solve(&matrix, &q, &DVector::repeat(q.len(), 1.0))?;
    // Where loads vanish fewer edges bear than the motion has components: the others of these are
    // zero at the vertex.
    let bearing: Vec<usize> = (0..=m).filter(|&i| basic[2 * r + i]).collect();
    let moving: Vec<usize> = (0..r).filter(|&j| basic[j] || basic[r + j]).collect();
    let tight = bounds.select_rows(&bearing).select_columns(&moving);
    let last = bearing.iter().position(|&i| i == m)?;
    let svd = decomposition::svd(tight.clone());
    let cutoff = RANK * svd.singular_values.amax();
    let unit = DVector::from_fn(bearing.len(), |i, _| if i == last { 1.0 } else { 0.0 });
    let velocities = space.select_columns(&moving) * svd.solve(&unit, cutoff).ok()?;
    let s = decomposition::svd(tight.transpose()).solve(&held.select_rows(&moving), cutoff).ok()?[last];
    Some((s, velocities))
}

#[cfg(test)]
mod tests;
