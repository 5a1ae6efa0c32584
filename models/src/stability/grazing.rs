//! Guards that come near zero, touch it, or pass it by a little.
//!
//! - A marble in an upright ring, started below with v² = (5 + δ) g r, presses on the top with δ m
//!   g; with less than none it leaves where its height over the centre is (1 + δ/3) r.
//! - A bar that turns without gravity about its centre, ½ + δ/2 over the floor: the lower end comes
//!   as near as δ/2, or strikes where sin φ = 1 + δ.

use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, first, touched};
use liftoff_verification::cases::{Case, Effort, expect};

const MARGINS: [&str; 5] = ["1e-1", "1e-3", "1e-5", "1e-7", "1e-9"];
const CLOSED: &str = "closed form";

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let signed = |case: fn(&str, f64) -> Case| {
        MARGINS.iter().flat_map(move |text| {
            let margin: f64 = text.parse().unwrap_or(f64::NAN);
            [case(text, margin), case(&format!("-{text}"), -margin)]
        })
    };
    signed(ring).chain([ring("0", 0.0)]).chain(signed(bar)).chain([bar("0", 0.0)]).collect()
}

fn ring(text: &str, margin: f64) -> Case {
    let spec = RunSpec::with(&[("m", 1.0), ("r", 1.0), ("g", 1.0)])
        .start(&[("x", 0.0), ("y", -1.0), ("x'", (5.0 + margin).sqrt())])
        .until("t = 3");
    let (outcome, expectations) = match margin {
        // Around the top, where N = 3 (1 + δ/3 − y): the energy's error.
        _ if margin < 0.0 => ("open P", vec![expect("y", 1.0 + margin / 3.0, 1e-11)]),
        // Flat: y = 1 − (x²/2), so that N is within its bound for some √bound around.
        0.0 => ("touch P", vec![expect("y", 1.0, 1e-10)]),
        _ => ("stop", vec![]),
    };
    let scene = format!("looping, v² = (5 + δ) g r, δ = {text}");
    Case::text_and_numbers(
        format!("grazing.ring delta={text}"),
        scene,
        CLOSED,
        (outcome, expectations.clone()),
        move |by| {
            let record = run("looping", by, &spec)?;
            let outcome = if margin == 0.0 { touched(&record) } else { first(&record) };
            Ok((outcome, expectations.iter().map(|_| event(&record, 0).state[1]).collect()))
        },
    )
}

fn bar(text: &str, margin: f64) -> Case {
    let (phi, height) = (0.5_f64, 0.5 * (1.0 + margin));
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 0.0), ("e", 0.5)])
        .start(&[
            ("phi", phi),
            ("y", height - 0.5 * phi.sin()),
            ("x", 0.0),
            ("phi'", 1.0),
            ("y'", -0.5 * phi.cos()),
            ("x'", 0.5 * phi.sin()),
        ])
        .until("t = 2");
    let (outcome, expectations) = match margin {
        // The gap falls with the slope ½ cos φ = ½ √(−2δ); its bound is ten tolerances.
        _ if margin < 0.0 => {
            ("impact A", vec![expect("φ", (1.0 + margin).asin(), 2e-11 / (-2.0 * margin).sqrt())])
        }
        0.0 => ("touch A", vec![expect("φ", 1.0_f64.asin(), 1e-5)]),
        _ => ("stop", vec![]),
    };
    let scene =
        format!("bouncing-bar turning without gravity, centre (1 + δ) l/2 above the floor, δ = {text}");
    Case::text_and_numbers(
        format!("grazing.gap delta={text}"),
        scene,
        CLOSED,
        (outcome, expectations.clone()),
        move |by| {
            let record = run("bouncing-bar", by, &spec)?;
            let outcome = if margin == 0.0 { touched(&record) } else { first(&record) };
            Ok((outcome, expectations.iter().map(|_| event(&record, 0).state[0]).collect()))
        },
    )
}
