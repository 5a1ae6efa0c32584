//! The zigzag released almost upright, where the gap rows of its feet differ by cos φ alone.

use std::f64::consts::FRAC_PI_2;

use liftoff::{EventKind, Trajectory};
use liftoff_models::models;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, RunOptions};
use liftoff_studio::source::embedded;
use liftoff_verification::judgement::{Verdict, judge};

const USUAL: (MethodId, f64) = (MethodId::Auto, 1e-9);
const GRAVITY: f64 = 9.81;
const ANGLES: [(&str, &[&str]); 3] = [
    ("zigzag", &["phi_inner", "phi_outer"]),
    ("zigzag-full", &["phi_ab", "phi_bc", "phi_cd", "phi_de"]),
    ("zigzag-thread", &["phi_inner", "phi_outer"]),
];

/// At rest at φ = π/2 − δ, with a bar of mass λ outside and one of 1 − λ inside.
fn release((model, angles): (&str, &[&str]), [lambda, delta]: [f64; 2], by: (MethodId, f64)) -> Trajectory {
    release_from(model, lambda, angles.iter().map(|angle| (*angle, FRAC_PI_2 - delta)), by)
}

/// The same at angles of their own.
fn release_from<'a>(
    model: &str,
    lambda: f64,
    angles: impl Iterator<Item = (&'a str, f64)>,
    (method, tolerance): (MethodId, f64),
) -> Trajectory {
    let models = models();
    let model = models.iter().find(|entry| entry.name() == model).expect("a model");
    let mut spec = model.default_run();
    let masses = [("m1", 1.0 - lambda), ("m2", lambda)];
    spec.parameters.retain(|(name, _)| name != "m1" && name != "m2");
    spec.parameters.extend(masses.map(|(name, mass)| (name.to_owned(), mass)));
    spec.start = angles.map(|(angle, phi)| (angle.to_owned(), phi)).collect();
    spec.energy_of.clear();
    (spec.limit, spec.tolerance) = (Some(60.0), tolerance);
    model
        .run_by(RunOptions::by(method), &spec)
        .unwrap_or_else(|error| panic!("{} at {lambda}, {:?}: {error}", model.name(), spec.start))
}

fn events(run: &Trajectory) -> Vec<(EventKind, Vec<&'static str>)> {
    let events = run.events().iter();
    events.map(|event| (event.kind, event.supports.clone())).collect()
}

/// N of A and of C as φ → π/2: the bars fall with φ″ = −(3/2) (g/l) cos φ/(1 + 6λ), and A and E
/// take λ g (1 − (5/3) l φ″/(g cos φ)) together.
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
    for lambda in [0.5, 0.75] {
        let expected = events(&release(ANGLES[0], [lambda, 1e-2], USUAL));
        for method in MethodId::ALL {
            for tolerance in [1e-4, 1e-5, 1e-12] {
                for delta in [1e-4, 1e-8, 1.5e-8, 1e-9, 1e-12] {
                    let run = release(ANGLES[0], [lambda, delta], (method, tolerance));
                    let place = format!("{lambda}, {}, {tolerance:e}, {delta:e}", method.name());
                    assert_eq!(events(&run), expected, "{place}");
                }
            }
        }
    }
}

/// Also of the angles that the closed form has eliminated.
#[test]
fn accelerations_are_those_of_the_upright_start() {
    for (model, angles) in ANGLES {
        for (lambda, delta) in [(0.1, 1e-4), (0.5, 1e-8), (0.9, 1e-12)] {
            let run = release((model, angles), [lambda, delta], USUAL);
            let (sin, cos) = (FRAC_PI_2 - delta).sin_cos();
            let expected = -1.5 * GRAVITY * cos / (1.0 + 6.0 * lambda * sin * sin);
            for angle in angles {
                let found = run.value(&run.output(&format!("{angle}''")).unwrap(), 0.0);
                let place = format!("{model} at {lambda}, {delta:e}: {angle}");
                assert!((found / expected - 1.0).abs() < 1e-12, "{place}: {found:e}, not {expected:e}");
            }
        }
    }
}

