//! Bodies that nothing couples are struck as if each were alone, mirror images too.

use liftoff::prelude::*;

/// A rod falls obliquely on a floor with friction.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[bar(AB, mass = m, length = m)]
#[support(A = floor, friction = 0.1, restitution = e)]
#[figure(A = (0, 0), B = (0.6, 0.8))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct One {
    e: f64,
    /// Mass and length.
    m: f64,
}

/// Two of them side by side; where the second is, is told from the first.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[bar(AB, mass = m, length = m)]
#[bar(CD, mass = m, length = m)]
#[support(A = floor, friction = 0.1, restitution = e)]
#[support(C = floor, friction = 0.1, restitution = e)]
#[figure(A = (0, 0), B = (0.6, 0.8), C = (10, 0), D = (10.6, 0.8))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta2 = angle(CD), from = right)]
#[coordinate(x2 = x(C))]
#[coordinate(y2 = y(C))]
struct Two {
    e: f64,
    /// Mass and length.
    m: f64,
}

/// Two that are mirror images.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[bar(AB, mass = m, length = m)]
#[bar(CD, mass = m, length = m)]
#[support(A = floor, friction = 0.1, restitution = e)]
#[support(C = floor, friction = 0.1, restitution = e)]
#[figure(A = (5, 0), B = (5.6, 0.8), C = (-5, 0), D = (-5.6, 0.8))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[mirror(x = 0)]
struct Images {
    e: f64,
    /// Mass and length.
    m: f64,
}

const THETA: f64 = 0.959_931_088_596_881_3;

fn above_the_floor() -> Pose {
    Pose::new("theta", THETA)
        .with("x", 0.0)
        .with("y", 0.01)
        .with("x'", 0.3)
        .with("y'", -1.0)
        .with("theta'", 0.0)
}

fn after<M: BarSystem>(model: &M, pose: Pose, names: &[&str]) -> Vec<f64> {
    let run = Simulation::new(model).unwrap().start(pose).unwrap().limit(0.02).run().unwrap();
    assert!(run.events().iter().any(|event| event.kind == EventKind::Impact));
    let value = |name: &&str| run.value(&Output::parse(run.layout(), name).unwrap(), 0.02);
    names.iter().map(value).collect()
}

#[test]
fn a_rod_does_not_know_of_another() {
    for e in [0.0, 0.5] {
        let one = after(&One { e, m: 1.0 }, above_the_floor(), &["theta'", "x'", "y'"]);
        assert!(e > 0.0 || (one[0] + 1.691391).abs() < 1e-6, "{one:?}");
        let images = after(&Images { e, m: 1.0 }, above_the_floor(), &["theta'", "x'", "y'"]);
        let both = above_the_floor().with("theta2", THETA).with("x2", 10.0).with("y2", 0.01);
        let both = both.with("x2'", 0.3).with("y2'", -1.0).with("theta2'", 0.0);
        let two = after(&Two { e, m: 1.0 }, both, &["theta'", "x'", "y'", "theta2'", "x2'", "y2'"]);
        for (k, value) in images.iter().chain(&two).enumerate() {
            assert!((value - one[k % 3]).abs() < 1e-12, "{e}: {one:?} {images:?} {two:?}");
        }
    }
}

/// Stronge's law is of one contact of each group.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(10)]
#[particle(P, mass = p)]
#[particle(Q, mass = 1)]
#[support(P = floor, restitution = 0.5, law = stronge)]
#[support(Q = floor, restitution = 0.25, law = stronge)]
#[figure(P = (0, 1), Q = (5, 1))]
struct Balls {
    p: f64,
}

#[test]
fn uncoupled_balls_strike_at_once_by_stronge_s_law() {
    let pose = Pose::new("x_P", 0.0).with("y_P", 1.0).with("x_Q", 5.0).with("y_Q", 1.0);
    let run = Simulation::new(&Balls { p: 3.0 }).unwrap().start(pose).unwrap().limit(0.5).run().unwrap();
    let impact = &run.events()[1];
    assert_eq!((impact.kind, &impact.supports[..]), (EventKind::Impact, &["P", "Q"][..]));
    let speed = 20f64.sqrt();
    for (name, e) in [("y_P'", 0.5), ("y_Q'", 0.25)] {
        let value = run.value(&Output::parse(run.layout(), name).unwrap(), 0.5);
        let expected = e * speed - 10.0 * (0.5 - speed / 10.0);
        assert!((value - expected).abs() < 1e-9, "{name} {value} {expected}");
    }
}
