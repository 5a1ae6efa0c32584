//! Decisions and responses on snapshots of their own, without a run.

use core::f64::consts::FRAC_PI_2;

use liftoff_fixtures::RodOnSupports;

use crate::contact::ContactError;
use crate::contact::friction::SlipDirection;
use crate::event::{EventKind, Guard, Note};
use crate::model::Slip;
use crate::prelude::*;
use crate::simulation::decide::{DecisionInput, LocatedSlips};
use crate::simulation::respond::Next;
use crate::simulation::snapshot::{PhaseStart, Snapshot, ZenoClosure};
use crate::simulation::tests::given::*;
use crate::trajectory::LoggedDecision;

/// The snapshot of a simulation of the ball at its start.
fn with_snapshot(
    prepare: impl FnOnce(Simulation) -> Simulation,
    state: [f64; 4],
    check: impl FnOnce(Snapshot<'_>),
) {
    with_start(&prepare(start(&BALL, state)), check);
}

/// The same once the run has begun, with what its first phase begins with.
fn with_phase(
    prepare: impl FnOnce(Simulation) -> Simulation,
    state: [f64; 4],
    check: impl FnOnce(Snapshot<'_>, &PhaseStart),
) {
    with_begun(&prepare(start(&BALL, state)), check);
}

#[test]
fn a_decision_changes_nothing_until_it_is_adopted() {
    with_snapshot(
        |it| it,
        [0.0, 0.0, 3.0, 0.0],
        |mut ball| {
            let question = DecisionInput::about(set(FLOOR));
            let decision = ball.decide(&question).ok().unwrap();
            assert!(ball.active_basis().is_empty() && ball.reactions == [0.0, 0.0, 0.0]);
            ball.adopt(decision);
            // N = m g, and friction against the slip.
            assert!(ball.active_basis().contains(FLOOR));
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
            let guard = Guard::Slip(crate::event::FrictionGuard {
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
            assert!(ball.onset.suppressed.contains(FLOOR) && ball.onset.opened_at_zero_reaction.is_empty());
        },
    );
}

#[test]
fn scheduled_actions_happen_once() {
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
            for (event, label) in ball.transition.events[1..].iter().zip(["x > 2", "t > 1"]) {
                let Some(Note::Condition(condition)) = &event.note else { panic!("{event:?}") };
                assert_eq!(condition.to_string(), label);
            }
            let a = ball.accelerations(&ball.state, ball.active_basis());
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

/// Where its reaction was located at zero its g̈ < 0 is the error of that place.
#[test]
fn opened_contacts_do_not_settle() {
    with_snapshot(
        |it| it,
        [0.0, 0.0, 0.0, 1e-8],
        |mut ball| {
            ball.begin().unwrap();
            ball.onset.opened_at_zero_reaction = set(FLOOR);
            ball.settle_unseen().unwrap();
            assert!(ball.closed().is_empty() && ball.bounces.settling.is_empty());
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
fn stopped_contacts_stay() {
    let mut located = LocatedSlips::default();
    located.leave(FLOOR, SlipDirection::Forward);
    assert!(located.is_leaving());
    located.stop(FLOOR);
    located.leave(FLOOR, SlipDirection::Backward);
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

/// What only depended on the contacts that bear opens, and those go on to bear as they did.
#[test]
fn contacts_that_part_open() {
    let rod = Simulation::new(&RodOnSupports { m: 2.0, l: 3.0, g: 10.0 }).unwrap();
    let rod = rod.start(Pose::new("theta", 0.0).with("x'", 1.0).with("y", 0.0)).unwrap();
    with_begun(&rod, |mut now, _| {
        let (bearing, parted) = (now.active_basis(), now.closed().difference(now.active_basis()));
        now.part(parted);
        assert_eq!((kinds(&now), now.closed()), (vec![EventKind::Start, EventKind::Open], bearing));
        let opened = now.layout().contacts[parted.iter().next().unwrap()].supports;
        assert_eq!(now.transition.events[1].supports, opened);
        let borne: f64 = bearing.iter().map(|i| now.reactions[i]).sum();
        assert!((borne - 20.0).abs() < 1e-13 && parted.iter().all(|i| now.reactions[i] == 0.0));
    });
}

/// Joints answer to an impulse as contacts do: (5/3) m a² φ′ = −p a of an upright linkage.
#[test]
fn joints_hold_in_impacts() {
    let linkage = Linkage { m: 3.0, a: 2.0, b: 5.0, g: 10.0 };
    let still = Pose::new("phi", FRAC_PI_2).with("phi'", 0.0);
    let struck = Simulation::new(&linkage).unwrap().start(still).unwrap().impulse("A", [7.0, 0.0], 0.5);
    with_begun(&struck.unwrap(), |mut now, _| {
        now.t = 0.5;
        now.reach_time().unwrap();
        let rate = -7.0 / (5.0 / 3.0 * 3.0 * 2.0);
        for (found, expected) in now.state[3..].iter().zip([rate, rate, 0.0]) {
            assert!((found - expected).abs() < 1e-14, "{:?}", now.state);
        }
    });
}

/// A pendulum stopped above its anchor falls off its circle: what holds at rest opens by its
/// acceleration, and that is not in doubt.
#[test]
fn a_contact_that_an_impact_leaves_at_rest_opens_by_its_acceleration() {
    let tethered = Tethered { m: 2.0, l: 5.0, d: -3.0, g: 10.0 };
    let pose = Pose::new("x", -5.0).with("y", 0.0).with("x'", 0.0).with("y'", 20.0);
    with_begun(&Simulation::new(&tethered).unwrap().start(pose).unwrap(), |mut now, start| {
        now.state.copy_from_slice(&[-3.0, 4.0, 8.0, 6.0]);
        let wall = now.layout().contacts.iter().position(|contact| contact.label == "w").unwrap();
        now.handle(&[Guard::Gap(wall)], start).unwrap();
        assert_eq!(kinds(&now)[1..], [EventKind::Impact, EventKind::Slack]);
        assert_eq!(now.state[2..], [0.0; 2]);
        assert!(now.transition.events[2].note.is_none(), "{:?}", now.transition.events[2]);
    });
}

/// Slips that end again and again without any time between are given up after some.
#[test]
fn slips_that_end_without_time_are_given_up() {
    let rod = Simulation::new(&Rod { m: 1.0, l: 1.0, g: 10.0, mu: 1.0 }).unwrap();
    let pose = Pose::new("theta", 1.0).with("y", 0.0).with("x'", -1.0).with("theta'", 0.0);
    with_begun(&rod.start(pose).unwrap(), |mut now, _| {
        let (state, phase, closed) = (now.state.clone(), now.phase.clone(), now.closed());
        let mut end = || {
            now.state.clone_from(&state);
            now.phase = phase.clone();
            now.contacts.decide(closed);
            now.cross_border().is_ok()
        };
        let ends = (0..8).take_while(|_| end()).count();
        // Four, and one for each contact.
        assert_eq!(ends, 5);
    });
}

/// Of starts at rest on their contacts but for rounding none is struck.
#[test]
fn roundoff_of_a_rate_strikes_nothing() {
    let bar = Simulation::new(&Overhang { m: 1.0, l: 1.0, g: 10.0 }).unwrap();
    for k in 0..20 {
        let (slide, turn) = (0.1, 0.3);
        let theta = 0.1 + 0.02 * f64::from(k);
        let (sin, cos) = theta.sin_cos();
        let pose = Pose::new("theta", theta).with("x", -0.5 * cos).with("y", -0.5 * sin);
        let pose = pose.with("theta'", turn).with("x'", slide).with("y'", (slide * sin - 0.5 * turn) / cos);
        with_start(&bar.clone().start(pose).unwrap(), |mut now| {
            assert!(now.closed().contains(0), "{k}");
            now.begin().unwrap();
            assert_eq!(kinds(&now), [EventKind::Start], "{k}");
        });
    }
}

/// Where drives alone tell the time it is that of the rates which they give.
#[test]
fn a_drive_tells_the_natural_time() {
    let driven = Simulation::new(&Driven { m: 1.0, l: 2.0, w: 5.0 }).unwrap();
    assert_eq!(driven.scales().time, 1.0);
    assert!((driven.start(Pose::nominal()).unwrap().scales().time - 0.2).abs() < 1e-15);
}

/// A wall that is not there is not struck at a start.
#[test]
fn absent_contacts_are_not_struck_at_the_start() {
    with_start(&start(&BALL, [3.0, 1.0, 1.0, 0.0]), |mut ball| {
        assert!(ball.contacts.absent().contains(WALL));
        ball.begin().unwrap();
        assert!(kinds(&ball) == [EventKind::Start] && ball.state[2] == 1.0);
    });
}

/// Friction that does not act cannot hold a motion up: where contacts without any jam, they jam.
#[test]
fn no_slip_ends_where_nothing_rubs() {
    with_begun(&start(&BALL, [3.0, 1.0, 1.0, 0.0]), |mut ball, _| {
        let source = ContactError::Jammed { contacts: vec!["w".into()] };
        assert!(ball.unjam(&DecisionInput::about(set(WALL)), source).is_err());
        assert!(kinds(&ball) == [EventKind::Start] && ball.state[2] == 1.0);
    });
}

/// What has come to rest is in no flight, and no end of its impacts but the new one is awaited.
#[test]
fn settled_contacts_have_no_flights() {
    with_begun(&start(&BALL, [0.0, 0.0, 0.0, 1e-8]), |mut ball, _| {
        for k in 0..9 {
            ball.bounces.begin(FLOOR, (f64::from(k), 0.5_f64.powi(k), 1.0));
        }
        let earlier = ZenoClosure { end: 7.0, error: 0.0, set: set(FLOOR) };
        ball.bounces.settling.push(earlier);
        ball.settle_unseen().unwrap();
        let bounces = &ball.bounces;
        assert!(bounces.heights.is_empty() && !bounces.sequences[FLOOR].slows());
        assert!(bounces.settling.len() == 1 && bounces.settling[0].end < 1.0);
    });
}

/// What comes where something touches it is struck, or closes, or is left.
#[test]
fn what_is_armed_where_it_is_touched_meets_what_moves() {
    for (velocity, kinds_then, closes) in [
        (2.0, &[EventKind::Arm, EventKind::Impact][..], true),
        (0.0, &[EventKind::Arm], true),
        (-2.0, &[EventKind::Arm], false),
    ] {
        with_begun(
            // The wind is stronger than friction.
            &self::start(&Ball { q: 9.0, ..BALL }, [3.0, 0.0, 1.0, 0.0]),
            |mut ball, start| {
                let is_wall = |k: &usize| ball.awaited.conditions[*k].to_string() == "t > 1";
                let armed = ball.awaited.places().find(is_wall).unwrap();
                (ball.t, ball.state[2]) = (1.0, velocity);
                ball.handle(&[Guard::Condition(armed)], start).unwrap();
                let happened = &kinds(&ball)[1..];
                assert!(happened.starts_with(kinds_then), "{velocity}: {happened:?}");
                assert_eq!(happened.contains(&EventKind::Impact), velocity > 0.0);
                assert_eq!(ball.closed().contains(WALL), closes, "{velocity}");
            },
        );
    }
}

/// A ball that comes to rest while it slides gives back the friction of its last flight,
/// μ m v for each m v of the rebound, and what that gains is told.
#[test]
fn friction_that_is_taken_ahead_is_reported() {
    let [v, w] = [3.0, 1e-8];
    with_begun(&start(&BALL, [0.0, 0.0, v, w]), |mut ball, _| {
        ball.settle_unseen().unwrap();
        let gained: Vec<f64> = ball
            .transition
            .log
            .iter()
            .filter_map(|it| match it.decision {
                LoggedDecision::FrictionAhead(gained) => Some(gained),
                _ => None,
            })
            .collect();
        let expected = BALL.m * BALL.mu * v * w;
        assert!(gained.len() == 1 && (gained[0] / expected - 1.0).abs() < 1e-7, "{gained:?} {expected}");
    });
}

/// Newton's law may gain energy where friction reverses a slip; the impact says how much.
#[test]
fn an_impact_tells_what_energy_its_law_gains() {
    let sled = Sled { m: 3.0, l: 1.0, g: 10.0, mu: 0.6, e: 0.95 };
    let mut gains = 0;
    for (theta, slip) in [0.2, 0.5, 0.8, 1.1, 1.4].into_iter().flat_map(|theta| [(theta, 0.3), (theta, -0.3)])
    {
        let pose = Pose::new("theta", theta).with("y", 1.0);
        with_begun(&Simulation::new(&sled).unwrap().start(pose).unwrap(), |mut now, start| {
            now.state.copy_from_slice(&[theta, 0.0, 0.0, 0.0, slip, -1.0]);
            let before = now.energy().kinetic;
            now.handle(&[Guard::Gap(0)], start).unwrap();
            assert!((now.state[5] - sled.e).abs() < 1e-12, "{theta} {slip}");
            let gained = now.energy().kinetic - before;
            match now.transition.events[1].note {
                Some(Note::EnergyGained(told)) => assert!((gained - told).abs() < 1e-12, "{theta} {slip}"),
                _ => assert!(gained <= 0.0, "{theta} {slip}"),
            }
            gains += usize::from(gained > 0.0);
        });
    }
    assert_eq!(gains, 3);
}

/// Without slip Newton's law gains nothing: restitution is scaled down to what it may be, and the
/// run's log says by how much.
#[test]
fn restitution_without_slip_is_scaled_to_what_gains_nothing() {
    let rod = Gripping { m: 3.0, l: 1.0, g: 10.0, e: 0.95 };
    let mut scaled = 0;
    for (theta, slip) in [0.3, 0.6, 0.9, 1.2].into_iter().flat_map(|theta| [(theta, 0.5), (theta, -0.5)]) {
        let pose = Pose::new("theta", theta).with("y", 1.0);
        with_begun(&Simulation::new(&rod).unwrap().start(pose).unwrap(), |mut now, start| {
            now.state.copy_from_slice(&[theta, 0.0, 0.0, 0.0, slip, -1.0]);
            let before = now.energy().kinetic;
            now.handle(&[Guard::Gap(0)], start).unwrap();
            assert!(now.energy().kinetic < before * (1.0 + 1e-9), "{theta} {slip}");
            let told = now.transition.log.iter().find_map(|it| match it.decision {
                LoggedDecision::RestitutionScaled(factor) => Some(factor),
                _ => None,
            });
            let factor = now.state[5] / rod.e;
            assert!((factor - told.unwrap_or(1.0)).abs() < 1e-9, "{theta} {slip}: {factor} {told:?}");
            scaled += usize::from(told.is_some());
        });
    }
    assert!(0 < scaled && scaled < 8, "{scaled}");
}
