//! Equilibria, modes of vibration, derivatives.

use crate::program::{errors, run, run_program, temporary_path};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&run_program(arguments)).expect("JSON")
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

/// What nothing holds.
const FALLING: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[figure(A = (0, 0), B = (l, 0))]
#[coordinate(phi = angle(AB))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Falling {
    #[value = 1.5]
    m: f64,
    #[value = 2]
    l: f64,
    #[value = 9.81]
    g: f64,
}";

#[test]
fn equilibria_are_reported_with_their_loads() {
    let file = temporary_path("plank.rs");
    std::fs::write(&file, PLANK).expect("a file");
    let name = file.to_str().expect("a name");
    let text = run_program(&["equilibrium", name]);
    assert!(text.contains("A, B, C closed, neutral") && text.contains("N(B) = 0 … 20.0000"), "{text}");
    let found = json(&["equilibrium", name, "--json"]);
    let most = |k: usize| found[0]["loads"][k]["normal"][1].as_f64().expect("a force");
    assert!((0..3).all(|k| (most(k) - [10.0, 20.0, 10.0][k]).abs() < 1e-9), "{found}");
    // Its legs stand upright at one place.
    assert!(run_program(&["equilibrium", "trestle"]).contains("A, B closed, unstable"));
    let file = temporary_path("falling.rs");
    std::fs::write(&file, FALLING).expect("a file");
    let name = file.to_str().expect("a name");
    assert!(errors(&run(&["equilibrium", name])).contains("no equilibrium found"));
    // Whether there is one or not.
    assert!(errors(&run(&["equilibrium", "trestle", "--load", "q"])).contains("no parameter `q`"));
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
fn derivatives_are_reported_through_events() {
    let file = temporary_path("bar.rs");
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
    let text = run_program(&command(&["--start", "phi=0.3", "--limit", "0.3", "--of", "m", "--of", "y"]));
    assert!(text.contains("d/dm") && text.contains("phi'"), "{text}");
    let refused = |more: &[&'static str]| errors(&run(&command(more)));
    assert!(refused(&["--of", "mass"]).contains("neither a parameter nor given at the start"));
    assert!(refused(&["--start", "phi=0", "--limit", "0.5", "--of", "phi"]).contains("separate"));
    assert!(refused(&["--set", "e=0.5", "--start", "phi=0.3", "--limit", "3"]).contains("infinitely many"));
}

#[test]
fn a_load_is_reported_that_opens_a_foot() {
    let file = temporary_path("loaded.rs");
    std::fs::write(&file, LOADED).expect("a file");
    let name = file.to_str().expect("a name");
    // Moments about B: p c = m g (l/2 − c), c from B outward to C.
    let limit = |more: &[&str]| {
        json(&[&["equilibrium", name, "--load", "p", "--json"], more].concat())[0]["limit"].clone()
    };
    let found = limit(&[]);
    let expected = 2.0 * 10.0 * 0.5 / 1.0;
    let value = found["value"].as_f64().expect("a load");
    assert!((value / expected - 1.0).abs() < 1e-10 && found["end"] == "A opens", "{found}");
    let text = run_program(&["equilibrium", name, "--load", "p=5"]);
    assert!(text.contains("p may go as far as it is followed"), "{text}");
    assert!(errors(&run(&["equilibrium", name, "--load", "q"])).contains("no parameter `q`"));
}

/// A plank on two feet, with a load at its end beyond the second.
const LOADED: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[point(B = AC, at = l - c)]
#[support(A = floor)]
#[support(B = floor)]
#[force(C = (0, -p))]
#[figure(A = (0, 0), C = (l, 0))]
#[coordinate(phi = angle(AC))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Loaded {
    #[value = 2.0]
    m: f64,
    #[value = 3.0]
    l: f64,
    #[value = 1.0]
    c: f64,
    #[value = 1.0]
    p: f64,
    #[value = 10.0]
    g: f64,
}";

/// A ball on a floor that moves, seen from the floor.
const JUGGLED: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = vertical(0))]
#[force(P = (0, m * a * w * w * sin(w * t - 1.5)))]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(y = y(P))]
struct Juggled {
    #[value = 1.0]
    m: f64,
    #[value = 0.028]
    a: f64,
    #[value = 20.0]
    w: f64,
    #[value = 0.6]
    e: f64,
    #[value = 9.0]
    g: f64,
}";

