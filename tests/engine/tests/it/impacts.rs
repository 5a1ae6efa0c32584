//! Impacts of derived systems against the catalogue, and what is planned for a run.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_3};
use liftoff::prelude::*;
use liftoff::{Instant, Note, Observer, RunCause, ScheduleError, StartError, Step};
use liftoff_fixtures::BouncingBar;
use liftoff_fixtures::Ladder;
use liftoff_fixtures::RodOnSupports;
use liftoff_fixtures::StruckChain;

const FORMS: [Form; 2] = [Form::Reduced, Form::Multipliers];

/// Catalogue 6, plastic: a bar at θ to the floor falls without spin; J = m v/(1 + 3 cos² θ).
#[test]
fn a_bar_end_strikes_the_floor() {
    for form in FORMS {
        for theta in [0.4f64, 1.1] {
            let fall = 0.25;
            let (x, y) = (2.0, fall + 0.5 * theta.sin());
            let pose = Pose::new("theta", theta).with("x", x).with("y", y);
            let run =
                Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap().form(form).start(pose).unwrap();
            let run = run.until("theta = 0.1").unwrap().run().unwrap();
            let impact = &run.events()[1];
            let v = (2.0 * fall).sqrt();
            assert_eq!((impact.kind, &impact.supports[..]), (EventKind::Impact, &["A"][..]));
            let [a] = &impact.impulses[..] else { panic!("{impact:?}") };
            assert!((a.value - v / (1.0 + 3.0 * theta.cos().powi(2))).abs() < 1e-12, "{impact:?}");
            assert!((impact.t - v).abs() < 1e-12);
            // The foot stays: the bar slides on the floor from then on.
            assert_eq!(run.segments()[1].closed, ["A"]);
            let energy = Output::parse(Ladder::LAYOUT, "E").unwrap();
            let lost = run.value(&energy, 0.0) - run.value(&energy, run.end_time());
            assert!((lost - 0.5 * v * a.value).abs() < 1e-11, "{lost}");
        }
    }
}

/// What is shown of the jumps of a run.
#[derive(Default)]
struct Jumps(Vec<(f64, Vec<f64>)>);

impl Observer for Jumps {
    fn jump(&mut self, before: &dyn Step) {
        let [_, t] = before.times();
        self.0.push((t, before.state(t)));
    }

    fn step(&mut self, _: &dyn Step) {}
}

/// The end of a level-falling bar strikes with v: events, arrays, observers and turning points have
/// the motion before too.
#[test]
fn both_sides_of_an_impact_are_kept() {
    let (fall, theta) = (0.25, 0.4f64);
    let v = (2.0f64 * fall).sqrt();
    let pose = Pose::new("theta", theta).with("x", 2.0).with("y", fall + 0.5 * theta.sin());
    let ladder = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let simulation = ladder.start(pose).unwrap().until("theta = 0.1").unwrap();
    let run = simulation.run().unwrap();
    let impact = &run.events()[1];
    let before = impact.before.as_ref().expect("an impact");
    assert!((before.state[5] + v).abs() < 1e-12 && before.state[3].abs() < 1e-12, "{before:?}");
    assert!((before.energy.kinetic - 0.5 * v * v).abs() < 1e-12, "{before:?}");
    let lost = -impact.energy.gained_since(&before.energy);
    assert!((lost - 0.5 * v * impact.impulses[0].value).abs() < 1e-12, "{impact:?}");
    assert!(run.events().iter().all(|event| event.before.is_some() == (event.kind == EventKind::Impact)));

    let instants = run.instants();
    assert_eq!(instants.len(), run.times().len() + 1);
    let place = instants.iter().position(|instant| instant.is_before).expect("a jump");
    assert!(
        instants[place].t == impact.t && instants[place + 1] == Instant { t: impact.t, is_before: false }
    );
    let rate = run.output("y'").unwrap();
    assert!((run.value_at(&rate, instants[place]) + v).abs() < 1e-12);
    assert_eq!(run.value_at(&rate, instants[place + 1]), run.value(&rate, impact.t));
    assert!((run.state_at(instants[place])[5] + v).abs() < 1e-12);
    let least =
        run.extrema(&rate).into_iter().find(|extremum| extremum.t == impact.t).expect("a turning point");
    assert!(least.minimum && (least.value + v).abs() < 1e-12, "{least:?}");

    let mut jumps = Jumps::default();
    simulation.observe(&mut jumps).unwrap();
    let [(t, state)] = &jumps.0[..] else { panic!("{:?}", jumps.0) };
    assert!(*t == impact.t && (state[5] + v).abs() < 1e-12, "{state:?}");
}

