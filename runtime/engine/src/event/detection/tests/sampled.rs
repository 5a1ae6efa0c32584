//! Values of guards, and how often what they follow from is evaluated.

use super::super::sample::Scratch;
use super::super::{EventDetector, FrictionGuard, Guard, StepView};
use super::given::*;
use crate::model::{ContactSet, Form, Side, Slip};
use crate::numerics::root_isolation::NODES;
use crate::system::{DenseOutput, Model};
use liftoff_fixtures::Particle;

/// Numbers that are all different at all times.
fn different(t: f64) -> Shown {
    let number = |k: usize| (k as f64 + 1.0) * (1.0 + t) + t * t;
    Shown {
        reactions: core::array::from_fn(number),
        gaps: core::array::from_fn(|k| number(20 + k)),
        slips: core::array::from_fn(|k| [number(40 + k), number(50 + k)]),
        feet: core::array::from_fn(|k| number(60 + k)),
        ..Shown::default()
    }
}

fn all() -> ContactSet {
    let set = set(&[PLAIN, CORNER]).slipping(RUBBING, Slip::Stick).slipping(HINGE, Slip::Backward);
    set.slipping(GUIDE, Slip::Forward).pressing(GUIDE, Side::Negative)
}

fn expected(guard: Guard, t: f64) -> f64 {
    let shown = different(t);
    let signed = |sign: i8, x: f64| f64::from(sign) * x;
    match guard {
        Guard::Reaction(contact) => shown.reactions[contact],
        Guard::Side(contact, side) => signed(side.sign(), shown.reactions[contact]),
        Guard::Gap(contact) => shown.gaps[contact],
        Guard::RedundantGap(contact) => -shown.gaps[contact],
        Guard::Foot { entry, .. } => shown.feet[entry],
        Guard::Slip(FrictionGuard { friction, slip, .. }) => signed(slip.sign(), shown.slips[friction][0]),
        Guard::Limit(FrictionGuard { contact, friction, slip, side }) => {
            signed(side.sign(), shown.slips[friction][1] * shown.reactions[contact])
                + signed(slip.sign(), shown.reactions[CONTACTS + friction])
        }
        Guard::SharedFriction | Guard::Condition(_) => f64::NAN,
    }
}

/// At nodes and between, in steps that continue each other and in others.
#[test]
fn guards_have_their_values_in_every_step() {
    for form in [Form::Reduced, Form::Multipliers] {
        let scene = Scene::new((all(), form), different);
        let mut detector = scene.begun(roles(all().with(THREAD)), (&[], false));
        assert!(detector.list.len() > 12);
        for step in [[0.0, 0.5], [0.5, 1.0], [0.25, 2.0], [2.0, 2.5]] {
            let dense = scene.dense(step);
            let view: StepView<'_> = scene.view(&dense);
            detector.begin_step(&view);
            for theta in NODES.iter().chain(&[0.1, 0.77]).chain(&NODES[3..5]) {
                let t = step[0] + (step[1] - step[0]) * theta;
                for watch in &detector.list {
                    let found = watch.value(&detector.sampled(&view), *theta);
                    let apart = (found - expected(watch.tracking.guard, t)).abs();
                    assert!(apart < 1e-12 * found.abs(), "{:?} {step:?} {theta}", watch.tracking.guard);
                }
            }
        }
    }
}

/// Once at each node for all guards, and not at all where the last step ended; between the nodes
/// once for all in a phase with multipliers, for each guard in another.
#[test]
fn each_place_is_evaluated_once() {
    let closed = set(&[PLAIN, CORNER, THREAD]);
    for (form, between) in [(Form::Reduced, 3), (Form::Multipliers, 1)] {
        let scene = Scene::new((closed, form), different);
        let mut detector = scene.begun(roles(closed), (&[], false));
        scene.asked();
        for (step, nodes) in [([0.0, 0.5], 10), ([0.5, 0.75], 9), ([0.75, 1.0], 9), ([0.5, 1.0], 10)] {
            let dense = scene.dense(step);
            let view = scene.view(&dense);
            detector.begin_step(&view);
            assert_eq!(scene.asked(), nodes, "{step:?}");
            let guards = [PLAIN, CORNER, THREAD].map(|contact| detector.find(Guard::Reaction(contact)));
            let step_view = detector.sampled(&view);
            for theta in NODES {
                guards.iter().for_each(|guard| _ = guard.value(&step_view, theta));
            }
            assert_eq!(scene.asked(), 0, "{step:?}");
            for theta in [0.1, 0.2] {
                guards.iter().for_each(|guard| _ = guard.value(&step_view, theta));
                assert_eq!(scene.asked(), between, "{step:?} {theta}");
            }
        }
    }
}