#[test]
fn orbits_are_reported_and_followed() {
    let file = temporary_path("juggled.rs");
    std::fs::write(&file, JUGGLED).expect("a file");
    let name = file.to_str().expect("a name");
    let command = |more: &[&'static str]| {
        [&["orbit", name, "--start", "y=0.154", "--start", "y'=-0.379", "--section", "t = 2*pi/w"], more]
            .concat()
    };
    let orbit = json(&command(&["--json"]));
    let part = |k: usize, i: usize| orbit["multipliers"][k][i].as_f64().expect("a number");
    // The product of both multipliers is e².
    let product = part(0, 0) * part(1, 0) - part(0, 1) * part(1, 1);
    assert!((product - 0.36).abs() < 1e-9, "{orbit}");
    assert!(run_program(&command(&[])).contains("multipliers: "));
    // The fold at a ω = (g π/ω)(1 − e)/(1 + e).
    let branch = json(&command(&["--continue", "a=0.01", "--json"]));
    let mut orbits = branch["orbits"].as_array().expect("orbits").iter();
    let fold = orbits.find(|orbit| orbit["special"] == "fold").expect("a fold");
    let expected = 9.0 * core::f64::consts::PI / 400.0 * 0.25;
    assert!((fold["parameters"]["a"].as_f64().expect("a number") / expected - 1.0).abs() < 1e-9, "{fold}");
    let refused = |more: &[&'static str]| errors(&run(&[&["orbit", name], more].concat()));
    assert!(refused(&["--section", "impact Z"]).contains("Z"));
    assert!(refused(&["--section", "y >"]).contains("neither a kind of event"));
    assert!(refused(&["--section", "y > 100", "--limit", "1"]).contains("does not reach the section"));
    assert!(refused(&["--section", "impact", "--drift", "z"]).contains("z"));
}

#[test]
fn optima_are_reported() {
    let file = temporary_path("juggled_optimum.rs");
    std::fs::write(&file, JUGGLED).expect("a file");
    let name = file.to_str().expect("a name");
    let command = |more: &[&'static str]| {
        [&["optimise", name, "--set", "a=0", "--limit", "2", "--start", "y=0.9"], more].concat()
    };
    // Thrown upwards at v from 0.9 m it strikes at (v + √(v² + 2 g y))/g, here nearest to 0.9 s.
    let thrown = ["--start", "y'=1", "--vary", "y'", "--of", "first impact (t - 0.9)^2"];
    let found = json(&command(&[&thrown[..], &["--json"]].concat()));
    let v = found["variables"]["y'"]["value"].as_f64().expect("a number");
    assert!((v - (4.5 * 0.81 - 0.9) / 0.9).abs() < 1e-6, "{found}");
    assert!(run_program(&command(&thrown)).contains("converged after"));
    let heavy = run_program(&command(&["--vary", "g=8:9.5", "--of", "first impact"]));
    assert!(heavy.contains("at its bound") && heavy.contains("first impact: "), "{heavy}");
    let refused = |more: &[&'static str]| errors(&run(&command(more)));
    assert!(refused(&["--vary", "g=9:8", "--of", "end y"]).contains("a lower and a greater bound"));
    assert!(
        refused(&["--vary", "g=1:2", "--of", "end y"]).contains("g = 9 is not between its bounds, 1 and 2")
    );
    assert!(refused(&["--vary", "g", "--of", "max y"]).contains("--of max y: expected an event"));
    assert!(refused(&["--vary", "g", "--of", "200th impact"]).contains("there is no 200th impact"));
}

#[test]
fn boundaries_are_reported() {
    let file = temporary_path("juggled_boundary.rs");
    std::fs::write(&file, JUGGLED).expect("a file");
    let name = file.to_str().expect("a name");
    // On a floor at rest the ball has struck at the end where g t²/2 > y.
    let command = |more: &[&'static str]| {
        let vary = ["--set", "a=0", "--vary", "g=8:12", "--vary", "y=0.1:1.6", "--limit", "0.5", "--observe"];
        [&["boundary", name], &vary[..], &["first impact"], more].concat()
    };
    let found = json(&command(&["--json"]));
    let curves = found.as_array().expect("curves");
    assert_eq!(curves.len(), 1, "{found}");
    let points = curves[0]["points"].as_array().expect("points");
    for point in points {
        let [g, y] = [0, 1].map(|k| point[k].as_f64().expect("a number"));
        assert!((y / (0.125 * g) - 1.0).abs() < 1e-8, "{point}");
    }
    assert!(points.len() > 10 && run_program(&command(&[])).contains("none"));
    assert!(errors(&run(&["boundary", name, "--vary", "g=8:12"])).contains("two varied names"));
}

#[test]
fn modes_of_vibration_are_reported() {
    let linear = json(&["linearise", "trestle", "--closed", "free", "--json"]);
    let rows = linear["A"].as_array().expect("rows");
    // α, β, x, y without contact.
    assert_eq!((rows.len(), rows[0].as_array().map(Vec::len)), (8, Some(8)));
    assert_eq!(linear["B"][4].as_array().map(Vec::len), Some(4));
}

/// Two bars that hang side by side, their ends joined by a spring and a damper.
const PENDULUMS: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(QB, mass = m, length = l)]
#[pin(O = (-d, 0))]
#[pin(Q = (d, 0))]
#[spring(AB, stiffness = k, length = 2 * d, damping = c)]
#[figure(A = (-d, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[mirror(x = 0, swap(A, B))]
struct Pendulums {
    #[value = 2.0]
    m: f64,
    #[value = 0.7]
    l: f64,
    #[value = 0.4]
    d: f64,
    #[value = 30.0]
    k: f64,
    #[value = 0.5]
    c: f64,
    #[value = 9.81]
    g: f64,
}";

/// Swinging in parallel, which the mirror leaves out, ω² = 3g/2l; against each other, ω² = 3g/2l +
/// 6k/m, damped by 3c/m.
#[test]
fn a_mirrored_model_is_unfolded() {
    let file = temporary_path("pendulums.rs");
    std::fs::write(&file, PENDULUMS).expect("a file");
    let name = file.to_str().expect("a name");
    let parts = json(&["linearise", name, "--unfold", "--json"]);
    let mode = |part: &str| {
        let modes = parts[part]["modes"].as_array().expect("modes");
        assert_eq!(modes.len(), 1, "{parts}");
        let [re, im] = [0, 1].map(|i| modes[0]["rate"][i].as_f64().expect("a rate"));
        let shape = |name: &str| modes[0]["shape"][name][0].as_f64().expect("a part");
        (re, re.hypot(im).powi(2), shape("phi_image") / shape("phi"))
    };
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12 * (1.0 + b.abs());
    let swing = 3.0 * 9.81 / 1.4;
    let (decay, square, image) = mode("symmetric");
    assert!(near(-decay, 0.75) && near(square, swing + 90.0) && near(image, 1.0), "{parts}");
    let (decay, square, image) = mode("antisymmetric");
    assert!(near(decay, 0.0) && near(square, swing) && near(image, -1.0), "{parts}");
    let text = run_program(&["linearise", name, "--unfold"]);
    let [symmetric, antisymmetric] = ["symmetric\n  ", "\nantisymmetric\n  "].map(|head| text.find(head));
    assert!(symmetric == Some(0) && antisymmetric > symmetric && !text.contains("grows"), "{text}");
    let picture = temporary_path("pendulums.svg");
    let path = picture.to_str().expect("a name");
    assert_eq!(run_program(&["linearise", name, "--unfold", "--svg", path]), "");
    let svg = std::fs::read_to_string(&picture).expect("a picture");
    // Two points of the ground stand, two swing, in each of two modes.
    assert!(svg.contains(">symmetric: ") && svg.contains(">antisymmetric: "), "{svg:.400}");
    assert_eq!(svg.matches("<animateTransform").count(), 4);
    assert!(errors(&run(&["linearise", name, "--svg", "modes.png"])).contains("name the file modes.svg"));
    assert!(errors(&run(&["linearise", "trestle", "--unfold"])).contains("`Trestle` has no mirror"));
    // Upright both fall, and neither motion waits for the other.
    let upright =
        run_program(&["linearise", name, "--unfold", "--start", "phi=pi", "--set", "k=0", "--set", "c=0"]);
    assert!(
        upright.contains("the antisymmetric motion grows 1.00000 times as fast as the symmetric one"),
        "{upright}"
    );
}

#[test]
fn wrong_requests_are_reported() {
    let fixed = ["linearise", "trestle", "--svg", "-", "--json"];
    assert!(errors(&run(&fixed)).contains("cannot be used with"));
    assert!(errors(&run(&["equilibrium", "nothing"])).contains("nothing"));
    assert!(errors(&run(&["linearise", "trestle", "--closed", "Z"])).contains('Z'));
    assert!(errors(&run(&["equilibrium", "trestle", "--start", "gamma=1"])).contains("gamma"));
}
