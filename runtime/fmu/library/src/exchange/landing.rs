//! The state at an event from that at which an importer has located it: what is to be zero there is
//! zero.
//!
//! Contacts that close: the state is taken back along the motion, q + v τ + a τ²/2 and v + a τ, to
//! where the gap that is deepest was zero, so that no energy comes from the way below; then to the
//! nearest position with g = 0 in the mass metric, with the rates that contacts are struck with.
//! Contacts that cease to slide: the nearest rates without slip, if they are near: where a linkage
//! passes a dead point a slip changes its sign while others go on, and nothing comes to rest. A
//! corner that has come to the end of its bar is lifted off it, by less than can be seen and more
//! than counts as closed.

use super::indicators::{STEPS, ends};
use super::projected;
use crate::place::Instant;
use liftoff::Simulation;
use liftoff_core::model::{ContactSet, Slip};
use liftoff_fmu::Guard;

/// Gaps below a tenth of this, in natural lengths, count as closed at a start.
const LIFT: f64 = 1e-9;
const CORRECTIONS: usize = 3;

/// Rates without slip are near if they are changed by no more than so many bands of an indicator:
/// other rates may be changed more than the slip that was in the band.
const NEAR: f64 = 100.0;

/// The state at an event at which these indicators have crossed zero.
pub(crate) fn land(
    simulation: &Simulation,
    (place, tolerance): (&Instant, f64),
    crossed: &[Guard],
) -> Vec<f64> {
    let (before, n) = (place.phase.set, simulation.layout().coordinates.len());
    let of = |is: fn(&Guard) -> bool| -> ContactSet {
        crossed.iter().filter(|guard| is(guard)).map(|guard| guard.contact()).collect()
    };
    let leaving = of(|guard| matches!(guard, Guard::End(_)));
    let closing = of(|guard| matches!(guard, Guard::Normal(_))).union(below(simulation, place));
    let closing = closing.difference(before.closed());
    let stopping = of(|guard| matches!(guard, Guard::Friction(_)));
    let kept = place.phase.active_basis.difference(leaving);
    let touching = closing.iter().fold(kept, ContactSet::with);
    let struck = taken_back(simulation, place, closing);
    let mut state = projected(simulation, touching, place.t, &struck);
    lift(simulation, (touching, leaving), place.t, &mut state);
    state[n..].copy_from_slice(&struck[n..]);
    let kept_state = projected(simulation, kept, place.t, &state);
    let stuck = stopping.iter().filter(|&i| kept.sense(i) != 0);
    let resting = stuck.fold(kept, |set, i| set.slipping(i, Slip::Stick));
    let rested = projected(simulation, resting, place.t, &kept_state);
    match apart(simulation, &kept_state, &rested) <= NEAR * STEPS * tolerance {
        // Where that cannot be, the contacts stay closed.
        true => projected(simulation, kept, place.t, &rested),
        false => kept_state,
    }
}

/// How far two states are apart at most, in natural units.
fn apart(simulation: &Simulation, a: &[f64], b: &[f64]) -> f64 {
    let unit = |i: usize| simulation.scales().entry(simulation.layout(), i);
    a.iter().zip(b).enumerate().fold(0.0, |most, (i, (a, b))| f64::max(most, (a - b).abs() / unit(i)))
}

/// The open contacts that are penetrated: by less than their bands, or by as much as they crossed
/// zero together with others.
fn below(simulation: &Simulation, place: &Instant) -> ContactSet {
    let (layout, ends) = (simulation.layout(), ends(simulation, place));
    let mut gaps = vec![0.0; layout.contacts.len()];
    simulation.model().system.gaps(&layout.state_at(&place.state, place.t), &mut gaps);
    let over_bar = |i: usize| layout.contacts[i].foot.is_none_or(|foot| ends[foot] > 0.0);
    let open = |i: &usize| !place.phase.set.contains(*i) && !layout.contacts[*i].is_hinge();
    (0..gaps.len()).filter(open).filter(|&i| gaps[i] < 0.0 && over_bar(i)).collect()
}

/// The state a moment before, when the deepest of these contacts was reached.
fn taken_back(simulation: &Simulation, place: &Instant, closing: ContactSet) -> Vec<f64> {
    let (layout, system, n) = (simulation.layout(), &simulation.model().system, place.state.len() / 2);
    let full = layout.state_at(&place.state, place.t);
    let (mut a, mut multipliers) = (vec![0.0; n], vec![0.0; layout.rows()]);
    system.solve(&full, place.phase.active_basis, &mut a, &mut multipliers);
    let equations = system.equations(&full);
    let since = |i: usize| {
        let [gap, rate] = [equations.gap()[i], equations.gap_rate(i, &place.state[n..])];
        last_zero(gap, rate, equations.gap_acceleration(i, &a))
    };
    let moment = closing.iter().filter_map(since).fold(0.0, f64::min);
    let moved = |i: usize| match i.checked_sub(n) {
        None => moment.mul_add(moment.mul_add(0.5 * a[i], place.state[n + i]), place.state[i]),
        Some(rate) => moment.mul_add(a[rate], place.state[i]),
    };
    (0..2 * n).map(moved).collect()
}

/// The last τ < 0 at which g + ġ τ + g̈ τ²/2 was zero, of a gap that is below zero and falls; where
/// it never was, by the error of the state, that at which it was greatest.
fn last_zero(gap: f64, rate: f64, acceleration: f64) -> Option<f64> {
    let square = rate.mul_add(rate, -2.0 * gap * acceleration);
    let zero = || if square >= 0.0 { -2.0 * gap / (rate - square.sqrt()) } else { -rate / acceleration };
    (gap < 0.0 && rate < 0.0).then(zero)
}

/// Lifts contacts, while others stay closed.
fn lift(simulation: &Simulation, (touching, leaving): (ContactSet, ContactSet), t: f64, state: &mut [f64]) {
    if leaving.is_empty() {
        return;
    }
    let (layout, system) = (simulation.layout(), &simulation.model().system);
    let (n, height) = (layout.coordinates.len(), LIFT * simulation.scales().length);
    let set = leaving.iter().fold(touching, ContactSet::with);
    let mut change = vec![0.0; n];
    for _ in 0..CORRECTIONS {
        let full = layout.state_at(state, t);
        let mut residual = system.equations(&full).gap().to_vec();
        leaving.iter().for_each(|i| residual[i] -= height);
        system.correction(&full, set, &residual, &mut change);
        state.iter_mut().zip(&change).for_each(|(x, d)| *x += d);
    }
}