/// Flat, both ends at once: J = m v/2 each without spin, and the order of the impacts would matter:
/// cos θ = ½ for a uniform bar. Its middle, where a third support stands, shares the blow.
#[test]
fn both_ends_strike_at_once() {
    for form in FORMS {
        let start = || {
            let model = RodOnSupports { m: 1.0, l: 1.0, g: 1.0 };
            Simulation::new(&model).unwrap().form(form).start(Pose::new("y", 0.5).with("theta", 0.0)).unwrap()
        };
        let run = start().release("B", 0.1).unwrap().limit(2.0).run().unwrap();
        let impact = &run.events()[2];
        assert_eq!((impact.kind, &impact.supports[..]), (EventKind::Impact, &["A", "C"][..]));
        for impulse in &impact.impulses {
            assert!((impulse.value - 0.5).abs() < 1e-12, "{impact:?}");
        }
        let Some(Note::ImpactOrder(order)) = &impact.note else { panic!("{impact}") };
        let [(["A", "C"], angle)] = order.pairs[..] else { panic!("{impact}") };
        assert!((angle - FRAC_PI_3).abs() < 1e-12, "{impact}");
        assert!(run.final_state().iter().all(|x| x.abs() < 1e-12));
        let run = start().limit(2.0).run().unwrap();
        let impact = &run.events()[1];
        assert!(impact.impulses.iter().all(|j| (j.value - 1.0 / 3.0).abs() < 1e-12), "{impact:?}");
        // Reactions, impulses and the order of the impacts.
        assert_eq!(run.log().len(), 3, "{:?}", run.log());
    }
}

/// Catalogue 11: struck across at its end by P, the hinge passes on P/4 and the struck end goes off
/// at 7P/2m.
#[test]
fn a_chain_is_struck_at_its_end() {
    let (m, p) = (2.0, 3.0);
    let run = Simulation::new(&StruckChain { m, l: 0.5 }).unwrap();
    let run = run.impulse("A", [0.0, p], 0.5).unwrap().limit(0.6).run().unwrap();
    let [_, struck, _] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((struck.kind, struck.t), (EventKind::Impulse, 0.5));
    let value = |text: &str| run.value(&Output::parse(StruckChain::LAYOUT, text).unwrap(), 0.5);
    assert!((value("vy(A)") - 3.5 * p / m).abs() < 1e-13);
    // The second bar has the momentum of the inner impulse −P/4: its centre is midway between B and
    // C.
    assert!((0.5 * m * (value("vy(B)") + value("vy(C)")) + p / 4.0).abs() < 1e-13);
    assert!(value("vx(A)").abs() < 1e-15);
}

/// A ladder at rest at its wall is struck outwards at its head: the wall does not answer, the floor
/// does.
#[test]
fn a_blow_opens_a_contact() {
    let ladder = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let run = ladder.start(Pose::new("theta", 1.2)).unwrap().impulse("B", [0.05, 0.0], 0.1).unwrap();
    let run = run.limit(0.2).run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|e| (e.kind, e.supports.clone())).collect();
    assert_eq!(
        kinds,
        [
            (EventKind::Start, vec![]),
            (EventKind::Impulse, vec!["A"]),
            (EventKind::Open, vec!["B"]),
            (EventKind::End, vec![])
        ]
    );
    let [a, b] = &run.events()[1].impulses[..] else { panic!() };
    assert!(a.value > 0.0 && b.value == 0.0);
}

