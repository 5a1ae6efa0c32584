//! Springs and loads that act while a condition holds, against closed forms.

use core::f64::consts::PI;
use liftoff::RunCause;
use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A bar that turns freely onto a torsion spring, which acts on one side only.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = horizontal)]
#[torsion(OA, stiffness = k, while("phi < 0"))]
struct Bumper {
    m: f64,
    l: f64,
    k: f64,
}

/// J = 3, ω = 2.
const BUMPER: Bumper = Bumper { m: 1.0, l: 3.0, k: 12.0 };

/// It meets the spring at t = 1, leaves it half a period π/ω later as fast as it came.
#[test]
fn a_spring_that_acts_on_one_side_gives_back_what_it_took() {
    for method in [MethodId::Auto, MethodId::Dop853, MethodId::Taylor] {
        for form in [Form::Reduced, Form::Multipliers] {
            if (method, form) == (MethodId::Taylor, Form::Multipliers) {
                continue;
            }
            let simulation =
                Simulation::new(&BUMPER).unwrap().start(Pose::new("phi", 1.0).with("phi'", -1.0));
            let simulation = simulation.unwrap().form(form).method(method).tolerance(1e-12).limit(5.0);
            let run = simulation.run().unwrap_or_else(|error| panic!("{method:?} {form:?}: {error}"));
            let [start, arm, disarm, end] = run.events() else { panic!("{:?}", run.events()) };
            use EventKind::{Arm, Disarm, End, Start};
            assert_eq!([start, arm, disarm, end].map(|event| event.kind), [Start, Arm, Disarm, End]);
            assert_eq!(arm.supports, ["torsion OA"]);
            assert!(
                (arm.t - 1.0).abs() < 1e-11 && (disarm.t - 1.0 - 0.5 * PI).abs() < 1e-10,
                "{arm} {disarm}"
            );
            assert!((end["phi"] - (5.0 - disarm.t)).abs() < 1e-9, "{end}");
            // Between them a half wave of amplitude ½; the torque is there only then.
            let middle = 1.0 + 0.25 * PI;
            let at = |text: &str, t: f64| run.function(text).unwrap()(t);
            assert!((at("phi", middle) + 0.5).abs() < 1e-10);
            assert!((at("torque(OA)", middle) - 6.0).abs() < 1e-9);
            assert_eq!([at("torque(OA)", 0.5), at("torque(OA)", 4.0)].map(f64::abs), [0.0; 2]);
            assert!((at("T + V", middle) - at("T + V", 0.0)).abs() < 1e-10);
            let acting: Vec<_> = run.segments().into_iter().map(|segment| segment.acting).collect();
            assert_eq!(acting, [vec![], vec![0], vec![]]);
            assert!(run.audit().is_clean(), "{:?}", run.audit());
        }
    }
}

/// A point mass that a motor pulls for a time, and a stretched spring that is cut loose with it.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 1))]
#[force(pull = (f, 0), at = P, while("t < 2"))]
#[ground(O = (0, 0))]
#[spring(s = O -> P, stiffness = k, while("t < 2"))]
struct Pulled {
    m: f64,
    f: f64,
    k: f64,
}

/// With ω = 1: x = f (1 − cos t) from rest at x = 0, y = cos t; from t = 2 on it moves straight.
#[test]
fn timed_loads_end() {
    let pulled = Pulled { m: 1.0, f: 3.0, k: 1.0 };
    let simulation = Simulation::new(&pulled).unwrap().start(Pose::new("x", 0.0).with("y", 1.0)).unwrap();
    let run = simulation.tolerance(1e-12).limit(4.0).run().unwrap();
    let [_, force, end] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((force.kind, force.t), (EventKind::Disarm, 2.0));
    assert_eq!(force.supports, ["spring s", "force pull"]);
    let [x, y] =
        [3.0 * (1.0 - 2.0_f64.cos()) + 2.0 * 3.0 * 2.0_f64.sin(), 2.0_f64.cos() - 2.0 * 2.0_f64.sin()];
    assert!((end["x"] - x).abs() < 1e-10 && (end["y"] - y).abs() < 1e-10, "{end}");
    assert!(run.audit().is_clean(), "{:?}", run.audit());
    // The energy of the spring goes with it, and is not lost in the motion.
    assert!(run.function("D").unwrap()(3.0).abs() < 1e-9);
    let [before, after] = [1.999_999, 2.0].map(|t| run.function("V").unwrap()(t));
    assert!(before > 1.0 && after == 0.0, "{before} {after}");
}

/// A bar on the floor that is lifted for a second.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = floor)]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[figure(A = (0, 0), B = (l, 0))]
#[force(at_a = (0, f), at = A, while("t > 1"))]
#[force(at_b = (0, f), at = B, while("t > 1"))]
pub struct Lifted {
    pub m: f64,
    pub l: f64,
    pub g: f64,
    pub f: f64,
}

