//! Drives that hold while a condition does, against closed forms.

mod chatter;
mod meetings;

use liftoff::StartError;
use liftoff::method::MethodId;
use liftoff::prelude::*;

const METHODS: [MethodId; 4] = [MethodId::Auto, MethodId::Taylor, MethodId::Dop853, MethodId::Radau];

/// A flywheel that a couple speeds up, and a dog clutch to a shaft that turns evenly.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l, inertia = j, centre = l / 2)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[couple(AB = c)]
#[drive(phi = w * t, while("t > t_0"))]
struct Flywheel {
    m: f64,
    l: f64,
    j: f64,
    c: f64,
    w: f64,
    t_0: f64,
}

const FLYWHEEL: Flywheel = Flywheel { m: 1.0, l: 0.5, j: 2.0, c: 3.0, w: 4.0, t_0: 1.0 };

/// φ = φ₀ + c t²/2j meets w t at t* > 1, overtaken or overtaking, the rate c t*/j jumps to w, and
/// the shaft bears −c from then on.
#[test]
fn a_clutch_takes_hold_where_the_shaft_comes_by() {
    let Flywheel { j, c, w, .. } = FLYWHEEL;
    for start in [2.0, 3.3] {
        // (c/2j) t² − w t + φ₀ = 0
        let a = c / (2.0 * j);
        let root = (w * w - 4.0 * a * start).sqrt();
        let meetings = [(w - root) / (2.0 * a), (w + root) / (2.0 * a)];
        let armed = FLYWHEEL.t_0;
        let late = if meetings[0] > armed { meetings[0] } else { meetings[1] };
        let rate = c * late / j;
        for method in METHODS {
            let simulation = Simulation::new(&FLYWHEEL).unwrap().start(Pose::new("phi", start)).unwrap();
            let run = simulation.method(method).tolerance(1e-12).limit(6.0).run();
            let run = run.unwrap_or_else(|error| panic!("{method:?}: {error}"));
            let [_, arm, impact, end] = run.events() else { panic!("{method:?} {:?}", run.events()) };
            assert_eq!((arm.kind, arm.t, &arm.supports[..]), (EventKind::Arm, armed, &["drive phi"][..]));
            assert_eq!((impact.kind, &impact.supports[..]), (EventKind::Impact, &["drive phi"][..]));
            assert!((impact.t - late).abs() < 1e-10, "{method:?} {impact}");
            assert!((impact.impulses[0].value - j * (w - rate)).abs() < 1e-10, "{:?}", impact.impulses);
            assert!((impact["phi'"] - w).abs() < 1e-11 && (end["phi"] - 6.0 * w).abs() < 1e-10, "{end}");
            let at = |text: &str, t: f64| run.function(text).unwrap()(t);
            assert!((at("drive(phi)", 5.9) + c).abs() < 1e-10, "{}", at("drive(phi)", 5.9));
            assert_eq!(at("drive(phi)", 0.5).abs(), 0.0);
            // The work of the impact is that of the shaft, j (w − u) w, less ½ j (w − u)².
            let energy = at("T", late + 1e-9) - at("T", late - 1e-9);
            assert!((energy - 0.5 * j * (w * w - rate * rate)).abs() < 1e-6);
            let lost = 0.5 * j * (w - rate) * (w - rate);
            assert!((at("D", 5.9) - lost).abs() < 1e-9, "{method:?} {} {lost}", at("D", 5.9));
            assert!(run.audit().is_clean(), "{method:?} {:?}", run.audit());
        }
    }
}

/// A block on a line, and a gripper that moves towards it.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[force(P = (-k * vx(P), 0))]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[drive(x = u * (t + s) - b * cos(w * (t + s)), while("t + s < t_1"))]
struct Gripper {
    m: f64,
    k: f64,
    u: f64,
    b: f64,
    w: f64,
    t_1: f64,
    s: f64,
}

