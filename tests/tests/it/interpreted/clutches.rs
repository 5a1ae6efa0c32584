//! Models whose drives come and go, with runs in which they do.

use liftoff::prelude::*;
use liftoff_studio::models;
use liftoff_studio::registry::Entry;

/// A flywheel that a couple turns, and a dog clutch to an even shaft.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[couple(OA = c)]
#[drive(angle(OA) = w * t, while("sin(w * t / 2) > 0"))]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (l, 0))]
#[run(start = "phi = -1, phi' = 0", limit = 6)]
struct DogClutch {
    #[value = 1.2]
    m: f64,
    #[value = 0.8]
    l: f64,
    #[value = 0.5]
    g: f64,
    #[value = 0.7]
    c: f64,
    #[value = 2.0]
    w: f64,
}

/// A load that a telescopic arm catches and throws.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[support(P = floor(-h))]
#[drive(distance(O, P) = l + c * t, while("y > -h / 2"))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (l, 0))]
#[run(start = "x = 1, y = 1, x' = 1, y' = 1", limit = 4)]
struct Thrower {
    #[value = 1.2]
    m: f64,
    #[value = 2]
    l: f64,
    #[value = 3]
    h: f64,
    #[value = 1.0]
    g: f64,
    #[value = 0.1]
    c: f64,
}

pub fn models() -> Vec<Entry> {
    models![DogClutch, Thrower].iter().cloned().collect()
}

#[test]
fn their_drives_take_hold_and_let_go() {
    for entry in models() {
        let run = entry.run(&entry.default_run()).unwrap();
        for kind in [EventKind::Impact, EventKind::Disarm] {
            let drives = |event: &&Event| event.supports.iter().any(|of| of.starts_with("drive "));
            let happens = run.events().iter().filter(drives).any(|event| event.kind == kind);
            assert!(happens, "{}: {:?}", entry.name(), run.events());
        }
        assert!(run.audit().is_clean(), "{}: {:?}", entry.name(), run.audit());
    }
}
