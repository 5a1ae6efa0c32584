//! Contacts with dry friction.

use super::DefaultRun;
use liftoff_studio::RunSpec;
use std::f64::consts::PI;

pub(super) const RUNS: &[DefaultRun] = &[
    ("belt", belt),
    ("slipping-rod", slipping_rod),
    ("slipping-ladder", slipping_ladder),
    ("painleve", painleve),
    ("rimless-wheel", rimless_wheel),
    ("woodpecker", woodpecker),
];

fn belt() -> RunSpec {
    let parameters =
        [("m", 1.0), ("l", 1.0), ("k", 20.0), ("mu", 0.2), ("mu_s", 0.5), ("w", 0.3), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("x", 0.0), ("x'", 0.3)]).until("t = 5")
}

fn slipping_ladder() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("mu", 0.3), ("nu", 0.3), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 50.0 * PI / 180.0)]).until("phi = 0")
}

fn slipping_rod() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("mu", 0.3), ("g", 9.81)];
    // From rest upright φ̇² = (6 g/l) sin² ½φ.
    let (phi, rate) = (1e-2_f64, (6.0 * 9.81_f64).sqrt());
    let start = [("phi", phi), ("phi'", rate * (0.5 * phi).sin()), ("x'", 0.0)];
    RunSpec::with(&parameters).start(&start).until("phi = pi/2")
}

fn painleve() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("mu", 1.6), ("e", 0.0), ("g", 9.81)];
    let start = [("theta", PI / 3.0), ("x'", -3.0), ("theta'", 0.0)];
    RunSpec::with(&parameters).start(&start).until("t = 0.6")
}

fn rimless_wheel() -> RunSpec {
    let parameters = [("m", 1.0), ("j", 0.1), ("l", 1.0), ("gamma", 0.2), ("mu", 1.5), ("g", 9.81)];
    // On both feet A and F, it turns about A.
    let (phi, rate) = (-0.2, -2.0);
    let [across, up] = [rate * (phi - PI / 3.0_f64).sin(), -rate * (phi - PI / 3.0_f64).cos()];
    let start = [("phi", phi), ("phi'", rate), ("x'", across), ("y'", up)];
    RunSpec::with(&parameters).start(&start).until("t = 5")
}

fn woodpecker() -> RunSpec {
    let masses = [("m_sleeve", 3e-4), ("j_sleeve", 5e-9), ("m_bird", 4.5e-3), ("j_bird", 7e-7)];
    let lengths = [("r_pole", 2.5e-3), ("r", 3.1e-3), ("h", 5.8e-3), ("a", 0.01), ("b", 0.015)];
    let beak = [("d", 0.0201), ("s", 0.02), ("c", 5.6e-3), ("mu", 0.3), ("e", 0.5), ("g", 9.81)];
    let parameters: Vec<(&str, f64)> = masses.into_iter().chain(lengths).chain(beak).collect();
    let start = [("phi", -0.1), ("psi", -0.28), ("y'", -0.34), ("phi'", 0.0), ("psi'", -7.5)];
    RunSpec::with(&parameters).start(&start).until("t = 1")
}