/// As many places as there is room for: with the next one they are begun anew. Gaps have nothing to
/// do with it.
#[test]
fn places_are_kept_as_long_as_there_is_room() {
    const ROOM: usize = 4096;
    let closed = set(&[PLAIN, CORNER]);
    let scene = Scene::new((closed, Form::Multipliers), different);
    let mut detector = scene.begun(roles(closed), (&[], false));
    let dense = scene.dense([0.0, 1.0]);
    let view = scene.view(&dense);
    detector.begin_step(&view);
    scene.asked();
    let [corner, gap] = [Guard::Reaction(CORNER), Guard::Gap(THREAD)].map(|guard| detector.find(guard));
    let step = detector.sampled(&view);
    let place = |k: usize| (k as f64 + 0.5) / (2 * ROOM) as f64;
    let value = |k: usize| {
        let found = corner.value(&step, place(k));
        let expected = different(place(k)).reactions[CORNER];
        assert!((found - expected).abs() < 1e-12 * expected, "{k}");
    };
    (0..ROOM - 1).for_each(value);
    assert_eq!(scene.asked(), ROOM - 1);
    value(0);
    assert_eq!(scene.asked(), 0);
    (ROOM - 1..ROOM).for_each(value);
    assert_eq!(scene.asked(), 1);
    (0..ROOM - 1).for_each(value);
    assert_eq!(scene.asked(), ROOM - 1);
    let found = gap.value(&step, 0.123);
    assert!((found - different(0.123).gaps[THREAD]).abs() < 1e-12 * found && scene.asked() == 0);
}

/// One guard alone has nothing to share.
#[test]
fn what_only_one_guard_follows_from_is_not_kept() {
    let scene = Scene::new((set(&[PLAIN]), Form::Multipliers), different);
    let mut detector = scene.begun(roles(set(&[PLAIN])), (&[], false));
    let dense = scene.dense([0.0, 1.0]);
    let view = scene.view(&dense);
    detector.begin_step(&view);
    scene.asked();
    let guard = detector.find(Guard::Reaction(PLAIN));
    (0..2).for_each(|_| _ = guard.value(&detector.sampled(&view), 0.1));
    assert_eq!(scene.asked(), 2);
}

/// R (v − v°) at the nodes, where friction is all that works and all that it takes is evaluated; v°
/// is the slip at the start.
#[test]
fn the_power_of_friction_is_reported_where_nothing_else_works() {
    let slides = ContactSet::EMPTY.slipping(RUBBING, Slip::Forward);
    let powers = |closed: ContactSet, damped: bool, with: ContactSet| {
        let mut scene = Scene::closed(closed, |t| {
            let mut shown = Shown::default();
            (shown.reactions[RUBBING], shown.reactions[CONTACTS]) = (2.0 + t, -0.5 - 0.25 * t);
            shown.slips[0] = [1.5 - t * t, 0.25];
            shown
        });
        scene.context.scales.damped = damped;
        let still = DenseOutput::still(0.0, &[0.0]);
        let mut detector =
            EventDetector::new(scene.context.layout(), closed, roles(with), (&[], &[]), BOUNDS);
        detector.begin(&scene.view(&still).with_closed(with));
        let mut told = Vec::new();
        for step in [[0.0, 0.5], [0.5, 0.75]] {
            let dense = scene.dense(step);
            detector.begin_step(&scene.view(&dense).with_closed(with));
            told.push((step, detector.friction_powers()));
        }
        told
    };
    for ([from, to], found) in powers(slides, false, slides) {
        for (theta, power) in NODES.iter().zip(found.expect("reactions and slips")) {
            let t = from + (to - from) * theta;
            let expected = (-0.5 - 0.25 * t) * -t * t;
            assert!((power - expected).abs() < 1e-14, "{t}: {power} {expected}");
        }
    }
    let untold = |told: Vec<([f64; 2], Option<_>)>| told.iter().all(|(_, powers)| powers.is_none());
    assert!(untold(powers(slides, true, slides)) && untold(powers(slides, false, slides.with(PLAIN))));
    assert!(untold(powers(set(&[PLAIN]), false, set(&[PLAIN]))));
    let smooth = Model::new(&Particle { m: 1.0, g: 1.0, e: 0.0 });
    let mut scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
    scene.context.model = smooth;
    let still = scene.dense([0.0, 1.0]);
    let mut scratch = Scratch::new(scene.context.layout());
    assert!(scene.view(&still).slips_at_rest(&mut scratch).is_none());
}
