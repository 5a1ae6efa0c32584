//! Equilibria and modes of vibration.

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
