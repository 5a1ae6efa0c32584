//! Models with impacts, with supports that open, and without contacts.

use liftoff::BarSystem;
use liftoff::Trajectory;
use liftoff_fixtures::PairOnCorners;
use liftoff_studio::RunSpec;

/// A bar dropped on a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (-l / 2, l), B = (l / 2, l))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct DroppedBar {
    m: f64,
    l: f64,
    e: f64,
    g: f64,
}

/// A double pendulum.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}

const ONE: [(&str, f64); 3] = [("m", 1.0), ("l", 1.0), ("g", 9.81)];

pub fn dropped_bar() -> Trajectory {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("e", 0.6), ("g", 9.81)]);
    run("dropped-bar", &spec.start(&[("phi", 0.5), ("y", 1.0)]).until("t = 3"))
}

pub fn falling_pair() -> Trajectory {
    run("pair-on-corners", &RunSpec::with(&ONE).start(&[("phi", 0.1)]).until("phi = pi/2"))
}

pub fn double_pendulum() -> Trajectory {
    run("double-pendulum", &RunSpec::with(&ONE).start(&[("phi", 2.0), ("psi", 1.0)]).until("t = 10"))
}

fn run(model: &str, spec: &RunSpec) -> Trajectory {
    liftoff_studio::models![DroppedBar, PairOnCorners, DoublePendulum].find(model).unwrap().run(spec).unwrap()
}
