//! The A-frame with a spin: N/mg = ¼ − (3/2) s S + (9/4) s² per foot, s = sin φ, S = s + l φ̇²/3g =
//! 1 + ε, vanishes at s = (S ± √(S² − 1))/3 and has the minimum ¼ (1 − S²) between. Where a
//! tolerance does not resolve that minimum, the only honest answer is a touch that is not decided.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_verification::cases::event_summary::{event, first, touched};
use liftoff_verification::cases::{Case, Effort, Expectation, expect};

/// Below this a guard counts as zero, relative to the natural force: local errors of ten steps.
fn bound(tolerance: f64) -> f64 {
    10.0 * tolerance
}

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let mut cases = Vec::new();
    for tolerance in [1e-12, 1e-14] {
        for k in 1..=12 {
            let text = format!("1e-{k}");
            let excess: f64 = text.parse().unwrap_or(f64::NAN);
            // The two feet together, in weights of both bars: ¼ (S² − 1) ≈ ε/2.
            if excess / 2.0 > bound(tolerance) {
                cases.push(opening(&text, excess, tolerance));
                cases.push(second_root(&text, excess, tolerance));
            } else {
                cases.push(touch(&text, excess, tolerance, "touch A, B (undecided)"));
            }
        }
        cases.push(touch("0", 0.0, tolerance, "touch A, B"));
    }
    cases
}

/// On the way down at sin φ = s, with S = 1 + ε.
fn spec(s: f64, excess: f64, tolerance: f64) -> RunSpec {
    let start = s.asin();
    let spin = (3.0 * (1.0 + excess - start.sin())).sqrt();
    RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", start), ("phi'", -spin)])
        .until("phi = 0.1")
        .tolerance(tolerance)
}

fn id(what: &str, excess: &str, tolerance: f64) -> (String, String) {
    (
        format!("feet.{what} eps={excess} tol={tolerance:e}"),
        format!("a-frame, S = 1 + {excess}, tolerance {tolerance:e}"),
    )
}

/// The error of an angle where N falls through zero: slope (9/4) (s₁ − s₂) cos φ ≈ 1.4 √(2ε).
fn within(excess: f64, tolerance: f64) -> f64 {
    bound(tolerance) / (2.0 * excess).sqrt()
}

fn opening(text: &str, excess: f64, tolerance: f64) -> Case {
    let (id, scene) = id("opens", text, tolerance);
    let mut expectations =
        vec![expect("φ", reference(&format!("a-frame.open[{text}]")), within(excess, tolerance))];
    expectations.extend(landing(text, excess, tolerance));
    let landed = expectations.len() > 1;
    let spec = spec(0.9, excess, tolerance);
    Case::text_and_numbers(
        id,
        scene,
        "closed form; landing by 40-digit quadrature",
        ("open A, B", expectations),
        move |by| {
            let record = run("a-frame", by, &spec)?;
            let angles = [Some(0), landed.then_some(1)].into_iter().flatten();
            Ok((first(&record), angles.map(|place| event(&record, place).state[0]).collect()))
        },
    )
}

/// Where the feet land again, after twice the time in which they would not push: as far off as the
/// time of the opening. Feet that rise by more than √ε land where their gap is zero, up to its
/// rounding, with a slope of some 1.5 ε^(3/2). At ε = 0.1 the run ends before.
fn landing(text: &str, excess: f64, tolerance: f64) -> Option<Expectation> {
    let phi = reference(&format!("a-frame.land[{text}]"));
    let rounded =
        if excess * excess / 4.0 > f64::EPSILON.sqrt() { f64::EPSILON / excess.powf(1.5) } else { 0.0 };
    (excess < 0.1).then(|| expect("φ of landing", phi, 4.0 * within(excess, tolerance) + rounded))
}

/// Held feet, started where N is least: the other root.
fn second_root(text: &str, excess: f64, tolerance: f64) -> Case {
    let (id, scene) = id("pushes again", text, tolerance);
    let sum = 1.0 + excess;
    let root = ((sum - (sum * sum - 1.0).sqrt()) / 3.0).asin();
    let mut spec = spec(sum / 3.0, excess, tolerance).hold(&["A"]).until("N(A) > 0");
    spec.until.reverse();
    let least = 0.25 * (1.0 - sum * sum);
    let expectations =
        vec![expect("φ", root, within(excess, tolerance)), expect("N/mg at first", least, 1e-15)];
    Case::numbers(id, scene + ", held, from where N is least", "closed form", expectations, move |by| {
        let record = run("a-frame", by, &spec)?;
        let bearing = record.function("N(A)")?;
        Ok(vec![event(&record, 0).state[0], bearing(0.0)])
    })
}

fn touch(text: &str, excess: f64, tolerance: f64, outcome: &str) -> Case {
    let (id, scene) = id("touches", text, tolerance);
    // N is within its bound of zero for |s − ⅓| < √(4/9 · bound).
    let expectations = vec![expect("φ", (1.0_f64 / 3.0).asin(), (0.5 * bound(tolerance) + excess).sqrt())];
    let spec = spec(0.9, excess, tolerance);
    let source = if excess == 0.0 { "closed form" } else { MPMATH };
    Case::text_and_numbers(id, scene, source, (outcome, expectations), move |by| -> Result<_, MotionError> {
        let record = run("a-frame", by, &spec)?;
        let outcome = if excess == 0.0 { touched(&record) } else { first(&record) };
        Ok((outcome, vec![event(&record, 0).state[0]]))
    })
}
