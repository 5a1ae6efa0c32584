//! Contacts with friction that share a load which statics leaves open.

use core::f64::consts::PI;

use liftoff::LoggedDecision;
use liftoff::method::{Gauss, Method, Radau, Taylor, Tsit5};
use liftoff::prelude::*;

use crate::friction::run;

/// A plank on two feet.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = slope(alpha), friction = mu)]
#[support(B = slope(alpha), friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l * cos(alpha), l * sin(alpha)))]
struct Plank {
    m: f64,
    l: f64,
    g: f64,
    alpha: f64,
    mu: f64,
}

/// It slides up, stops, and stays or slides back as a block does, whatever its feet bear.
#[test]
fn a_plank_on_two_feet_slides_as_a_block() {
    for (alpha, mu) in [(0.3_f64, 0.2), (0.3, 0.5)] {
        let plank = Plank { m: 1.0, l: 1.0, g: 9.81, alpha, mu };
        let v = 1.5;
        let pose = Pose::new("x", 0.0).with("x'", v * alpha.cos()).with("theta", alpha);
        let record = run(Simulation::new(&plank).unwrap().start(pose).unwrap().limit(1.5).tolerance(1e-10));
        let event = &record.events()[1];
        let deceleration = 9.81 * (alpha.sin() + mu * alpha.cos());
        assert!((event.t - v / deceleration).abs() < 1e-9, "{event}");
        let kind = if alpha.tan() > mu { EventKind::Reverse } else { EventKind::Stick };
        assert_eq!((event.kind, event.supports.len()), (kind, 2), "{:?}", record.events());
    }
}

/// A plank on two feet, heavier at one end, that is pulled at.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[mass(A, m2)]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[force(A = (f * t, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct Pulled {
    m: f64,
    m2: f64,
    l: f64,
    g: f64,
    mu: f64,
    f: f64,
}

/// However its feet share the load, it slips as a whole, at F = μ (m + m₂) g.
#[test]
fn a_plank_that_is_pulled_slips_as_a_whole() {
    let plank = Pulled { m: 1.0, m2: 3.0, l: 1.0, g: 10.0, mu: 0.3, f: 2.0 };
    let record = run(Simulation::new(&plank).unwrap().limit(8.0).tolerance(1e-10));
    let slip = &record.events()[1];
    assert_eq!((slip.kind, slip.supports.len()), (EventKind::Slip, 2), "{:?}", record.events());
    assert!((slip.t - 6.0).abs() < 1e-9, "{slip}");
}

/// A ladder whose feet on the floor and at the wall both stick, with a load at its top that grows.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), friction = mu)]
#[force(B = (0, -f * t))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (-0.5, 0), B = (0, 0.866))]
struct Leaning {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
    f: f64,
}

/// It slips at both ends at F = (k − ½) W / (1 − k), k = μ (tan θ + μ) / (1 + μ²): where the
/// equations of statics leave the reactions open, they are limited by friction alone.
#[test]
fn a_leaning_ladder_slips_at_the_limit_load() {
    let theta = 60.0_f64.to_radians();
    for mu in [0.35_f64, 0.4, 0.45] {
        let ladder = Leaning { m: 2.0, l: 1.0, g: 10.0, mu, f: 7.0 };
        let pose = Pose::new("theta", theta).with("y", 0.0).with("x", -theta.cos());
        let record = run(Simulation::new(&ladder).unwrap().start(pose).unwrap().limit(10.0).tolerance(1e-10));
        let k = mu * (theta.tan() + mu) / (1.0 + mu * mu);
        let load = (k - 0.5) * 20.0 / (1.0 - k);
        let slip = &record.events()[1];
        assert_eq!((slip.kind, slip.supports.len()), (EventKind::Slip, 2), "{:?}", record.events());
        assert!((slip.t * 7.0 - load).abs() < 1e-9, "{slip}: {load}");
    }
}

/// A plank on three feet, of which two determine the motion of the third.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = c)]
#[ground(O = (0, 0))]
#[spring(OC, stiffness = k)]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[support(C = floor, friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0.3 * l, 0), B = (1.3 * l, 0))]
struct Tripod {
    m: f64,
    l: f64,
    c: f64,
    g: f64,
    k: f64,
    mu: f64,
}

/// All feet turn back at once, those too whose reactions others bear; none goes on with the sense
/// that it had.
#[test]
fn all_feet_of_a_plank_slide_back_together() {
    let plank = Tripod { m: 0.7, l: 1.0, c: 0.6, g: 9.81, k: 50.0, mu: 0.15 };
    let pose = Pose::new("x", 1.2).with("x'", -3.0).with("y", 0.0).with("theta", 0.0);
    let record = run(Simulation::new(&plank).unwrap().start(pose).unwrap().limit(1.0).tolerance(1e-10));
    let (omega, shift) = ((50.0_f64 / 0.7).sqrt(), 0.15 * 0.7 * 9.81 / 50.0);
    // The point C swings about the shift of its equilibrium that friction makes.
    let phase = 3.0_f64.atan2(omega * (1.8 - shift));
    let event = &record.events()[1];
    assert_eq!((event.kind, &event.supports[..]), (EventKind::Reverse, &["A", "B", "C"][..]), "{event}");
    let expected = (PI - phase) / omega;
    assert!((event.t - expected).abs() < 1e-9, "{event} {expected}");
    let slip = record.function("v(C)").unwrap();
    for segment in record.segments() {
        let middle = 0.5 * (segment.t0 + segment.t1);
        let senses = [0, 1, 2].map(|contact| segment.set.sense(contact) as f64);
        assert!(senses.iter().all(|sense| *sense == slip(middle).signum()), "{senses:?} {}", slip(middle));
    }
}