/// A rounding of one half of the start: left and right part as (2/δ)^(σₐ/σₛ), the growth of the
/// antisymmetric motion during the fall, whatever the method.
#[test]
fn halves_part_as_roundings_grow() {
    for (lambda, delta) in [(0.5_f64, 1e-2), (0.5, 1e-4), (0.5, 1e-6), (0.75, 1e-3), (0.9, 1e-2)] {
        let upright: f64 = FRAC_PI_2 - delta;
        let ratio = ((1.0 / 3.0 + 2.0 * lambda) / (1.0 / 12.0 + lambda - lambda * lambda)).sqrt();
        // Half of a difference is antisymmetric.
        let expected = 0.5 * (upright.next_up() - upright) * (2.0 / delta).powf(ratio);
        for method in [MethodId::Taylor, MethodId::Radau, MethodId::Dop853] {
            let halves = [("phi_ab", upright), ("phi_bc", upright)];
            let others = [("phi_cd", upright.next_up()), ("phi_de", upright.next_up())];
            let angles = halves.into_iter().chain(others);
            let run = release_from("zigzag-full", lambda, angles, (method, 1e-12));
            let opens = run.events()[1].t;
            let [left, right] =
                ["phi_bc", "phi_cd"].map(|angle| run.value(&run.output(angle).unwrap(), opens));
            // The rates change while the bars fall.
            let part = (left - right).abs() / expected;
            assert!((0.2..3.0).contains(&part), "{lambda}, {delta:e}, by {}: {part}", method.name());
        }
    }
}

