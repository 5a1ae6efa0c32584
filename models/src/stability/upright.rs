//! Fig. 1b from rest at φ = π/2 − δ, where the gap rows of its feet differ by cos φ alone. With s =
//! sin φ the bars begin to fall with φ″ = −(3/2) (g/l) cos φ/(1 + 6 λ s²), and A and E take ½ λ g −
//! λ l φ″ (s² − 1/6)/cos φ each, C the rest of 2 g + l φ″ cos φ.

use core::f64::consts::FRAC_PI_2;

use super::{run, run_unjudged};
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_verification::cases::event_summary::event_summary;
use liftoff_verification::cases::{Case, Effort, expect};

/// Below this the doubles of the angles tell δ so badly that the judge's motion from them is
/// another.
const TOLD: f64 = 1e-10;

pub(super) fn cases(_: MethodId, effort: Effort) -> Vec<Case> {
    let far = (1..=15).map(|k| case(&format!("1e-{k}"), 0.5));
    let shares = if effort == Effort::Full { &[0.05, 0.1, 0.25, 0.75, 0.9][..] } else { &[0.1, 0.75] };
    let others = shares.iter().flat_map(|&share| ["1e-2", "1e-5", "1e-8"].map(|text| case(text, share)));
    far.chain(others).collect()
}

/// The feet lift off by the share of the outer bars: all at once where it is a quarter.
fn order(lambda: f64) -> &'static str {
    match lambda {
        x if x < 0.25 => "open A, E; open C; close B, D",
        0.25 => "open A, C, E; close B, D",
        _ => "open C; open A, E; close B, D",
    }
}

fn case(text: &str, lambda: f64) -> Case {
    let g = 9.81;
    let delta: f64 = text.parse().unwrap_or(f64::NAN);
    let phi = FRAC_PI_2 - delta;
    let square = phi.sin().powi(2);
    // −φ″/cos φ
    let fall = 1.5 * g / (1.0 + 6.0 * lambda * square);
    let foot = lambda * (0.5 * g + fall * (square - 1.0 / 6.0));
    let middle = 2.0 * g - fall * phi.cos().powi(2) - 2.0 * foot;
    let expectations = vec![expect("N(A)", foot, 1e-8), expect("N(C)", middle, 1e-8)];
    let spec = RunSpec::with(&[("m1", 1.0 - lambda), ("m2", lambda), ("l", 1.0), ("g", g)])
        .start(&[("phi_inner", phi), ("phi_outer", phi), ("y", 0.0)])
        .tolerance(1e-9)
        .limit(60.0);
    Case::text_and_numbers(
        format!("dependent.δ={text} λ={lambda}"),
        format!("zigzag from rest at φ = π/2 − {text}, {lambda} of the mass outside"),
        "closed form",
        (order(lambda), expectations),
        move |by| {
            let record = match delta >= TOLD {
                true => run("zigzag", by, &spec)?,
                false => run_unjudged("zigzag", by, &spec)?,
            };
            let start = |name: &str| Ok::<f64, MotionError>(record.function(name)?(0.0));
            Ok((event_summary(&record), vec![start("N(A)")?, start("N(C)")?]))
        },
    )
}
