//! Clutches that take hold of what is slow or fast, smoothly, in impacts of others, at poles and at
//! reversals.

use liftoff::prelude::*;

use super::METHODS;

/// A ball thrown up along a line, and a latch at a height that does not move.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = vertical(0))]
#[figure(P = (0, h / 2))]
#[coordinate(y = y(P))]
#[drive(y = h, while("s * (v - y') > 0"))]
struct Latch {
    m: f64,
    h: f64,
    v: f64,
    s: f64,
    g: f64,
}

/// It catches what is slow, on its way down; or what is fast, which is then too slow for it and
/// falls from there.
#[test]
fn a_latch_of_what_is_slow_or_fast() {
    use EventKind::{Arm, Disarm, End, Impact, Start};
    let (m, h, g) = (2.0, 2.0, 1.0);
    let rate = 12.0_f64.sqrt();
    for (s, kinds) in [(1.0, vec![Start, Arm, Impact, End]), (-1.0, vec![Start, Impact, Disarm, End])] {
        let latch = Latch { m, h, v: 1.0, s, g };
        for method in METHODS {
            let run = Simulation::new(&latch).unwrap().start(Pose::new("y", 0.0).with("y'", 4.0)).unwrap();
            let run = run.method(method).tolerance(1e-12).limit(9.0).run().unwrap();
            assert_eq!(run.events().iter().map(|event| event.kind).collect::<Vec<_>>(), kinds, "{method:?}");
            let impact = run.events().iter().find(|event| event.kind == Impact).unwrap();
            assert!((impact.t - (4.0 + s * rate)).abs() < 1e-10, "{method:?} {impact}");
            assert!((impact.impulses[0].value - s * m * rate).abs() < 1e-10, "{:?}", impact.impulses);
            let (force, end) = (run.function("drive(y)").unwrap()(8.9), run.events().last().unwrap()["y"]);
            let fallen = 0.5 * g * (9.0 - impact.t).powi(2);
            let [bears, height] = if s > 0.0 { [m * g, h] } else { [0.0, h - fallen] };
            assert!((force - bears).abs() < 1e-10 && (end - height).abs() < 1e-9, "{method:?} {force} {end}");
            assert!(run.audit().is_clean(), "{method:?} {:?}", run.audit());
        }
    }
}

/// A block on a floor, and a gripper that comes down to it smoothly.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[drive(y = h * (t - 1).powi(2), while("t < 2"))]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Pick {
    m: f64,
    h: f64,
    g: f64,
}

/// It takes hold without an impulse, and lifts the block off the floor.
#[test]
fn a_gripper_comes_down_smoothly_on_a_block() {
    for method in METHODS {
        for tolerance in [1e-6, 1e-9, 1e-13] {
            let pick = Pick { m: 1.0, h: 1.0, g: 9.81 };
            let start = Pose::new("x", 0.0).with("x'", 1.0).with("y", 0.0);
            let run = Simulation::new(&pick).unwrap().start(start).unwrap();
            let run = run.method(method).tolerance(tolerance).limit(2.5).run().unwrap();
            let [_, impact, open, disarm, end] = run.events() else {
                panic!("{method:?} {:?}", run.events())
            };
            let kinds = [impact.kind, open.kind, disarm.kind];
            assert_eq!(kinds, [EventKind::Impact, EventKind::Open, EventKind::Disarm]);
            assert!((impact.t - 1.0).abs() < 1e-6 && impact.impulses[0].value == 0.0, "{method:?} {impact}");
            // Thrown up from y = h at 2 h.
            let known = 1.0 + 2.0 * 0.5 - 0.5 * 9.81 * 0.25;
            assert!((end["y"] - known).abs() < 1e-6, "{method:?} {tolerance} {end}");
            assert!(run.audit().is_clean(), "{method:?} {:?}", run.audit());
        }
    }
}

/// A point that a force pushes while a condition holds that changes through a pole.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[force(P = (a, 0), while("1 / x < 1 / a"))]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Pole {
    m: f64,
    a: f64,
}

/// 1/x < 1 holds for x < 0 and x > 1: it begins at −1 with the rate 1, v² = 1 + 2 (x + 1) up to 0,
/// even from there to 1, and on.
#[test]
fn switches_act_at_poles_too() {
    for method in METHODS {
        let start = Pose::new("x", -1.0).with("x'", 1.0).with("y", 1.0);
        let run = Simulation::new(&Pole { m: 1.0, a: 1.0 }).unwrap().start(start).unwrap();
        let run = run.method(method).tolerance(1e-12).limit(3.0).run().unwrap();
        let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::Disarm, EventKind::Arm, EventKind::End]);
        let v = 3.0_f64.sqrt();
        let (gone, back) = (v - 1.0, v - 1.0 + 1.0 / v);
        let late = 3.0 - back;
        let known = 1.0 + v * late + 0.5 * late * late;
        let [_, disarm, arm, end] = run.events() else { unreachable!() };
        assert!((disarm.t - gone).abs() < 1e-10 && (arm.t - back).abs() < 1e-10, "{method:?} {arm}");
        assert!((end["x"] - known).abs() < 1e-9, "{method:?} {end} {known}");
    }
}