/// A plank on three feet, the middle one rougher than the others.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[support(C = floor, friction = nu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct Uneven {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
    nu: f64,
}

/// What its middle foot bears decides how fast it is slowed down, and statics leaves that open: it
/// is told.
#[test]
fn a_motion_that_depends_on_how_the_load_is_shared_is_reported() {
    let decided = |nu: f64| {
        let plank = Uneven { m: 1.0, l: 1.0, g: 10.0, mu: 0.2, nu };
        let pose = Pose::new("x", 0.0).with("y", 0.0).with("theta", 0.0).with("x'", 1.0);
        let record = run(Simulation::new(&plank).unwrap().start(pose).unwrap().limit(0.1).tolerance(1e-10));
        record.log().iter().any(|entry| entry.decision == LoggedDecision::MotionNotDetermined)
    };
    assert!(decided(0.5) && !decided(0.2));
}

/// A block on a rough, driven bar slides to the pivot, where a stop holds it: friction and stop act
/// along one line.
#[derive(BarSystem)]
#[gravity(9.81)]
#[bar(OB, mass = 1, length = 1)]
#[pin(O = (0, 0))]
#[particle(P, mass = 0.5)]
#[slider(P = bar(OB), friction = 0.2, stops)]
#[drive(angle(OB) = 0.6 - w * t)]
#[figure(B = (0.8, 0.6), P = (0.24, 0.18))]
#[coordinate(x = x(P))]
struct BlockAtPivot {
    w: f64,
}

/// All forces pass through the pivot, and their arms there are rounding: what friction and stop
/// share of m g sin θ is within the cone of friction, |R| ≤ μ m g cos θ.
#[test]
fn a_stop_at_a_pivot_takes_what_friction_leaves() {
    fn check(w: f64, method: impl Method + 'static) {
        let simulation = Simulation::new(&BlockAtPivot { w }).unwrap().method(method);
        let run = simulation.start(Pose::new("x", 0.3)).unwrap().limit(0.6).run().unwrap();
        assert_eq!(run.events().len(), 4, "{w}: {:?}", run.events());
        for t in [0.5, 0.6] {
            let value = |output: &str| run.value(&run.output(output).unwrap(), t);
            let (sin, cos) = (0.6 - w * t).sin_cos();
            let [weight, normal] = [0.5 * 9.81 * sin, 0.5 * 9.81 * cos];
            let [stop, friction] = [value("N(P_O)"), value("R(P)")];
            assert!((stop + friction - weight).abs() < 1e-9 * weight, "{w} {t}: {stop} {friction}");
            assert!(friction.abs() <= 0.2 * normal * (1.0 + 1e-9), "{w} {t}: {stop} {friction}");
            assert!(value("x").abs() < 1e-9);
        }
    }
    for w in [0.0, 0.1, 0.3, -0.1] {
        check(w, Tsit5);
        check(w, Radau::default());
        check(w, Gauss);
        check(w, Taylor);
    }
}

/// The same with a spring, on a bar that a motor swings to and fro.
#[derive(BarSystem)]
#[gravity(9.81)]
#[bar(OB, mass = 0.5, length = 1)]
#[pin(O = (0, 0))]
#[particle(P, mass = 2)]
#[slider(P = bar(OB), friction = 0.5, stops)]
#[drive(angle(OB) = -0.9187265414217762 + 0.458 * sin(4.77 * t))]
#[spring(DP, stiffness = 21.98, length = 0.964)]
#[ground(D = (0.3, 0.8))]
#[figure(B = (0.6068328308492823, -0.7948294882573534), P = (0.4760477721378062, -0.6235272514586844))]
#[coordinate(x = x(P))]
struct BlockOnRocker;

/// At the stop the bar's pressure changes its side, and friction is within its cone there too.
#[test]
fn friction_is_within_its_cone_where_the_pressure_vanishes() {
    fn check(method: impl Method + 'static) {
        let simulation = Simulation::new(&BlockOnRocker).unwrap().method(method);
        let run = simulation.start(Pose::new("x", 0.4760477721378062)).unwrap().limit(2.0).run().unwrap();
        let sides = run.events().iter().filter(|event| event.kind == EventKind::Side);
        let at_sides = sides.map(|event| event.t).collect::<Vec<_>>();
        assert!(at_sides.len() >= 4, "{:?}", run.events());
        for t in at_sides.into_iter().chain((1..200).map(|k| 0.01 * f64::from(k))) {
            let [force, normal] = ["R(P)", "N(P)"].map(|output| run.value(&run.output(output).unwrap(), t));
            assert!(force.abs() <= 0.5 * normal.abs() + 1e-9, "{t}: {force} {normal}");
        }
    }
    check(Tsit5);
    check(Radau::default());
    check(Gauss);
    check(Taylor);
}
