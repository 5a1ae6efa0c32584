//! A slider–crank whose rod is hardly longer than its crank, l = r (1 + ε): at φ = π/2 it passes
//! near the position in which both lie on each other and the piston is free to stay at O.
//! sin ψ = −(r/l) sin φ, ψ̇ = −φ̇ r cos φ/(l cos ψ). Free, without gravity, T = ½ Θ(φ) φ̇² stays;
//! driven, φ = t.

use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{drift, last};
use liftoff_verification::cases::{Case, Effort, at_most, expect};

/// Behind φ = π/2, of which the other branch has ψ = −φ.
const END: f64 = 3.0;
const MASSES: [f64; 3] = [0.5, 0.25, 0.5];
/// Nearer than 1e-10 the tolerance on constraints does not tell the branches apart.
const NEAR: [&str; 5] = ["1e-2", "1e-4", "1e-6", "1e-8", "1e-10"];

pub(super) fn loops(_: MethodId, _: Effort) -> Vec<Case> {
    NEAR.map(free).into()
}

pub(super) fn drives(_: MethodId, _: Effort) -> Vec<Case> {
    NEAR.map(driven).into()
}

/// ψ and ψ̇/φ̇ at an angle of the crank of length 1.
fn rod(phi: f64, l: f64) -> [f64; 2] {
    let psi = -(phi.sin() / l).asin();
    [psi, -phi.cos() / (l * psi.cos())]
}

/// Θ: crank, rod, piston.
fn inertia(phi: f64, l: f64) -> f64 {
    let [crank, bar, piston] = MASSES;
    let [psi, turn] = rod(phi, l);
    let across = -phi.sin() - 0.5 * l * psi.sin() * turn;
    let slides = -phi.sin() - l * psi.sin() * turn;
    let turns = (l * turn).powi(2) / 12.0;
    crank / 3.0 + bar * (across.powi(2) + 0.25 * phi.cos().powi(2) + turns) + piston * slides.powi(2)
}

/// The length of the rod and the model with it.
fn spec(text: &str, more: &[(&str, f64)]) -> (f64, RunSpec) {
    let l = 1.0 + text.parse().unwrap_or(f64::NAN);
    let [a, b, c] = MASSES;
    (l, RunSpec::with(&[&[("a", a), ("b", b), ("c", c), ("r", 1.0), ("l", l)], more].concat()))
}

fn free(text: &'static str) -> Case {
    let (l, spec) = spec(text, &[]);
    let rate = (inertia(0.0, l) / inertia(END, l)).sqrt();
    let [psi, turn] = rod(END, l);
    let spec = spec.start(&[("phi", 0.0), ("psi", 0.0), ("phi'", 1.0)]).until(&format!("phi = {END}"));
    let expectations = vec![
        expect("ψ", psi, 1e-9),
        expect("φ'", rate, 1e-9),
        expect("ψ'", turn * rate, 1e-9),
        at_most("drift of E", 1e-9),
    ];
    let scene = format!("free slider–crank, l = r (1 + {text}), past the dead centre of both bars");
    Case::numbers(format!("near.ε={text}"), scene, "energy", expectations, move |by| {
        let record = run("free-crank", by, &spec)?;
        let state = last(&record);
        Ok(vec![state[1], state[2], state[3], drift(&record, "E")?])
    })
}

fn driven(text: &'static str) -> Case {
    let (l, spec) = spec(text, &[("omega", 1.0)]);
    let [psi, turn] = rod(END, l);
    let spec = spec.start(&[("phi", 0.0), ("psi", 0.0)]).until(&format!("t = {END}"));
    let expectations = vec![expect("φ", END, 1e-11), expect("ψ", psi, 1e-9), expect("ψ'", turn, 1e-9)];
    let scene = format!("slider-crank, l = r (1 + {text}), driven past the dead centre of both bars");
    Case::numbers(format!("drives.ε={text}"), scene, "closed form", expectations, move |by| {
        let state = last(&run("slider-crank", by, &spec)?);
        Ok(vec![state[0], state[1], state[3]])
    })
}
