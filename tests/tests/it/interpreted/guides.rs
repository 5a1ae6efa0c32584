//! Models whose guides have friction, with runs that change sides, and one whose hinges have.

use liftoff::prelude::*;
use liftoff_studio::models;
use liftoff_studio::registry::Entry;

/// A ladder between two guides, through its lowest position and back.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = vertical(0), friction = nu / (1 + v * v), static = nu_s)]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (-3 * l / 5, 0), B = (0, 4 * l / 5))]
#[run(start = "theta = 0.9, theta' = 0", limit = 6)]
struct GuidedLadder {
    #[value = 1.2]
    m: f64,
    #[value = 0.8]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.1]
    mu: f64,
    #[value = 0.15]
    nu: f64,
    #[value = 0.2]
    nu_s: f64,
}

/// A bead that its bar's ends stop.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = m)]
#[slider(P = bar(OA), friction = mu, stops, restitution = e)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (0, -l), P = (0, -l / 2))]
#[run(start = "phi = 2.2, x = 0.28", limit = 1)]
struct StoppedBead {
    #[value = 1]
    m: f64,
    #[value = 0.9]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.2]
    mu: f64,
    #[value = 0.5]
    e: f64,
}

/// Two bars on journals, one of which strikes a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[hinge(O, friction = mu, radius = r)]
#[hinge(A, friction = mu, static = mu_s, radius = r)]
#[support(B = wall(-l / 2), facing = right, restitution = e)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
#[figure(A = (3 * l / 5, -4 * l / 5), B = (3 * l / 5, -9 * l / 5))]
#[run(start = "phi = 0.9, psi = 0.9", limit = 3)]
struct Journals {
    #[value = 1]
    m: f64,
    #[value = 0.6]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.3]
    mu: f64,
    #[value = 0.4]
    mu_s: f64,
    #[value = 0.03]
    r: f64,
    #[value = 0.5]
    e: f64,
}

/// Those that change sides, then that with hinges.
pub fn models() -> Vec<Entry> {
    models![GuidedLadder, StoppedBead, Journals].iter().cloned().collect()
}

#[test]
fn their_runs_change_sides() {
    for entry in models().into_iter().take(2) {
        let run = entry.run(&entry.default_run()).unwrap();
        assert!(
            run.events().iter().any(|event| event.kind == EventKind::Side),
            "{}: {:?}",
            entry.name(),
            run.events()
        );
    }
}

#[test]
fn hinges_turn_back_and_are_struck() {
    let entry = models().remove(2);
    let run = entry.run(&entry.default_run()).unwrap();
    for kind in [EventKind::Reverse, EventKind::Impact] {
        assert!(run.events().iter().any(|event| event.kind == kind), "{kind:?}: {:?}", run.events());
    }
}
