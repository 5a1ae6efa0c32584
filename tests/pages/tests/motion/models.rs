//! Models with impacts, with supports that open, and without contacts.

use liftoff::BarSystem;
use liftoff::catalog::Record;
use liftoff::scene::Setup;

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

/// Two equal bars, hinged at D, lie across a gap on two corners.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct FallingPair {
    m: f64,
    l: f64,
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

pub fn dropped_bar() -> Box<dyn Record> {
    let setup = Setup::with(&[("m", 1.0), ("l", 1.0), ("e", 0.6), ("g", 9.81)]);
    run("dropped-bar", &setup.start(&[("phi", 0.5), ("y", 1.0)]).until("t = 3"))
}

pub fn falling_pair() -> Box<dyn Record> {
    run("falling-pair", &Setup::with(&ONE).start(&[("phi", 0.1)]).until("phi = pi/2"))
}

pub fn double_pendulum() -> Box<dyn Record> {
    run("double-pendulum", &Setup::with(&ONE).start(&[("phi", 2.0), ("psi", 1.0)]).until("t = 10"))
}

fn run(model: &str, setup: &Setup) -> Box<dyn Record> {
    liftoff::models![DroppedBar, FallingPair, DoublePendulum].find(model).unwrap().run(setup).unwrap()
}