/// A bar whose one end is held by two clutches, one of which moves, and whose other end strikes a
/// rough floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[drive(y(A) = 0 * l, while("t < 5"))]
#[drive(x(A) = u * t, while("t < 5"))]
#[support(B = floor, friction = mu)]
#[figure(A = (0, 0), B = (l, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Dragged {
    m: f64,
    l: f64,
    u: f64,
    mu: f64,
    g: f64,
}

/// Level, the floor's impulse is m l ω/3 and slides along, the clutches bear m l ω/6 and μ m l ω/3;
/// what friction takes is told.
#[test]
fn clutches_tell_their_impulses_in_impacts_of_others() {
    let bar = Dragged { m: 1.5, l: 1.2, u: 2.0, mu: 0.3, g: 9.81 };
    let start = Pose::new("phi", 0.3).with("phi'", 0.0).with("x", 0.0).with("y", 0.0).with("x'", 2.0);
    let run = Simulation::new(&bar).unwrap().start(start).unwrap().tolerance(1e-12).limit(0.5).run().unwrap();
    let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let fall = bar.g * bar.l * 0.3_f64.sin() / 2.0;
    let omega = (2.0 * bar.m * fall / (bar.m * bar.l * bar.l / 3.0)).sqrt();
    let normal = bar.m * bar.l * omega / 3.0;
    let of = |label: &str| impact.impulses.iter().find(|it| it.label == label).unwrap().value;
    assert!((of("B") - normal).abs() < 1e-9, "{:?}", impact.impulses);
    assert!((of("drive y(A)") - normal / 2.0).abs() < 1e-9, "{:?}", impact.impulses);
    assert!((of("drive x(A)") - bar.mu * normal).abs() < 1e-9, "{:?}", impact.impulses);
    let kinetic = 0.5 * (bar.m * bar.l * bar.l / 3.0) * omega * omega;
    let lost = run.function("D").unwrap()(impact.t + 1e-9) - run.function("D").unwrap()(impact.t - 1e-9);
    assert!((lost - kinetic - bar.mu * normal * bar.u).abs() < 1e-6, "{lost} {kinetic}");
}

/// A clutch that slips at an overload would be gone for good, or come and go without end.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[drive(x = v * t, while("drive(x) < 3"))]
struct Overload {
    m: f64,
    v: f64,
}

#[test]
fn conditions_do_not_read_what_is_decided_after_them() {
    let error = Simulation::new(&Overload { m: 1.0, v: 1.0 }).err().unwrap();
    assert!(error.to_string().starts_with("the condition `while` of drive x reads a reaction"), "{error}");
}

/// A block that a spring pulls to and fro on a rough floor, pushed by a force while it slides back.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (-l, 0))]
#[spring(OP, stiffness = k, length = l)]
#[support(P = floor, friction = mu)]
#[force(P = (f, 0), while("v(P) < 0"))]
#[figure(P = (l, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Pushed {
    m: f64,
    l: f64,
    k: f64,
    mu: f64,
    f: f64,
    g: f64,
}

/// Each reversal switches the force.
#[test]
fn reversals_switch_what_slips_tell() {
    let mut seen = 0;
    for k in 0..40 {
        let pushed = Pushed { m: 1.3, l: 1.0, k: 30.0, mu: 0.05, f: -0.4, g: 9.81 };
        for method in METHODS {
            let start = Pose::new("x", 0.6 + 0.01 * f64::from(k)).with("x'", 0.1).with("y", 0.0);
            let run = Simulation::new(&pushed).unwrap().start(start).unwrap().tolerance(1e-11);
            let run = run.method(method).limit(3.0).run().unwrap();
            for pair in run.events().windows(2).filter(|pair| pair[0].kind == EventKind::Reverse) {
                assert!(
                    matches!(pair[1].kind, EventKind::Arm | EventKind::Disarm),
                    "{k} {method:?} {pair:?}"
                );
                assert!((pair[0].t - pair[1].t).abs() < 1e-12, "{k} {method:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 600, "{seen}");
}
