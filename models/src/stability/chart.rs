//! Fig. 1a with held corners towards φ = π/2, where the chart y = (w/2) tan φ of the closed form
//! ends. Of both bars T = m φ̇² (y_C′² + (l²/4) sin² φ + l²/12), y_C = (w/2) tan φ − (l/2) sin φ, V =
//! −2 m g y_C; the corners are at the bars' ends where cos φ = w/2l.

use super::run;
use liftoff::LoggedDecision;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{drift, event, event_summary, logged};
use liftoff_verification::cases::{Case, Effort, at_most, expect};

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    ["0.2", "0.02", "0.002"].map(case).into()
}

fn case(text: &str) -> Case {
    let w: f64 = text.parse().unwrap_or(f64::NAN);
    let (start, spin) = (0.5_f64, 3.0);
    let drop = |phi: f64| 0.5 * (w * phi.tan() - phi.sin());
    let inertia = |phi: f64| {
        let slope = 0.5 * (w / phi.cos().powi(2) - phi.cos());
        slope * slope + phi.sin().powi(2) / 4.0 + 1.0 / 12.0
    };
    let end = (0.5 * w).acos();
    let kept = spin * spin * inertia(start) + 2.0 * (drop(end) - drop(start));
    let rate = (kept / inertia(end)).sqrt();
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("w", w), ("g", 1.0)])
        .start(&[("phi", start), ("phi'", spin)])
        .hold(&["P"])
        .until("t = 2");
    // The pivot is cos φ, and a closed form is left below 0.18 at a tolerance of 1e-12.
    let expectations = vec![
        expect("φ", end, 1e-11),
        expect("φ'", rate, 1e-10),
        expect("changes of form", 1.0, 0.0),
        at_most("drift of E in mgl", 1e-10),
    ];
    let scene = format!("narrow-gap, w = {text} l, corners held, until they slide off where cos φ = w/2l");
    Case::text_and_numbers(
        format!("chart.w={text}"),
        scene,
        "energy",
        ("slide-off P, Q; stop", expectations),
        move |by| {
            let record = run("narrow-gap", by, &spec)?;
            let off = event(&record, 0);
            let changes = logged(&record, &LoggedDecision::SmallPivot) as f64;
            Ok((event_summary(&record), vec![off.state[0], off.state[2], changes, drift(&record, "E")?]))
        },
    )
}
