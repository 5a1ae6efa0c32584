//! What is lost between two phases.

use super::super::Trajectory;
use crate::expression::Variable;
use crate::integration::phase_point::PhasePoint;
use crate::trajectory::RecordedPhase;

/// What the energy falls by from the end of a phase to the start of the next, and what was done on
/// the model in between. Not a number where impulses of drives that hold throughout, or of rough
/// surfaces that move, did work: events do not have them.
pub(super) fn loss(record: &Trajectory, [before, after]: [&RecordedPhase; 2]) -> f64 {
    let span = [before.t1, after.t0];
    let [from, to] = [before.interpolate(before.t1), after.interpolate(after.t0)];
    let system = record.context.system();
    // A spring that comes or goes takes its energy with it: none of that is lost in the motion.
    let left = record.context.switched_as(from.state(), to.state());
    let [old, new] = [&left, to.state()].map(|state| system.energy(state));
    let fall = -new.gained_since(&old);
    let is_impact = |t: f64| span[0] <= t && t <= span[1];
    let applied: f64 = record
        .impulses
        .iter()
        .filter(|impulse| is_impact(impulse.t))
        .map(|impulse| {
            let speed = |axis: usize| {
                0.5 * (rate(record, &from, impulse.point, axis) + rate(record, &to, impulse.point, axis))
            };
            impulse.impulse[0] * speed(0) + impulse.impulse[1] * speed(1)
        })
        .sum();
    let struck = record.events.iter().any(|event| is_impact(event.t) && !event.impulses.is_empty());
    let struck = struck || record.impulses.iter().any(|impulse| is_impact(impulse.t));
    let carried = if struck { carried(record, &to, is_impact) } else { 0.0 };
    fall + applied + carried
}

/// A component of the velocity of a point.
fn rate(record: &Trajectory, at: &PhasePoint, index: usize, axis: usize) -> f64 {
    Variable::Point { index, axis, order: 1 }.value(&record.context, at)
}

/// The work of moving surfaces and of drives that take hold, whose velocity is −∂g/∂t of the slip
/// or of the gap.
fn carried(record: &Trajectory, at: &PhasePoint, is_impact: impl Fn(f64) -> bool) -> f64 {
    let layout = record.layout();
    let equations = record.context.system().equations(at.state());
    let of_friction = |row: usize| layout.frictions.iter().any(|friction| friction.row == row);
    let others = (layout.contacts.len()..layout.rows()).filter(|&row| !of_friction(row));
    if others.clone().any(|row| equations.prescribed_gap_rate()[row] != 0.0) {
        return f64::NAN;
    }
    let impulses = record.events.iter().filter(|event| is_impact(event.t)).flat_map(|event| &event.impulses);
    let work = impulses.map(|impulse| {
        let friction = layout.contacts[impulse.contact].friction.zip(impulse.friction);
        let along = friction
            .map_or(0.0, |(k, force)| force * equations.prescribed_gap_rate()[layout.frictions[k].row]);
        -impulse.value * equations.prescribed_gap_rate()[impulse.contact] - along
    });
    work.sum()
}
