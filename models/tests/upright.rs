//! The zigzag released almost upright, where the gap rows of its feet differ by cos φ alone.

use std::f64::consts::FRAC_PI_2;

use liftoff::{EventKind, Trajectory};
use liftoff_models::models;
use liftoff_studio::registry::{MethodId, RunOptions};

const USUAL: (MethodId, f64) = (MethodId::Auto, 1e-9);
const GRAVITY: f64 = 9.81;
const ANGLES: [(&str, &[&str]); 3] = [
    ("zigzag", &["phi_inner", "phi_outer"]),
    ("zigzag-full", &["phi_ab", "phi_bc", "phi_cd", "phi_de"]),
    ("zigzag-thread", &["phi_inner", "phi_outer"]),
];

/// At rest at φ = π/2 − δ, with a bar of mass λ outside and one of 1 − λ inside.
fn release(
    (model, angles): (&str, &[&str]),
    [lambda, delta]: [f64; 2],
    (method, tolerance): (MethodId, f64),
) -> Trajectory {
    let models = models();
    let model = models.iter().find(|entry| entry.name() == model).expect("a model");
    let mut spec = model.default_run();
    let masses = [("m1", 1.0 - lambda), ("m2", lambda)];
    spec.parameters.retain(|(name, _)| name != "m1" && name != "m2");
    spec.parameters.extend(masses.map(|(name, mass)| (name.to_owned(), mass)));
    spec.start = angles.iter().map(|angle| ((*angle).to_owned(), FRAC_PI_2 - delta)).collect();
    (spec.limit, spec.tolerance) = (Some(60.0), tolerance);
    model
        .run_by(RunOptions::by(method), &spec)
        .unwrap_or_else(|error| panic!("{} at {lambda}, {delta:e}: {error}", model.name()))
}

fn events(run: &Trajectory) -> Vec<(EventKind, Vec<&'static str>)> {
    let events = run.events().iter();
    events.map(|event| (event.kind, event.supports.clone())).collect()
}

/// N of A and of C as φ → π/2: the bars fall with φ″ = −(3/2) (g/l) cos φ/(1 + 6λ), and A and E take
/// λ g (1 − (5/3) l φ″/(g cos φ)) together.
fn limits(lambda: f64) -> [f64; 2] {
    let foot = 0.5 * lambda * GRAVITY * (1.0 + 2.5 / (1.0 + 6.0 * lambda));
    [foot, 2.0 * GRAVITY - 2.0 * foot]
}

#[test]
fn events_and_reactions_are_those_of_the_upright_start() {
    for (model, angles) in ANGLES {
        for lambda in [0.05, 0.1, 0.25, 0.5, 0.75, 0.9] {
            let expected = events(&release((model, angles), [lambda, 1e-2], USUAL));
            let [foot, middle] = limits(lambda);
            for decade in 3..=15 {
                for digit in [1.0, 2.0, 5.0] {
                    let delta = digit * 10_f64.powi(-decade);
                    let run = release((model, angles), [lambda, delta], USUAL);
                    let place = format!("{model} at {lambda}, {delta:e}");
                    assert_eq!(events(&run), expected, "{place}");
                    // Reactions are even in δ, with a curvature of a few of them.
                    let bound = 1e-8 + 100.0 * delta * delta;
                    for (label, reaction) in [("N(A)", foot), ("N(C)", middle), ("N(E)", foot)] {
                        let found = run.value(&run.output(label).unwrap(), 0.0);
                        assert!(
                            (found - reaction).abs() < bound,
                            "{place}: {label} = {found}, not {reaction}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn no_method_takes_another_turn() {
    let expected = events(&release(ANGLES[0], [0.5, 1e-2], USUAL));
    for method in MethodId::ALL {
        for tolerance in [1e-5, 1e-12] {
            for delta in [1e-4, 1e-8, 1.5e-8, 1e-12] {
                let run = release(ANGLES[0], [0.5, delta], (method, tolerance));
                assert_eq!(events(&run), expected, "{} at {tolerance:e}, {delta:e}", method.name());
            }
        }
    }
}
