//! Bodies that strike bodies: balls in a row, dominoes.

use super::{CLOSE, evaluate_output, pose};
use crate::common::run;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use liftoff::prelude::*;
use liftoff_compiled::*;

const RATES: [&str; 5] = ["a'", "b'", "c'", "f'", "h'"];

fn cradle(d: f64, e: f64) -> NewtonsCradle {
    NewtonsCradle { m: 0.3, r: 0.02, l: 0.2, d, e, g: 9.81 }
}

fn hanging(first: f64, rate: f64) -> Pose {
    let rest =
        [("b", 0.0), ("c", 0.0), ("f", 0.0), ("h", 0.0), ("b'", 0.0), ("c'", 0.0), ("f'", 0.0), ("h'", 0.0)];
    rest.iter().fold(pose(&[("a", first), ("a'", rate)]), |pose, (name, value)| pose.with(name, *value))
}

fn after(event: &Event) -> [f64; 5] {
    RATES.map(|rate| event[rate])
}

/// Apart, each strikes the next, and the last alone has the rate of the first: equal masses
/// exchange theirs. Where they meet is d/l off the vertical, which turns lines of centres and takes
/// from rates what is of second order in it.
#[test]
fn balls_apart_pass_the_blow_on() {
    let (l, g, raised) = (0.2, 9.81, 0.4_f64);
    let run = run(&cradle(1e-7, 1.0), hanging(-raised, 0.0), &["t = 0.4"]);
    let impacts: Vec<&Event> = run.events().iter().filter(|e| e.kind == EventKind::Impact).collect();
    assert_eq!(impacts.iter().map(|e| e.supports[0]).collect::<Vec<_>>(), ["A", "B", "C", "D"]);
    // The ball's inertia about its own middle adds to that about the hinge.
    let about = l * l + 0.4 * 0.02 * 0.02;
    let rate = (2.0 * g * l * (1.0 - raised.cos()) / about).sqrt();
    for (found, expected) in after(impacts[3]).iter().zip([0.0, 0.0, 0.0, 0.0, rate]) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-9);
    }
}

/// Touching, all are struck at once: what approached is turned back, nothing else, so that of n
/// balls the first comes back with (2 − n)/n and the others go on with 2/n; momentum and energy are
/// kept by this as by the other.
#[test]
fn balls_that_touch_are_struck_at_once() {
    let run = run(&cradle(0.0, 1.0), hanging(0.0, 1.5), &["t = 1e-3"]);
    let first = run.events().iter().find(|e| e.kind == EventKind::Impact).unwrap();
    let rates = after(first);
    for (found, expected) in rates.iter().zip([-3.0, 2.0, 2.0, 2.0, 2.0]) {
        assert_abs_diff_eq!(*found, 1.5 * expected / 5.0, epsilon = CLOSE);
    }
    assert_abs_diff_eq!(rates.iter().sum::<f64>(), 1.5, epsilon = CLOSE);
    assert_abs_diff_eq!(rates.iter().map(|rate| rate * rate).sum::<f64>(), 1.5 * 1.5, epsilon = CLOSE);
}

/// Without restitution all go on together, struck at once or one after the other.
#[test]
fn plastic_balls_go_on_together() {
    for (d, bound) in [(0.0, CLOSE), (1e-7, 1e-4)] {
        let run = run(&cradle(d, 0.0), hanging(0.0, 1.5), &["t = 1e-3"]);
        let last = run.events().iter().rfind(|e| e.kind == EventKind::Impact).unwrap();
        for rate in after(last) {
            assert_abs_diff_eq!(rate, 0.3, epsilon = bound);
        }
    }
}