/// It rests until the loads come, which open its contacts in the same moment: a = 2f/m − g from
/// there.
#[test]
fn a_load_that_comes_opens_a_contact() {
    let lifted = Lifted { m: 1.0, l: 2.0, g: 10.0, f: 8.0 };
    let simulation = Simulation::new(&lifted).unwrap().start(Pose::new("phi", 0.0).with("x", 0.0)).unwrap();
    let run = simulation.tolerance(1e-12).limit(2.0).run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|event| (event.kind, event.t)).collect();
    use EventKind::{Arm, End, Open, Start};
    assert_eq!(kinds, [(Start, 0.0), (Arm, 1.0), (Open, 1.0), (End, 2.0)], "{:?}", run.events());
    assert!((run.events()[3]["y"] - 3.0).abs() < 1e-10);
    // One that is not enough leaves it on the floor with what it bears then.
    let lifted = Lifted { f: 3.0, ..lifted };
    let simulation = Simulation::new(&lifted).unwrap().start(Pose::new("phi", 0.0).with("x", 0.0)).unwrap();
    let run = simulation.tolerance(1e-12).limit(2.0).run().unwrap();
    let total = run.function("N(A) + N(B)").unwrap();
    assert!((total(0.5) - 10.0).abs() < 1e-10 && (total(1.5) - 4.0).abs() < 1e-10);
}

/// A bar that a load lifts while it does not rise, and that falls without it: the load would hold
/// it in place by coming and going.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 1))]
#[force(hold = (0, f), at = P, while("y' < 0"))]
struct Hovering {
    m: f64,
    g: f64,
    f: f64,
}

#[test]
fn chattering_loads_are_refused() {
    let model = Hovering { m: 1.0, g: 10.0, f: 15.0 };
    let start = Pose::new("x", 0.0).with("y", 1.0).with("y'", -1.0);
    let outcome = Simulation::new(&model).unwrap().start(start).unwrap().limit(1.0).run();
    let error = outcome.expect_err("neither with the load nor without it");
    // It falls by 1 and slows down by f/m − g.
    assert!(matches!(error.cause(), RunCause::Chatter { t, .. } if (t - 0.2).abs() < 1e-10), "{error}");
    assert!(error.to_string().contains("force hold"), "{error}");
    // One that is too weak lets it fall.
    let model = Hovering { f: 5.0, ..model };
    let start = Pose::new("x", 0.0).with("y", 1.0).with("y'", 1.0);
    let run = Simulation::new(&model).unwrap().start(start).unwrap().limit(1.0).run().unwrap();
    let [_, arm, _] = run.events() else { panic!("{:?}", run.events()) };
    assert!((arm.t - 0.1).abs() < 1e-12, "{arm}");
}

/// A relay that always pushes back: it switches ever faster, which is said.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 1))]
#[force(right = (f, 0), at = P, while("x < 0"))]
#[force(left = (-f, 0), at = P, while("x > 0"))]
#[force(drag = (-c * rate(x), 0), at = P)]
struct Relay {
    m: f64,
    f: f64,
    c: f64,
}

#[test]
fn a_relay_swings_from_side_to_side() {
    let relay = Relay { m: 1.0, f: 2.0, c: 0.0 };
    let simulation = Simulation::new(&relay).unwrap().start(Pose::new("x", 1.0).with("y", 0.0)).unwrap();
    let run = simulation.tolerance(1e-12).limit(4.5).run().unwrap();
    // x = 1 − t² to the middle; there and back in 4.
    let changes: Vec<_> =
        run.events().iter().filter(|event| event.kind == EventKind::Arm).map(|e| e.t).collect();
    assert_eq!(changes.len(), 2, "{:?}", run.events());
    assert!((changes[0] - 1.0).abs() < 1e-10 && (changes[1] - 3.0).abs() < 1e-10, "{changes:?}");
    assert!((run.function("x").unwrap()(4.0) - 1.0).abs() < 1e-9);
    // One that loses energy ends its run after ever shorter swings, by name and with what was
    // computed.
    let relay = Relay { c: 1.0, ..relay };
    let simulation = Simulation::new(&relay).unwrap().start(Pose::new("x", 1.0).with("y", 0.0)).unwrap();
    let outcome = simulation.tolerance(1e-9).limit(1e3).run();
    let error = outcome.expect_err("an end before the time");
    assert!(error.trajectory().end_time() < 1e2, "{error}");
}

/// A point on a spring with a damper that is let go.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k, length = l, damping = c, while("t < s"))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Cut {
    m: f64,
    k: f64,
    l: f64,
    c: f64,
    s: f64,
}

/// A spring that does not act has no direction to lose: its ends may meet, be together and start
/// so.
#[test]
fn the_ends_of_a_spring_that_is_off_may_meet() {
    use MethodId::{Auto, Dop853, Gauss, Radau, Taylor};
    for (unit, methods) in [(1.0, &[Auto, Taylor, Dop853, Radau, Gauss][..]), (1e-9, &[Auto]), (1e9, &[Auto])]
    {
        let cut = Cut { m: 1.0, k: 2.0, l: unit, c: 0.3, s: -1.0 };
        for &method in methods {
            for x in [0.0, 1.0] {
                let pose = Pose::new("x", x * unit).with("y", 0.0).with("x'", -unit).with("y'", 0.0);
                let run = Simulation::new(&cut).unwrap().start(pose).unwrap().method(method).limit(3.0).run();
                let run = run.unwrap_or_else(|error| panic!("{unit} {method:?} {x}: {error}"));
                assert!((run.final_state()[0] / unit - (x - 3.0)).abs() < 1e-10, "{method:?} {x}");
                let at = |text: &str| run.function(text).unwrap()(x);
                assert_eq!([at("V"), at("force(OP)")].map(f64::abs), [0.0; 2], "{method:?} {x}");
                assert!(run.audit().is_clean(), "{:?}", run.audit());
            }
        }
    }
}
