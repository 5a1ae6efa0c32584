//! When runs end that no limit is given for.

use crate::program::{run_program, temporary_path};
use serde_json::Value;

/// A ball that flies freely.
const BALL: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Flying {
    #[value = 2.0]
    m: f64,
    #[value = 10.0]
    g: f64,
}";

fn events(more: &[&str]) -> Vec<Value> {
    let file = temporary_path("flying.rs");
    std::fs::write(&file, BALL).expect("a file");
    let name = file.to_str().expect("a name");
    let found: Value =
        serde_json::from_str(&run_program(&[&["run", name, "--json"], more].concat())).expect("JSON");
    found["events"].as_array().expect("events").clone()
}

fn number(event: &Value, name: &str) -> f64 {
    let found = if name == "t" { &event["t"] } else { &event["state"][name] };
    found.as_f64().expect("a number")
}

/// y = 1 − g t²/2 + p (t − t₁)/m: a great impulse makes natural times short, a thousand of which
/// pass before it.
#[test]
fn runs_go_on_to_their_last_impulse_and_beyond() {
    let (t1, p) = (0.5, 2e4);
    let events = events(&["--impulse", "P=0,2e4@0.5"]);
    let kinds: Vec<&str> = events.iter().filter_map(|event| event["kind"].as_str()).collect();
    assert_eq!(kinds, ["start", "impulse", "end"]);
    assert_eq!(number(&events[1], "t"), t1);
    let t = number(&events[2], "t");
    assert!(t > t1 + 1e-3, "{t}");
    let y = 1.0 - 5.0 * t * t + p * (t - t1) / 2.0;
    assert!((number(&events[2], "y") - y).abs() < 1e-9 * y, "{y}: {events:?}");
}

/// A fast start makes natural times short, a thousand of which pass before the run is to end.
#[test]
fn runs_go_on_to_the_time_that_ends_them() {
    let events = events(&["--start", "y'=2e4", "--until", "t = 0.2"]);
    let last = events.last().expect("an end");
    assert_eq!((last["kind"].as_str(), number(last, "t")), (Some("stop"), 0.2), "{events:?}");
    let y = 1.0 + 2e4 * 0.2 - 5.0 * 0.04;
    assert!((number(last, "y") - y).abs() < 1e-9 * y, "{y}: {events:?}");
    // Only a limit that is given comes before it.
    let limited = self::events(&["--start", "y'=2e4", "--until", "t = 0.2", "--limit", "0.1"]);
    assert_eq!(number(limited.last().expect("an end"), "t"), 0.1);
}
