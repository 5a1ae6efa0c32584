//! Changes of contact, in closed form and with multipliers, against known answers (m = l = g = 1).

use liftoff::prelude::*;
use liftoff_fixtures::AFrame;
use liftoff_fixtures::Ladder;
use liftoff_fixtures::RodOnSupports;

const FORMS: [Form; 2] = [Form::Reduced, Form::Multipliers];

/// Catalogue 1.
#[test]
fn ladder_leaves_the_wall_and_lands() {
    for form in FORMS {
        let run = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 })
            .unwrap()
            .form(form)
            .tolerance(1e-13)
            .start(Pose::new("theta", 75f64.to_radians()))
            .unwrap()
            .until("theta = 0")
            .unwrap()
            .run()
            .unwrap();
        let [_, open, stop] = run.events() else { panic!("{:?}", run.events()) };
        assert_eq!((open.kind, &open.supports[..]), (EventKind::Open, &["B"][..]));
        println!("{:?}", run.statistics());
        let floor = open.reactions.iter().find(|r| r.label == "A").unwrap().value;
        for (name, computed, reference) in [
            ("t1", open.t, 1.5475985700798873),
            ("theta1", open.state[0], 0.699650781421522),
            ("omega1", -open.state[3], 0.9828152554214186),
            ("floor", floor, 0.25),
            ("fall", stop.t - open.t, 0.5451419400930533),
            ("omega2", -stop.state[3], 1.611635956783063),
        ] {
            println!("{name} {:e}", computed - reference);
            assert!((computed / reference - 1.0).abs() < 1e-11, "{name}: {computed} for {reference}");
        }
    }
}

/// Catalogue 4: a support vanishes, the other one bears mg/4 at once.
#[test]
fn a_support_vanishes() {
    for form in FORMS {
        let simulation = Simulation::new(&RodOnSupports { m: 1.0, l: 1.0, g: 1.0 }).unwrap().form(form);
        let run = simulation.release("B", 0.1).unwrap().release("C", 0.3).unwrap().limit(0.4).run().unwrap();
        let kinds: Vec<_> = run.events().iter().map(|e| (e.kind, e.t)).collect();
        let times = [
            (EventKind::Start, 0.0),
            (EventKind::Release, 0.1),
            (EventKind::Release, 0.3),
            (EventKind::End, 0.4),
        ];
        assert_eq!(kinds, times);
        let bearing = |k: usize| run.events()[k].reactions.iter().map(|r| r.value).collect::<Vec<_>>();
        for (k, expected) in [(0, [1.0 / 3.0; 3]), (1, [0.5, 0.0, 0.5]), (2, [0.25, 0.0, 0.0])] {
            for (computed, expected) in bearing(k).iter().zip(expected) {
                assert!((computed - expected).abs() < 1e-14, "{k}: {:?}", bearing(k));
            }
        }
        assert_eq!(run.log().len(), 1, "{:?}", run.log());
    }
}

/// N/mg = ¼ − (3/2) s S + (9/4) s² per foot vanishes twice within one step, at
/// s = (S ± √(S² − 1))/3; the first of them opens the contact.
#[test]
fn two_roots_in_one_step_are_found() {
    for form in FORMS {
        let l = 1.0;
        for excess in [1e-2, 1e-4, 1e-8] {
            let start = 80f64.to_radians();
            let sum = 1.0 + excess;
            let spin = (3.0 * (sum - start.sin()) / l).sqrt();
            let run = Simulation::new(&AFrame { m: 1.0, l, g: 1.0 }).unwrap().form(form);
            let pose = Pose::new("phi", start).with("phi'", -spin);
            let run = run.start(pose).unwrap().until("h = 0.1").unwrap().run().unwrap();
            let open = &run.events()[1];
            let expected = (sum + (sum * sum - 1.0).sqrt()) / 3.0;
            println!("{excess:e} {} {:e}", open, open.state[0].sin() - expected);
            assert_eq!(open.kind, EventKind::Open);
            // A root of a parabola that dips by 2ε·¼ under zero moves by the reaction's error over
            // √(ε/2).
            assert!((open.state[0].sin() - expected).abs() < 1e-11 / excess.sqrt(), "{open}");
        }
    }
}

