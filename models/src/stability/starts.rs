//! Fig. 1a from rest at φ₀: V ∝ −φ³, so that the fall takes 0.99149/√φ₀ − 0.53719 natural times; φ₀ =
//! 0 never moves.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, first};
use liftoff_verification::cases::{Case, Effort, expect};

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let level = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]).start(&[("phi", 0.0)]);
    let equilibrium =
        Case::refused("starts.phi0=0", "falling-pair at rest at φ = 0", "equilibrium", move |by| {
            run("falling-pair", by, &level)
        });
    (1..=12).map(|k| case(&format!("1e-{k}"))).chain([equilibrium]).collect()
}

fn case(start: &str) -> Case {
    let [phi, t] = ["lift-off", "time"].map(|what| reference(&format!("falling-pair.{what}[{start}]")));
    let given: f64 = start.parse().unwrap_or(f64::NAN);
    // Errors per step are relative to one radian; of φ near its start they shift the time by ½ t/φ₀
    // each.
    let tolerance = (1e-10 * given).clamp(1e-15, 1e-12);
    let within = t * (10.0 * tolerance / given).max(1e-10);
    // Of φ at the lift-off, that and the rounding of t, φ̇ < 1.
    let expectations = vec![expect("φ", phi, 1e-11 + f64::EPSILON * t), expect("t", t, within)];
    let scene = format!("falling-pair from rest at φ = {start}, tolerance {tolerance:.0e}");
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", given)])
        .until("gap(P) > 0.01")
        .tolerance(tolerance)
        .limit(2.0 * t);
    Case::text_and_numbers(
        format!("starts.phi0={start}"),
        scene,
        MPMATH,
        ("open P, Q", expectations),
        move |by| {
            let record = run("falling-pair", by, &spec)?;
            let open = event(&record, 0);
            Ok((first(&record), vec![open.state[0], open.t]))
        },
    )
}