/// When the bars, released at φ = π/2 − δ, have fallen to φ = π/2 − ψ, with every foot on the
/// floor: by energy φ̇² (1/3 + 2 λ sin² φ) l² = g l (cos δ − cos ψ), and Simpson's rule over u, ψ =
/// δ cosh u.
fn compute_fall(lambda: f64, delta: f64, to: f64) -> f64 {
    const PARTS: usize = 4000;
    let end = (to / delta).acosh();
    let slowness = |k: usize| {
        let psi = delta * (end * k as f64 / PARTS as f64).cosh();
        let inertia = 1.0 / 3.0 + 2.0 * lambda * psi.cos().powi(2);
        // sin ½(ψ − δ) in parts of ψ − δ, for dψ = √(ψ − δ) √(ψ + δ) du.
        let below = if psi > delta { (0.5 * (psi - delta)).sin() / (psi - delta) } else { 0.5 };
        (inertia * (psi + delta) / (2.0 * GRAVITY * (0.5 * (psi + delta)).sin() * below)).sqrt()
    };
    let weight = |k: usize| if k == 0 || k == PARTS { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
    end / (3.0 * PARTS as f64) * (0..=PARTS).map(|k| weight(k) * slowness(k)).sum::<f64>()
}

/// What grows from far below the tolerance grows by every method as it does.
#[test]
fn every_method_falls_as_long() {
    for (model, angles) in ANGLES.into_iter().filter(|(model, _)| *model != "zigzag-thread") {
        for lambda in [0.05, 0.25, 0.5, 0.9] {
            for delta in [1e-4, 1e-9, 5e-13, 1e-13] {
                // π/2 to all digits.
                let exact = (FRAC_PI_2 - delta).cos();
                for method in MethodId::ALL {
                    for tolerance in [1e-4, 1e-6, 1e-9] {
                        let run = release((model, angles), [lambda, delta], (method, tolerance));
                        let opens = &run.events()[1];
                        let place =
                            format!("{model} at {lambda}, {delta:e}, by {}, {tolerance:e}", method.name());
                        assert_eq!(opens.kind, EventKind::Open, "{place}");
                        let phi = run.value(&run.output(angles[0]).unwrap(), opens.t);
                        let expected = compute_fall(lambda, exact, FRAC_PI_2 - phi);
                        let error = (opens.t - expected).abs();
                        // Some steps of the tolerance, and roundings of π/2 beside δ.
                        let bound = expected * (30.0 * tolerance + 1e-6 + 10.0 * f64::EPSILON / delta);
                        assert!(error < bound, "{place}: after {}, not {expected}", opens.t);
                    }
                }
            }
        }
    }
}

/// By its own equations and decisions the judge finds the same motion.
#[test]
fn the_judge_agrees() {
    for (model, angles) in ANGLES {
        for delta in [1e-2, 1e-8, 1e-10] {
            let run = release((model, angles), [0.75, delta], USUAL);
            let verdict = judge(&run, &[]);
            assert!(matches!(verdict, Verdict::Agrees { .. }), "{model} at {delta:e}: {verdict:?}");
        }
    }
}

/// Numbers between 0 and 1 that follow from a seed (Knuth's MMIX generator).
fn draw(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// Some tents side by side, each of two equal bars, AB and BC, CD and DE, whose feet are hinged to
/// those of the next, and factors of δ: the rows of all feet are one but for the cosines of the
/// bars' angles.
fn tents(count: usize, seed: &mut u64) -> (String, Vec<(String, f64)>) {
    let names: Vec<char> = ('A'..='Z').take(2 * count + 1).collect();
    let (mut text, mut figure, mut starts, mut x) =
        (String::new(), String::from("A = (0, 0)"), Vec::new(), 0.0);
    for points in names.windows(3).step_by(2) {
        let &[foot, top, next] = points else { continue };
        let (length, factor) = ((60.0 + 100.0 * draw(seed)).round() / 100.0, 0.5 + draw(seed));
        for bar in [format!("{foot}{top}"), format!("{top}{next}")] {
            text += &format!("#[bar({bar}, mass = {:.2}, length = {length})]\n", 0.5 + draw(seed));
            text += &format!("#[coordinate(phi_{} = angle({bar}), from = horizontal)]\n", starts.len());
            starts.push((format!("phi_{}", starts.len()), factor));
        }
        text += &format!("#[support({next} = floor)]\n#[support({top} = floor, stop)]\n");
        figure += &format!(
            ", {top} = ({:.4}, {:.4}), {next} = ({:.4}, 0)",
            x + 0.6 * length,
            0.8 * length,
            x + 1.2 * length
        );
        x += 1.2 * length;
    }
    let text = format!(
        "#[derive(BarSystem)]\n#[liftoff(dimensionless)]\n#[gravity(9.81)]\n#[support(A = floor)]\n{text}\
         #[coordinate(x = x(A))]\n#[coordinate(y = y(A))]\n#[figure({figure})]\nstruct Tents;"
    );
    (text, starts)
}

/// Of any model whose contacts all but depend on each other the judge finds the same motion. While
/// all feet stand, reactions and angles per δ are those of any other small δ.
#[test]
fn random_tents_fall_as_the_judge_finds() {
    const LIMIT: f64 = 0.3;
    let mut seed = 50;
    for count in [2, 2, 2, 3, 3] {
        let (text, starts) = tents(count, &mut seed);
        let text: &str = text.leak();
        let fall = |delta: f64| {
            let mut spec = RunSpec::with(&[]).limit(LIMIT).tolerance(1e-9);
            let start = starts.iter().map(|(name, factor)| (name.clone(), FRAC_PI_2 - factor * delta));
            spec.start = start.chain(["x", "y"].map(|name| (name.to_owned(), 0.0))).collect();
            let run = embedded("tents", text, spec.clone()).run_by(RunOptions::by(MethodId::Auto), &spec);
            let run = run.unwrap_or_else(|error| panic!("{text} at {delta:e}: {error}"));
            let verdict = judge(&run, &[]);
            assert!(matches!(verdict, Verdict::Agrees { .. }), "{text} at {delta:e}: {verdict:?}");
            assert_eq!(run.events().len(), 2, "{text} at {delta:e}");
            let value = |name: &str, t: f64| run.value(&run.output(name).unwrap(), t);
            let feet = ('A'..='Z').step_by(2).take(count + 1).map(|foot| value(&format!("N({foot})"), 0.0));
            let angles = starts.iter().map(|(name, _)| (FRAC_PI_2 - value(name, LIMIT)) / delta);
            feet.chain(angles).collect::<Vec<f64>>()
        };
        let expected = fall(1e-4);
        for delta in [1e-5, 1e-7, 1.5e-8, 1e-8, 1e-9, 1e-10] {
            for (found, expected) in fall(delta).iter().zip(&expected) {
                let error = (found - expected).abs() / expected.abs();
                assert!(error < 1e-5, "{text} at {delta:e}: {found}, not {expected}");
            }
        }
    }
}