/// S = 1 exactly: the reaction touches zero and the feet stay on the floor.
#[test]
fn a_touch_does_not_open() {
    for form in FORMS {
        let start = 80f64.to_radians();
        let spin = (3.0 * (1.0 - start.sin())).sqrt();
        let run = Simulation::new(&AFrame { m: 1.0, l: 1.0, g: 1.0 }).unwrap().form(form);
        let pose = Pose::new("phi", start).with("phi'", -spin);
        let run = run.start(pose).unwrap().until("h = 0.1").unwrap().run().unwrap();
        let kinds: Vec<_> = run.events().iter().map(|e| e.kind).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::Touch, EventKind::Stop]);
        let touch = &run.events()[1];
        // The place of a minimum is known to the square root of what is known of its value.
        assert!((touch.state[0].sin() - 1.0 / 3.0).abs() < 1e-5, "{touch}");
    }
}

/// Catalogue 10.
#[test]
fn a_frame_collapses() {
    for form in FORMS {
        let run = Simulation::new(&AFrame { m: 1.0, l: 1.0, g: 1.0 })
            .unwrap()
            .form(form)
            .tolerance(1e-13)
            .start(Pose::new("phi", 80f64.to_radians()))
            .unwrap()
            .until("h = 0")
            .unwrap()
            .run()
            .unwrap();
        let last = run.events().last().unwrap();
        assert!((last.t / 2.405378338205828 - 1.0).abs() < 1e-11, "{last}");
        assert!((-last.state[3] / 1.7188435818993606 - 1.0).abs() < 1e-11, "{last}");
        let least = run.extrema(&Output::parse(AFrame::LAYOUT, "N(A)").unwrap());
        let s0 = 80f64.to_radians().sin();
        let [minimum] = least[..] else { panic!("{least:?}") };
        assert!(minimum.minimum && (minimum.value - (1.0 - s0 * s0) / 4.0).abs() < 1e-12, "{minimum:?}");
    }
}

/// Nearly flat, the ladder is pushed onto its wall. What bears there is 1e-8 of the weight, less
/// than is known at these tolerances: the contact stays closed as it was decided, and time goes on.
/// φ = φ₀ − ¾ t² to 1e-8, so that it lies flat at √(4 φ₀/3).
#[test]
fn a_reaction_within_its_bound_does_not_stop_the_time() {
    for (tolerance, flat) in [(1e-4, 1e-8), (1e-6, 1e-8), (1e-5, 1e-7)] {
        let ladder = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap().tolerance(tolerance);
        let start = Pose::new("theta", flat).with("x", 0.5 * flat.cos()).with("y", 0.5 * flat.sin());
        let start = start.with("x'", -0.6).with("theta'", 0.0).with("y'", 0.0);
        let run = ladder.start(start).unwrap().until("theta = 0").unwrap().run();
        let run = run.unwrap_or_else(|error| panic!("{tolerance:e}: {error}"));
        let expected = (4.0 / 3.0 * flat).sqrt();
        assert!((run.end_time() / expected - 1.0).abs() < 1e-3, "{tolerance:e}: {}", run.end_time());
    }
}

/// A point in a ring, and between two walls.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = bowl((0, 0), r), stop)]
#[figure(P = (3 * r / 5, -4 * r / 5))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ring {
    m: f64,
    r: f64,
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = wall(0))]
#[figure(P = (1, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Wall {
    m: f64,
    g: f64,
}

/// However fast a point flies, and however high it could, it meets what is a metre away.
#[test]
fn fast_points_meet_what_is_near() {
    for speed in [1.0, 100.0, 3e3, 1e6] {
        for tolerance in [1e-3, 4.5e-5, 1e-7, 1e-12] {
            let ring = Ring { m: 1.0, r: 1.0, g: 9.81 };
            let start = Pose::new("x", 0.24).with("y", 0.16).with("y'", speed);
            let run = Simulation::new(&ring).unwrap().start(start).unwrap().tolerance(tolerance);
            let run = run.limit(1.0 / speed).run().unwrap();
            let close = &run.events()[1];
            let off = close["x"].hypot(close["y"]) - 1.0;
            assert!(close.kind == EventKind::Close && off.abs() < 1e-9, "{speed} {tolerance}: {off:e}");
            let wall = Wall { m: 1.0, g: 9.81 };
            let start = Pose::new("x", 1.0).with("y", 1.0).with("x'", -speed);
            let run = Simulation::new(&wall).unwrap().start(start).unwrap().tolerance(tolerance);
            let run = run.limit(2.0 / speed).run().unwrap();
            let impact = &run.events()[1];
            let off = impact.t * speed - 1.0;
            assert!(impact.kind == EventKind::Impact && off.abs() < 1e-9, "{speed} {tolerance}: {off:e}");
        }
    }
}