const GRIPPER: Gripper = Gripper { m: 2.0, k: 0.0, u: 1.0, b: 0.1, w: 3.0, t_1: 2.5, s: 0.0 };

fn reference(t: f64) -> [f64; 3] {
    let Gripper { u, b, w, .. } = GRIPPER;
    let (sin, cos) = (w * t).sin_cos();
    [u * t - b * cos, u + b * w * sin, b * w * w * cos]
}

/// It meets the block from the left or from the right, carries it, and lets it go with its own
/// velocity.
#[test]
fn a_gripper_carries_what_it_meets_until_it_lets_go() {
    for (x, v) in [(1.0, -0.5), (1.3, 0.2), (-1.0, 2.5)] {
        let far = |t: f64| x + v * t - reference(t)[0];
        let [mut low, mut high] = [0.0, 2.0];
        assert!(far(low) * far(high) < 0.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            *(if far(middle) * far(0.0) > 0.0 { &mut low } else { &mut high }) = middle;
        }
        for method in METHODS {
            for form in [Form::Reduced, Form::Multipliers] {
                if method == MethodId::Taylor && form == Form::Multipliers {
                    continue;
                }
                let simulation = Simulation::new(&GRIPPER).unwrap().start(Pose::new("x", x).with("x'", v));
                let simulation = simulation.unwrap().form(form).method(method).tolerance(1e-12).limit(4.0);
                let run = simulation.run().unwrap_or_else(|error| panic!("{method:?} {form:?}: {error}"));
                let [_, impact, disarm, end] = run.events() else { panic!("{method:?} {:?}", run.events()) };
                assert_eq!([impact.kind, disarm.kind], [EventKind::Impact, EventKind::Disarm]);
                assert!((impact.t - low).abs() < 1e-10, "{method:?} {impact} {low}");
                assert!((impact["x'"] - reference(low)[1]).abs() < 1e-10);
                assert!((disarm.t - 2.5).abs() < 1e-14 && (disarm["x'"] - reference(2.5)[1]).abs() < 1e-10);
                assert!((end["x"] - reference(2.5)[0] - 1.5 * reference(2.5)[1]).abs() < 1e-10, "{end}");
                let force = run.function("drive(x)").unwrap();
                assert!((force(2.2) - 2.0 * reference(2.2)[2]).abs() < 1e-9, "{method:?} {}", force(2.2));
                assert_eq!([force(0.1), force(3.0)].map(f64::abs), [0.0; 2]);
                assert!(run.audit().is_clean(), "{method:?} {form:?} {:?}", run.audit());
            }
        }
    }
}

/// A start beside the motion that the gripper has is refused, one with it is carried from the
/// start.
#[test]
fn a_drive_that_is_met_at_the_start_holds_from_there() {
    let [x, v, _] = reference(0.0);
    let start = |v: f64| Simulation::new(&GRIPPER).unwrap().start(Pose::new("x", x).with("x'", v));
    let refused = start(v + 0.5).map(|_| ()).unwrap_err();
    assert!(
        matches!(&refused, StartError::BreaksJoint { joint, speed } if joint == "drive x" && (speed - 0.5).abs() < 1e-12),
        "{refused}"
    );
    let run = start(v).unwrap().tolerance(1e-12).limit(2.0).run().unwrap();
    assert_eq!(run.events().len(), 2, "{:?}", run.events());
    assert!((run.events()[1]["x"] - reference(2.0)[0]).abs() < 1e-11);
    // A rate that is not given is that of the gripper.
    let left_open =
        Simulation::new(&GRIPPER).unwrap().start(Pose::new("x", x)).unwrap().limit(1.0).run().unwrap();
    assert!((left_open.events()[0]["x'"] - v).abs() < 1e-12);
}

