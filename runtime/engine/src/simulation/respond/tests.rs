//! Decisions and responses on snapshots of their own, without a run.

use crate::contact::friction::Sense;
use crate::event::{EventKind, Guard, Note};
use crate::model::{ContactSet, Slip};
use crate::prelude::*;
use crate::simulation::awaited::Awaited;
use crate::simulation::decide::{LocatedSlips, Question};
use crate::simulation::respond::Next;
use crate::simulation::snapshot::{PhaseStart, Snapshot, ZenoClosure};

/// A ball over a rough floor, a wall that is there from t = 1 on, and wind behind x = 2.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e, friction = mu)]
#[support(w = wall(3), facing = left, under = P, while("t > 1"))]
#[force(P = (q, 0), while("x > 2"))]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    g: f64,
    e: f64,
    mu: f64,
    q: f64,
}

const BALL: Ball = Ball { m: 2.0, g: 10.0, e: 0.5, mu: 0.25, q: 3.0 };
/// The places of the floor and the wall.
const FLOOR: usize = 0;
const WALL: usize = 1;

fn set(contact: usize) -> ContactSet {
    ContactSet::EMPTY.with(contact)
}

/// The snapshot of a simulation at its start, moved to a state (x, y, ẋ, ẏ).
fn with_snapshot(
    prepare: impl FnOnce(Simulation) -> Simulation,
    state: [f64; 4],
    check: impl FnOnce(Snapshot<'_>),
) {
    let start = Pose::at("x", state[0]).with("y", state[1]).with("x'", state[2]).with("y'", state[3]);
    let simulation = Simulation::new(&BALL).unwrap().start(start).unwrap();
    let simulation = prepare(simulation);
    let awaited = Awaited::from_setup(&simulation);
    let start = simulation.started().unwrap();
    check(Snapshot::new(&simulation, &awaited, start));
}

/// The same once the run has begun, with what its first phase begins with.
fn with_phase(
    prepare: impl FnOnce(Simulation) -> Simulation,
    state: [f64; 4],
    check: impl FnOnce(Snapshot<'_>, &PhaseStart),
) {
    with_snapshot(prepare, state, |mut ball| {
        ball.begin().unwrap();
        let start = ball.phase_start();
        check(ball, &start);
    });
}

fn kinds(snapshot: &Snapshot<'_>) -> Vec<EventKind> {
    snapshot.transition.events.iter().map(|event| event.kind).collect()
}

#[test]
fn a_decision_changes_nothing_until_it_is_adopted() {
    with_snapshot(
        |it| it,
        [0.0, 0.0, 3.0, 0.0],
        |mut ball| {
            let question = Question::about(set(FLOOR));
            let decision = ball.decide(&question).ok().unwrap();
            assert!(ball.bearing().is_empty() && ball.reactions == [0.0, 0.0, 0.0]);
            ball.adopt(decision);
            // N = m g, and friction against the slip.
            assert!(ball.bearing().contains(FLOOR));
            assert_eq!(ball.reactions, [20.0, 0.0, -5.0]);
        },
    );
}

#[test]
fn a_gap_at_zero_is_an_impact() {
    with_phase(
        |it| it,
        [0.0, 1.0, 0.0, 0.0],
        |mut ball, start| {
            (ball.t, ball.state[1], ball.state[3]) = (0.5, 0.0, -4.0);
            assert_eq!(ball.handle(&[Guard::Gap(FLOOR)], start).unwrap(), Next::Continue);
            assert_eq!(kinds(&ball), [EventKind::Start, EventKind::Impact]);
            let impact = &ball.transition.events[1];
            // P = m (1 + e) v.
            assert!((impact.impulses[0].value - 12.0).abs() < 1e-14 && (ball.state[3] - 2.0).abs() < 1e-15);
            assert_eq!(impact.before.as_ref().unwrap().state[3], -4.0);
            assert!(ball.onset.is_struck && ball.closed().is_empty());
        },
    );
}

#[test]
fn a_slip_at_zero_sticks() {
    with_phase(
        |it| it,
        [0.0, 0.0, 3.0, 0.0],
        |mut ball, start| {
            let guard = Guard::Slip(crate::event::Rub {
                contact: FLOOR,
                friction: 0,
                slip: ball.closed().slip(FLOOR),
                side: ball.closed().side(FLOOR),
            });
            (ball.t, ball.state[2]) = (1.2, 0.0);
            ball.handle(&[guard], start).unwrap();
            assert_eq!(kinds(&ball), [EventKind::Start, EventKind::Stick]);
            assert_eq!(ball.reactions, [20.0, 0.0, 0.0]);
        },
    );
}

#[test]
fn a_reaction_that_is_zero_and_stays_is_a_touch_that_is_kept() {
    with_phase(
        |it| it,
        [0.0, 0.0, 3.0, 0.0],
        |mut ball, start| {
            // The weight presses all the same.
            ball.handle(&[Guard::Reaction(FLOOR)], start).unwrap();
            assert_eq!(kinds(&ball), [EventKind::Start, EventKind::Touch]);
            assert!(ball.onset.kept.contains(FLOOR) && ball.onset.lifted.is_empty());
        },
    );
}

#[test]
fn what_is_due_happens_once() {
    let plan = |it: Simulation| it.impulse("P", [4.0, 0.0], 1.0).unwrap().release("P", 1.0).unwrap();
    with_snapshot(plan, [0.0, 0.0, 3.0, 0.0], |mut ball| {
        ball.begin().unwrap();
        assert_eq!(ball.next_time(), 1.0);
        ball.t = 1.0;
        assert_eq!(ball.reach_time().unwrap(), Next::Continue);
        // Removals come first, so that nothing rubs.
        assert_eq!(kinds(&ball)[1..], [EventKind::Release, EventKind::Impulse]);
        assert_eq!((ball.state[2], ball.contacts.absent()), (5.0, set(FLOOR).union(set(WALL))));
        assert!(ball.next_time() > 1.0);
        ball.reach_time().unwrap();
        assert_eq!(ball.transition.impulses.len(), 1);
    });
}

#[test]
fn conditions_arm_contacts_and_loads() {
    with_phase(
        |it| it,
        [1.0, 0.0, 3.0, 0.0],
        |mut ball, start| {
            assert!(ball.contacts.absent().contains(WALL));
            let arms = |label: &str| {
                ball.awaited
                    .places()
                    .filter(|&k| ball.is_awaited(k))
                    .find(|&k| ball.awaited.conditions[k].to_string().starts_with(label))
            };
            let guards = ["t", "x"].map(|label| Guard::Condition(arms(label).unwrap()));
            (ball.t, ball.state[0]) = (1.0, 2.0);
            ball.handle(&guards, start).unwrap();
            assert!(!ball.contacts.absent().contains(WALL));
            // The wind is heavier than friction, 3 N against 5 N: it goes on to slide.
            assert_eq!(kinds(&ball)[1..], [EventKind::Arm, EventKind::Arm]);
            let a = ball.accelerations(&ball.state, ball.bearing());
            assert!((a[0] - (3.0 - 5.0) / 2.0).abs() < 1e-15, "{a:?}");
        },
    );
}

#[test]
fn a_flight_too_low_to_be_seen_settles_at_its_end() {
    let v = 1e-8;
    with_snapshot(
        |it| it,
        [0.0, 0.0, 0.0, v],
        |mut ball| {
            ball.begin().unwrap();
            ball.settle_unseen().unwrap();
            assert!(ball.closed().contains(FLOOR));
            let ZenoClosure { end, set: settling, .. } = ball.bounces.settling[0];
            // 2 v/g (1 + e + e² + …)
            assert!((end / (2.0 * v / 10.0 / 0.5) - 1.0).abs() < 1e-12 && settling.contains(FLOOR));
            ball.t = end;
            ball.reach_time().unwrap();
            assert_eq!(kinds(&ball).last(), Some(&EventKind::Settle));
            assert!(ball.bounces.settling.is_empty());
        },
    );
}

#[test]
fn a_stop_ends_before_the_impact() {
    with_phase(
        |it| it.until("y = 0").unwrap(),
        [0.0, 1.0, 0.0, 0.0],
        |mut ball, start| {
            (ball.state[1], ball.state[3]) = (0.0, -4.0);
            let guards = [Guard::Gap(FLOOR), Guard::Condition(0)];
            assert_eq!(ball.handle(&guards, start).unwrap(), Next::Finished);
            assert_eq!(kinds(&ball), [EventKind::Start, EventKind::Stop]);
            assert!(
                matches!(ball.transition.events[1].note, Some(Note::Condition(_))) && ball.state[3] == -4.0
            );
        },
    );
}

#[test]
fn what_a_condition_may_move_begins_at_rest() {
    with_snapshot(
        |it| it,
        [0.0; 4],
        |mut ball| {
            assert_eq!(ball.begin().unwrap(), Next::Continue);
            assert_eq!(
                (kinds(&ball), ball.closed()),
                (vec![EventKind::Start], set(FLOOR).slipping(FLOOR, Slip::Stick))
            );
        },
    );
}

#[test]
fn what_has_stopped_does_not_leave() {
    let mut located = LocatedSlips::default();
    located.leave(FLOOR, Sense::Forward);
    assert!(located.is_leaving());
    located.stop(FLOOR);
    located.leave(FLOOR, Sense::Backward);
    assert!(!located.is_leaving() && !located.is_empty() && located.contacts() == set(FLOOR));
}

/// Up by h onto the floor at ẋ: the speed pays for m g h, unless the state was given.
#[test]
fn a_shift_onto_contacts_gains_no_energy() {
    let h = 1e-11;
    with_snapshot(
        |it| it,
        [0.0, 0.0, 3.0, 0.0],
        |mut ball| {
            ball.state[1] = -h;
            let before = ball.energy();
            let (shifted, by) = ball.project(set(FLOOR), 0.0, false).unwrap();
            assert!(shifted[1] == 0.0 && by > 0.0);
            let expected = (9.0 - 2.0 * 10.0 * h).sqrt();
            assert!((shifted[2] - expected).abs() < 1e-15, "{} {expected}", shifted[2]);
            let (given, _) = ball.project(set(FLOOR), 0.0, true).unwrap();
            assert_eq!(given[2], 3.0);
            ball.state = shifted;
            assert!(
                (ball.energy().kinetic + ball.energy().potential - before.kinetic - before.potential).abs()
                    < 1e-14
            );
        },
    );
}

/// An opening that rounding makes of zero is none, whatever the units are in which it is one.
#[test]
fn an_impact_without_restitution_leaves_nothing_to_open() {
    let plastic = |it: Simulation| Simulation { restitution: vec![0.0; it.restitution.len()], ..it };
    with_phase(plastic, [0.0, 1.0, 0.3, 0.0], |mut ball, start| {
        (ball.state[1], ball.state[3]) = (0.0, -4.0);
        ball.handle(&[Guard::Gap(FLOOR)], start).unwrap();
        assert!(ball.closed().contains(FLOOR) && ball.state[3] == 0.0);
    });
}