/// Three balls on a line.
macro_rules! three {
    ($name:ident, $law:ident) => {
        #[doc = "Three balls on a line."]
        #[derive(BarSystem)]
        #[particle(A, mass = m)]
        #[particle(B, mass = m)]
        #[particle(C, mass = m)]
        #[disc(A, radius = r)]
        #[disc(B, radius = r)]
        #[disc(C, radius = r)]
        #[slider(A = horizontal(0))]
        #[slider(B = horizontal(0))]
        #[slider(C = horizontal(0))]
        #[support(A = disc(B), restitution = 1, law = $law)]
        #[support(B = disc(C), restitution = 1, law = $law)]
        #[figure(A = (0, 0), B = (2 * r, 0), C = (4 * r, 0))]
        struct $name {
            m: f64,
            r: f64,
        }
    };
}
three!(ByNewton, newton);
three!(ByPoisson, poisson);

fn struck<M: BarSystem>(model: &M) -> [f64; 3] {
    let places = [("x_A", 0.0), ("x_B", 0.2), ("x_C", 0.4), ("x_A'", 3.0), ("x_B'", 0.0), ("x_C'", 0.0)];
    let run = run(model, pose(&places), &["t = 0.1"]);
    ["x_A'", "x_B'", "x_C'"].map(|rate| evaluate_output(&run, rate, 0.05))
}

/// Of three that touch both laws give −1/3, 2/3, 2/3.
#[test]
fn newton_and_poisson_agree_on_balls_that_touch() {
    for rates in [struck(&ByNewton { m: 0.7, r: 0.1 }), struck(&ByPoisson { m: 0.7, r: 0.1 })] {
        for (found, expected) in rates.iter().zip([-1.0, 2.0, 2.0]) {
            assert_abs_diff_eq!(*found, expected, epsilon = CLOSE);
        }
    }
}

/// The first falls about its foot until sin φ = s/h, with ½ I ω² = m g × the fall of its middle; a
/// plastic blow at one height leaves both half of the rate where the feet do not slip.
#[test]
fn dominoes_halve_their_rate() {
    let (m, w, h, s, g): (f64, f64, f64, f64, f64) = (0.02, 0.008, 0.048, 0.02, 9.81);
    let lean = 0.25_f64;
    let run = run(&Dominoes { m, w, h, s, mu: 4.0, g }, Pose::new("phi", -lean), &["t = 0.12"]);
    let first = run.events().iter().find(|e| e.kind == EventKind::Impact).unwrap();
    let struck = (s / h).asin();
    assert_eq!(first.supports, ["C"]);
    assert_abs_diff_eq!(first["phi"], -struck, epsilon = CLOSE);
    let middle = |phi: f64| 0.5 * (h * phi.cos() + w * phi.sin());
    let inertia = m * (w * w + h * h) / 3.0;
    let rate = (2.0 * m * g * (middle(lean) - middle(struck)) / inertia).sqrt();
    assert_relative_eq!(evaluate_output(&run, "phi'", first.t.next_down()), -rate, max_relative = CLOSE);
    assert_relative_eq!(first["phi'"], -0.5 * rate, max_relative = CLOSE);
    assert_relative_eq!(first["psi'"], -0.5 * rate, max_relative = CLOSE);
}

/// All fall, each against the next, and the last on the floor; what they had in height is lost.
#[test]
fn all_dominoes_fall() {
    let model = models().find("dominoes").unwrap();
    let run = model.run(&model.default_run()).unwrap();
    let impacts = run.events().iter().filter(|e| e.kind == EventKind::Impact);
    assert_eq!(impacts.map(|e| e.supports[0]).collect::<Vec<_>>(), ["C", "G", "L", "Q"]);
    let end = run.end_time();
    for angle in ["phi", "psi", "chi", "theta"] {
        assert!(evaluate_output(&run, angle, end) < -1.2);
        assert_abs_diff_eq!(evaluate_output(&run, &format!("{angle}'"), end), 0.0, epsilon = 1e-9);
    }
    let lost = evaluate_output(&run, "V", 0.0) - evaluate_output(&run, "V", end);
    assert_relative_eq!(evaluate_output(&run, "D", end), lost, max_relative = 1e-8);
}