/// A condition of the motion takes the wall away: located like a stop.
#[test]
fn a_support_vanishes_on_a_condition() {
    for form in FORMS {
        let ladder = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap().form(form);
        let run = ladder.start(Pose::new("theta", 1.2)).unwrap().release_when("B", "theta = 1.1").unwrap();
        let run = run.until("theta = 0.2").unwrap().run().unwrap();
        let release = &run.events()[1];
        assert_eq!((release.kind, &release.supports[..]), (EventKind::Release, &["B"][..]));
        assert!((release.state[0] - 1.1).abs() < 1e-12);
        assert_eq!(run.segments()[1].closed, ["A"]);
        // Catalogue 1, second phase: N = (1 − ω² s/2)/(1 + 3c²) at once.
        let (s, c) = 1.1f64.sin_cos();
        let omega = release.state[3];
        let floor = (1.0 - 0.5 * omega * omega * s) / (1.0 + 3.0 * c * c);
        assert!((release.reactions[0].value - floor).abs() < 1e-11, "{release:?}");
    }
}

#[test]
fn plans_that_make_no_sense() {
    let ladder = || Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    assert!(matches!(ladder().cut("A", "t = 1").err(), Some(ScheduleError::NoThread { .. })));
    assert!(matches!(ladder().cut("Q", "t = 1").err(), Some(ScheduleError::Name(_))));
    assert!(matches!(ladder().release("A", -1.0).err(), Some(liftoff::SupportError::Time { .. })));
    assert!(matches!(ladder().release_when("A", "t = -1").err(), Some(ScheduleError::Condition(_))));
    assert!(matches!(ladder().release_when("A", "t =").err(), Some(ScheduleError::Condition(_))));
    assert!(matches!(ladder().impulse("Z", [0.0; 2], 1.0).err(), Some(ScheduleError::Name(_))));
    assert!(matches!(ladder().impulse("A", [f64::NAN, 0.0], 1.0).err(), Some(ScheduleError::Impulse { .. })));
    assert!(matches!(ladder().impulse("A", [0.0; 2], f64::NAN).err(), Some(ScheduleError::Time { .. })));
}

/// A bar whose corner is at its end to the last bit bears or not by an infinitesimal.
#[test]
fn a_corner_at_the_end_of_its_bar() {
    let pair = liftoff_fixtures::FallingPair { m: 1.0, l: 1.0, g: 1.0 };
    let refused = Simulation::new(&pair).unwrap().start(Pose::new("phi", core::f64::consts::FRAC_PI_3)).err();
    let Some(StartError::AtEnd { support, end }) = refused else { panic!("{refused:?}") };
    assert_eq!((&support[..], end), ("P, Q", "first"));
}

/// One that its bar reaches over by more than roundoff bears, however long the bar is: here by 1e5
/// spacings of doubles.
#[test]
fn a_corner_near_the_end_of_its_bar() {
    let pair = |phi: f64| {
        let pair = liftoff_fixtures::FallingPair { m: 1.0, l: 1.0, g: 1.0 };
        Simulation::new(&pair).unwrap().start(Pose::new("phi", phi)).is_ok()
    };
    let end = core::f64::consts::FRAC_PI_3;
    assert!(pair(end - 1e-11) && !pair(end + 1e-11));
}

/// An error in mid run keeps the impacts before it.
#[test]
fn errors_keep_the_trajectory() {
    let rod = Simulation::new(&RodOnSupports { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let run = rod.start(Pose::new("y", 0.5).with("theta", 0.0)).unwrap();
    let error =
        run.until("sqrt(1.5 - t) = -1").unwrap().impulse("A", [0.0, 0.1], 1.2).unwrap().run().unwrap_err();
    assert!(matches!(error.cause(), RunCause::Step(_)), "{error}");
    let kinds: Vec<_> = error.trajectory().events().iter().map(|e| e.kind).collect();
    assert_eq!(kinds[..3], [EventKind::Start, EventKind::Impact, EventKind::Impulse], "{kinds:?}");
    assert!(error.trajectory().end_time() > 1.2);
}

/// A level bar strikes with both ends at once, also where one is still within its bound of the
/// floor from the impact before.
#[test]
fn all_contacts_that_are_struck_are_named() {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 };
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-12] {
        let run = Simulation::new(&bar).unwrap().tolerance(tolerance).limit(1.0);
        let pose = Pose::new("phi", 0.0).with("y", 0.3).with("y'", -0.03);
        let run = run.start(pose).unwrap().run().unwrap();
        let impacts = run.events().iter().filter(|event| event.kind == EventKind::Impact);
        for event in impacts {
            // What was closed before passes an impulse on.
            let before = run.segments().into_iter().rfind(|segment| segment.t1 <= event.t);
            let closed = before.map_or_else(Vec::new, |segment| segment.closed);
            let struck = event.impulses.iter().filter(|impulse| impulse.value > 0.0);
            let struck = struck.map(|impulse| impulse.label);
            let struck: Vec<&str> = struck.filter(|label| !closed.contains(label)).collect();
            assert_eq!(struck, event.supports, "{tolerance:e}: {event}");
        }
    }
}

