//! Equilibria, modes of vibration, derivatives.

use crate::program::{errors, place, run, told};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&told(arguments)).expect("JSON")
}

/// A plank on three feet, its centre of mass above the middle one.
const PLANK: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[point(B = AC, at = l / 2)]
#[support(A = floor)]
#[support(B = floor)]
#[support(C = floor)]
#[figure(A = (0, 0), C = (l, 0))]
#[coordinate(phi = angle(AC))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Plank {
    #[value = 2.0]
    m: f64,
    #[value = 3.0]
    l: f64,
    #[value = 10.0]
    g: f64,
}";

#[test]
fn equilibria_are_told_with_their_loads() {
    let file = place("plank.rs");
    std::fs::write(&file, PLANK).expect("a file");
    let name = file.to_str().expect("a name");
    let text = told(&["equilibrium", name]);
    assert!(text.contains("A, B, C closed, neutral") && text.contains("N(B) = 0 … 20.0000"), "{text}");
    let found = json(&["equilibrium", name, "--json"]);
    let most = |k: usize| found[0]["loads"][k]["normal"][1].as_f64().expect("a force");
    assert!((0..3).all(|k| (most(k) - [10.0, 20.0, 10.0][k]).abs() < 1e-9), "{found}");
    assert!(errors(&run(&["equilibrium", "trestle"])).contains("no equilibrium found"));
}

/// A bar that falls on a floor, and bounces.
const BAR: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (0, l), B = (4 * l / 5, 8 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Bar {
    #[value = 1.5]
    m: f64,
    #[value = 0.5]
    l: f64,
    #[value = 10.0]
    g: f64,
    #[value = 0.0]
    e: f64,
}";

#[test]
fn derivatives_are_told_through_events() {
    let file = place("bar.rs");
    std::fs::write(&file, BAR).expect("a file");
    let name = file.to_str().expect("a name");
    let command = |more: &[&'static str]| [&["sensitivity", name, "--start", "y=0.8"], more].concat();
    let tilted = command(&["--start", "phi=0", "--start", "phi'=1", "--limit", "0.4", "--json"]);
    let found = json(&tilted);
    let events = found["events"].as_array().expect("events");
    let first = &events[1];
    assert_eq!(first["kind"], "impact", "{found}");
    let total = |names: &[(&str, f64)]| -> f64 {
        names.iter().map(|(name, value)| value * first["time"][name].as_f64().expect("a number")).sum()
    };
    // Lengths and gravity grown alike change no time: the rate of the start is the inverse of one.
    let t = first["t"].as_f64().expect("a time");
    let similar = total(&[("l", 0.5), ("y", 0.8), ("g", 10.0)]);
    assert!(similar.abs() < 1e-10 * t, "{similar:e}");
    assert!(total(&[("m", 1.5)]).abs() < 1e-10 * t && total(&[("e", 1.0)]).abs() < 1e-10 * t);
    let text = told(&command(&["--start", "phi=0.3", "--limit", "0.3", "--of", "m", "--of", "y"]));
    assert!(text.contains("d/dm") && text.contains("phi'"), "{text}");
    let refused = |more: &[&'static str]| errors(&run(&command(more)));
    assert!(refused(&["--of", "mass"]).contains("neither a parameter nor given at the start"));
    assert!(refused(&["--start", "phi=0", "--limit", "0.5", "--of", "phi"]).contains("come apart"));
    assert!(refused(&["--set", "e=0.5", "--start", "phi=0.3", "--limit", "3"]).contains("infinitely many"));
}

#[test]
fn modes_of_vibration_are_told() {
    let linear = json(&["linearise", "trestle", "--closed", "free", "--json"]);
    let rows = linear["A"].as_array().expect("rows");
    // α, β, x, y without contact.
    assert_eq!((rows.len(), rows[0].as_array().map(Vec::len)), (8, Some(8)));
    assert_eq!(linear["B"][4].as_array().map(Vec::len), Some(4));
}

#[test]
fn wrong_requests_are_told() {
    assert!(errors(&run(&["equilibrium", "nothing"])).contains("nothing"));
    assert!(errors(&run(&["linearise", "trestle", "--closed", "Z"])).contains('Z'));
    assert!(errors(&run(&["equilibrium", "trestle", "--start", "gamma=1"])).contains("gamma"));
}
