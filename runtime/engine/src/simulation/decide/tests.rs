//! What is decided on snapshots, and what a phase is entered with.

use core::f64::consts::FRAC_PI_2;

use liftoff_fixtures::{RodOnSupports, Zigzag};

use crate::contact::friction::SlipVelocity as KnownSlip;
use crate::model::ContactSet;
use crate::prelude::*;
use crate::simulation::decide::DecisionInput;
use crate::simulation::tests::given::*;

/// Bars folded upright, where the gaps of all feet have one Jacobian.
fn folded(l: f64, form: Form) -> Simulation {
    let pose = Pose::new("phi_inner", FRAC_PI_2).with("phi_outer", FRAC_PI_2);
    let pose = pose.with("phi_inner'", -1.5).with("phi_outer'", -1.5);
    let zigzag = Simulation::new(&Zigzag { m1: 0.5, m2: 0.7, l, g: 10.0 * l }).unwrap();
    zigzag.start(pose).unwrap().form(form)
}

/// A level rod that slides on its three feet, of which two bear it.
fn sliding(l: f64) -> Simulation {
    let pose = Pose::new("theta", 0.0).with("x'", 1.0).with("y", 0.0);
    Simulation::new(&RodOnSupports { m: 1.0, l, g: 10.0 }).unwrap().start(pose).unwrap()
}

/// Contacts that depend on each other here alone all bear a phase that is reduced to them.
#[test]
fn all_contacts_bear_where_their_reduced_form_holds() {
    for (form, all_bear) in [(Form::Reduced, true), (Form::Multipliers, false)] {
        with_begun(&folded(1.0, form), |now, _| {
            let (closed, one) = (now.closed(), set(0));
            assert_eq!(closed.len(), 2);
            assert_eq!(now.choose_active_basis(closed, one), if all_bear { closed } else { one });
        });
    }
}

/// A position is singular where contacts depend on each other there alone, in any unit of length.
#[test]
fn a_position_is_singular_in_any_unit_of_length() {
    for l in [1e-3, 1.0, 1e3] {
        with_begun(&folded(l, Form::Multipliers), |mut now, _| {
            now.bear(set(0)).unwrap();
            assert!(now.is_singular(), "{l}");
        });
    }
    for a in [1e-3, 1.0, 1e3] {
        let pose = Pose::new("x", a).with("y", 0.0).with("x'", a);
        let ball = Simulation::new(&Osculating { m: 1.0, a, g: 10.0 * a }).unwrap();
        with_begun(&ball.start(pose).unwrap(), |mut now, _| {
            now.contacts.decide(set(0).with(1));
            now.bear(set(0)).unwrap();
            assert!(now.is_singular(), "{a}");
        });
    }
    // Three feet of a rod depend on each other everywhere.
    with_begun(&sliding(1.0), |now, _| {
        assert!(now.active_basis() != now.closed() && !now.is_singular());
    });
}

/// A contact that depended on others has parted where its gap is above its bound, a part of the
/// natural length.
#[test]
fn contacts_part_by_more_than_the_bound_of_their_gaps() {
    with_begun(&sliding(1e3), |mut now, _| {
        let dependent = now.closed().difference(now.active_basis());
        assert_eq!(dependent.len(), 1);
        for (gap, parted) in [(1e-9, ContactSet::EMPTY), (1e-7, dependent)] {
            now.state[2] = gap;
            assert_eq!(now.find_parted(), parted, "{gap}");
        }
    });
}

/// A slip is at rest within a part of the natural speed.
#[test]
fn a_slip_is_at_rest_within_a_part_of_the_natural_speed() {
    for (velocity, known) in [(1e-10, KnownSlip::Rest), (1e-8, KnownSlip::Forward)] {
        // Its natural speed is 100 m/s.
        with_start(&start(&BALL, [1e3, 0.0, 0.0, 0.0]), |mut ball| {
            ball.state[2] = velocity;
            assert_eq!(ball.known_slips(&DecisionInput::about(set(FLOOR))), [(FLOOR, known)], "{velocity}");
        });
    }
}

/// A contact at rest is at its limit only where it touches.
#[test]
fn only_contacts_that_touch_are_at_their_limits() {
    for (q, at_limit) in [(5.0, true), (4.9, false)] {
        with_start(&start(&Ball { q, ..BALL }, [2.5, 0.0, 0.0, 0.0]), |ball| {
            let limits = |touching| ball.at_static_limits(touching).contacts();
            assert_eq!(limits(set(FLOOR)), if at_limit { set(FLOOR) } else { ContactSet::EMPTY });
            assert!(limits(ContactSet::EMPTY).is_empty());
        });
    }
}