/// A ball that strikes the floor as its run begins.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Thrown {
    m: f64,
    g: f64,
    e: f64,
}

/// Both sides of it are in the arrays, in what observers are shown and in the range of values.
#[test]
fn an_impact_at_the_start_has_a_side_before_it() {
    let ball = Thrown { m: 2.0, g: 10.0, e: 0.5 };
    let start = Pose::new("y", 0.0).with("x", 0.0).with("x'", 3.0).with("y'", -4.0);
    let run = Simulation::new(&ball).unwrap().start(start).unwrap().limit(0.1).run().unwrap();
    let instants = run.instants();
    assert_eq!(instants.iter().map(|instant| instant.is_before).collect::<Vec<_>>()[..2], [true, false]);
    let values = |text: &str| {
        let output = run.output(text).unwrap();
        // But for the rounding of the impulse.
        [instants[0], instants[1]].map(|instant| (1e12 * run.value_at(&output, instant)).round() / 1e12)
    };
    assert_eq!(values("y'"), [-4.0, 2.0]);
    assert_eq!(values("x'"), [3.0, 3.0]);
    assert_eq!(values("T"), [25.0, 13.0]);
    assert_eq!(values("N(P)"), [0.0, 0.0]);
    assert_eq!(run.state_at(instants[0]), [0.0, 0.0, 3.0, -4.0]);
    let [least, most] = run.range(&run.output("y'").unwrap()).unwrap();
    assert!(least == -4.0 && (most - 2.0).abs() < 1e-12, "{least} {most}");
}

/// A door that swings against its stop, S at s from the hinge.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[point(S = OA, at = s)]
#[support(S = wall(0), facing = right)]
#[figure(A = (l * sqrt(3) / 2, l / 2))]
#[coordinate(phi = angle(OA), from = right)]
struct Door {
    m: f64,
    l: f64,
    s: f64,
}

/// Beyond the centre of percussion, 2 l/3, the blow on the hinge is along that on the stop: with P
/// = m l² ω/3s on the stop, P (3s/2l − 1) on the hinge; at that point none.
#[test]
fn a_door_strikes_its_hinge_unless_its_stop_is_at_the_centre_of_percussion() {
    let (m, l) = (10.0, 0.9);
    for s in [0.8, 0.6, 0.3] {
        let door = Door { m, l, s };
        let start = Pose::new("phi", FRAC_PI_2 - 0.5).with("phi'", 2.0);
        let run = Simulation::new(&door).unwrap().start(start).unwrap().limit(0.3).run().unwrap();
        let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
        let [stop, joint] = [impact.impulses[0].value, find(&run.joint_impulses(impact), "fx(O)")];
        let expected = m * l * l * 2.0 / (3.0 * s);
        assert!((stop - expected).abs() < 1e-10 * expected, "{s}: {stop}");
        let blow = expected * (1.5 * s / l - 1.0);
        assert!((joint - blow).abs() < 1e-10 * expected, "{s}: {joint}, not {blow}");
        assert!(find(&run.joint_impulses(impact), "fy(O)").abs() < 1e-10 * expected);
    }
}

fn find(impulses: &[(&'static str, f64)], name: &str) -> f64 {
    impulses.iter().find(|(known, _)| *known == name).unwrap().1
}