/// Armed where what it drives just passes it takes hold at once: with an impact, or without one at
/// its own rate.
#[test]
fn a_clutch_that_is_armed_in_place_takes_hold_at_once() {
    let Flywheel { j, c, w, t_0, .. } = FLYWHEEL;
    for (slower, expected) in [(0.5, 4), (-0.5, 4), (0.0, 3)] {
        let rate = w - slower - c * t_0 / j;
        let start = Pose::new("phi", w * t_0 - rate * t_0 - c * t_0 * t_0 / (2.0 * j)).with("phi'", rate);
        for method in METHODS {
            let run = Simulation::new(&FLYWHEEL).unwrap().start(start.clone()).unwrap();
            let run = run.method(method).tolerance(1e-12).limit(3.0).run().unwrap();
            assert_eq!(run.events().len(), expected, "{method:?} {:?}", run.events());
            assert!(
                run.events().iter().skip(1).take(expected - 2).all(|event| (event.t - t_0).abs() < 1e-14)
            );
            let at = |text: &str, t: f64| run.function(text).unwrap()(t);
            assert!((at("phi", 3.0) - 3.0 * w).abs() < 1e-10 && (at("drive(phi)", 2.0) + c).abs() < 1e-10);
            assert!(run.audit().is_clean(), "{method:?} {:?}", run.audit());
        }
    }
}

/// A load on a rope that is let out.
#[derive(BarSystem, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[drive(distance(O, P) = l + c * t, while("sin(w * t + a) > 0"))]
struct Crane {
    m: f64,
    l: f64,
    c: f64,
    w: f64,
    a: f64,
    g: f64,
}

/// The same on a rod that it never leaves.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[drive(distance(O, P) = l + c * t)]
struct Rod {
    m: f64,
    l: f64,
    c: f64,
    g: f64,
}

/// While it holds it is the drive that holds always; what it lets go flies.
#[test]
fn a_crane_that_lets_go_throws_its_load() {
    let (m, l, c, g) = (2.0, 1.5, 0.3, 9.81);
    let gone = 0.9;
    let crane = Crane { m, l, c, w: 1.0, a: core::f64::consts::PI - gone, g };
    let start = Pose::new("x", l).with("y", 0.0).with("x'", c).with("y'", 0.0);
    for method in [MethodId::Auto, MethodId::Taylor, MethodId::Dop853, MethodId::Gauss] {
        for form in [Form::Reduced, Form::Multipliers] {
            if method == MethodId::Taylor && form == Form::Multipliers {
                continue;
            }
            let run = Simulation::new(&crane).unwrap().start(start.clone()).unwrap();
            let run = run.method(method).form(form).tolerance(1e-13).limit(1.4).run();
            let run = run.unwrap_or_else(|error| panic!("{method:?} {form:?}: {error}"));
            let rod = Simulation::new(&Rod { m, l, c, g }).unwrap().start(start.clone()).unwrap();
            let rod = rod.method(method).form(form).tolerance(1e-13).limit(gone).run().unwrap();
            for text in ["x", "y", "x'", "y'", "drive(distance(O, P))"] {
                let [own, known] = [&run, &rod].map(|run| run.function(text).unwrap()(0.8));
                assert!(
                    (own - known).abs() < 1e-10 * known.abs().max(1.0),
                    "{method:?} {form:?} {text}: {own} {known}"
                );
            }
            let at = |text: &str, t: f64| run.function(text).unwrap()(t);
            assert!(
                at("gap(drive distance(O, P))", 0.8).abs() < 1e-10
                    && at("gap(drive distance(O, P))", 1.3) > 1e-3
            );
            assert!(at("N(drive distance(O, P)) - drive(distance(O, P))", 0.5).abs() < 1e-10);
            let [_, disarm, end] = run.events() else { panic!("{:?}", run.events()) };
            assert!(disarm.kind == EventKind::Disarm && (disarm.t - gone).abs() < 1e-11, "{disarm}");
            assert_eq!(disarm.supports, ["drive distance(O, P)"]);
            let late = 1.4 - disarm.t;
            assert!((end["x"] - disarm["x"] - disarm["x'"] * late).abs() < 1e-10, "{end}");
            let fallen = disarm["y"] + disarm["y'"] * late - 0.5 * g * late * late;
            assert!((end["y"] - fallen).abs() < 1e-10, "{end}");
            assert!(run.audit().is_clean(), "{method:?} {form:?} {:?}", run.audit());
        }
    }
}

