//! Closed loops whose bars come into one line: there the constraints lose rank and other branches
//! begin.

use super::run;
use liftoff::LoggedDecision;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{drift, last, logged};
use liftoff_verification::cases::{Case, Effort, Expectation, at_most, expect};
use std::f64::consts::PI;

pub(super) fn cases(_: MethodId, effort: Effort) -> Vec<Case> {
    let turns = if effort == Effort::Full { 100 } else { 3 };
    vec![parallelogram(3), parallelogram(turns + 1), four_bars(turns)]
}

/// φ̇² = φ̇₀² − 2 (m + c) g (1 − cos φ)/(l (⅔ m + c)) with φ from below; in line twice a turn.
fn parallelogram(turns: u32) -> Case {
    let end = 2.0 * PI * f64::from(turns) + 0.5;
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("c", 1.0), ("d", 2.0), ("g", 1.0)])
        .start(&[("phi", 0.0), ("phi'", 3.0)])
        .until(&format!("phi = {end}"));
    let rate = (9.0 - 2.0 * 2.0 / (5.0 / 3.0) * (1.0 - 0.5_f64.cos())).sqrt();
    let expectations = passages(rate, turns, vec![expect("tilt", 0.0, 1e-10)]);
    let scene = format!("parallelogram, {turns} turns");
    Case::numbers(
        format!("loops.parallelogram, {turns} turns"),
        scene,
        "closed form",
        expectations,
        move |by| {
            let record = run("parallelogram", by, &spec)?;
            let state = last(&record);
            Ok(vec![
                state[3],
                state[1] - state[0],
                logged(&record, &LoggedDecision::SingularPosition) as f64,
                drift(&record, "E")?,
                state[2],
            ])
        },
    )
}

/// IFToMM's benchmark A02: φ̇² = φ̇₀² + 2g (3/2 + 2)(1 − cos φ)/(l (3/3 + 2)) with φ from above.
fn four_bars(turns: u32) -> Case {
    let end = 2.0 * PI * f64::from(turns) + 0.5;
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", 0.0), ("phi'", 1.0)])
        .until(&format!("phi = {end}"));
    let rate = (1.0 + 2.0 * 3.5 / 3.0 * (1.0 - 0.5_f64.cos())).sqrt();
    let expectations = passages(rate, turns, vec![expect("ψ", 0.0, 1e-10)]);
    let scene = format!("n-four-bar (benchmark A02), {turns} turns");
    Case::numbers(format!("loops.four bars, {turns} turns"), scene, "closed form", expectations, move |by| {
        let record = run("n-four-bar", by, &spec)?;
        let state = last(&record);
        let crossed = logged(&record, &LoggedDecision::SingularPosition) as f64;
        Ok(vec![state[5], state[1] - state[0], crossed, drift(&record, "E")?, state[3]])
    })
}

/// Rate, difference of the cranks, passages, energy; each passage costs some tolerances.
fn passages(rate: f64, turns: u32, more: Vec<Expectation>) -> Vec<Expectation> {
    let within = 1e-11 * f64::from(turns.max(10));
    let common = [
        expect("φ'", rate, within),
        at_most("difference of the cranks", 1e-10),
        expect("passages", f64::from(2 * turns), 0.0),
        at_most("drift of E in mgl", within),
    ];
    common.into_iter().chain(more).collect()
}
