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

/// A wheel rolls on a floor and touches a bead on a ring; a pin plays in the hole about the bead.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(H = (0, 0), A = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))]
#[disc(H, radius = r)]
#[support(H = floor, friction = 9 / 10)]
#[particle(P, mass = m)]
#[slider(P = circle((4 * r, 2 * r), r))]
#[particle(Q, mass = m)]
#[support(Q = bowl(P, r / 2))]
#[figure(H = (0, r), A = (r, r), P = (5 * r, 2 * r), Q = (5 * r, 9 * r / 5))]
#[coordinate(phi = angle(wheel), from = right)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
struct Wheels {
    m: f64,
    r: f64,
    g: f64,
}

/// It rolls at 0.4 to the right.
pub fn wheels() -> Trajectory {
    let spec = RunSpec::with(&[("m", 1.0), ("r", 0.2), ("g", 9.81)]);
    let start = [("phi", 0.0), ("x", 0.0), ("y", 0.2), ("x'", 0.4), ("phi'", -2.0), ("y'", 0.0)];
    run("wheels", &spec.start(&start).until("t = 1"))
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
    liftoff_studio::models![DroppedBar, PairOnCorners, DoublePendulum, Wheels]
        .find(model)
        .unwrap()
        .run(spec)
        .unwrap()
}