/// A load that is caught and let go over and over, from wherever it starts; the impulse, m (c − ṙ),
/// is the rope's.
#[test]
fn loads_that_are_caught_and_let_go_keep_their_balance_of_energy() {
    let mut seed = 7_u64;
    let mut random = |from: f64, to: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut caught = 0;
    for _ in 0..60 {
        let crane =
            Crane { m: 2.0, l: 1.5, c: random(-0.3, 0.3), w: random(1.0, 6.0), a: random(0.0, 6.0), g: 1.0 };
        let start = Pose::new("x", random(-2.0, 2.0)).with("y", random(-2.0, 2.0));
        let start = start.with("x'", random(-2.0, 2.0)).with("y'", random(-2.0, 2.0));
        let run = Simulation::new(&crane).unwrap().start(start.clone()).unwrap().limit(3.0).run();
        let run = run.unwrap_or_else(|error| panic!("{crane:?} {start:?}: {error}"));
        assert!(run.audit().is_clean(), "{crane:?} {start:?}: {:?}", run.audit());
        let events = run.events();
        for (flight, impact) in events.iter().zip(&events[1..]).filter(|(_, it)| it.kind == EventKind::Impact)
        {
            let late = impact.t - flight.t;
            let [vx, vy] = [flight["x'"], flight["y'"] - crane.g * late];
            let [x, y] = [flight["x"] + vx * late, flight["y"] + 0.5 * (flight["y'"] + vy) * late];
            let known = crane.m * (crane.c - (x * vx + y * vy) / x.hypot(y));
            let impulse = impact.impulses[0].value;
            assert!((impulse - known).abs() < 1e-8, "{crane:?} {impact}: {impulse} {known}");
            caught += 1;
        }
        let off = run.function("sqrt(x * x + y * y)").unwrap();
        for segment in run.segments() {
            let t = 0.5 * (segment.t0 + segment.t1);
            let closed = !segment.set.is_empty();
            assert!(!closed || (off(t) - crane.l - crane.c * t).abs() < 1e-8, "{crane:?} {t}");
            assert!(!closed || (crane.w * t + crane.a).sin() > 0.0, "{crane:?} {t}");
        }
    }
    assert!(caught > 20, "{caught}");
}

/// A run from between the events of another goes on as that does.
#[test]
fn a_split_run_of_a_gripper_is_the_whole_run() {
    let drag = Gripper { k: 0.7, ..GRIPPER };
    let new = |s: f64| Simulation::new(&Gripper { s, ..drag }).unwrap().tolerance(1e-12);
    let whole = new(0.0).start(Pose::new("x", 1.0).with("x'", -0.5)).unwrap().limit(4.0).run().unwrap();
    let met = whole.events()[1].t;
    for t in [0.3, met, 0.5 * (met + 2.5), 3.0] {
        let state = if t == met { whole.events()[1].state.clone() } else { whole.state(t) };
        // Of x and y of the block.
        let pose = Pose::new("x", state[0]).with("x'", state[2]);
        let part = new(t).start(pose).unwrap().limit(4.0 - t).run().unwrap();
        let [own, known] = [&part, &whole].map(|run| run.final_state());
        assert!(
            (own[0] - known[0]).abs() < 1e-10 && (own[2] - known[2]).abs() < 1e-10,
            "{t}: {own:?} {known:?}"
        );
        let later = whole.events().iter().filter(|event| event.t > t).count();
        assert_eq!(part.events().len(), 1 + later, "{t}: {:?}", part.events());
    }
}
