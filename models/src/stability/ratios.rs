//! Masses that differ by twelve orders of magnitude.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, first, last};
use liftoff_verification::cases::{Case, Effort, Expectation, expect};
use std::f64::consts::FRAC_PI_2;

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let ratios = ["1e-12", "1e12"];
    let couplers = ratios.map(coupler);
    let lower = ratios.map(lower);
    let outer = [outer("1e-12", "A, E"), outer("1e12", "C")];
    couplers.into_iter().chain(lower).chain(outer).collect()
}

/// Masses of this ratio, the heavier one 1.
fn masses(ratio: &str) -> [f64; 2] {
    if ratio == "1e-12" { [1.0, 1e-12] } else { [1e-12, 1.0] }
}

/// The parallelogram swings as a pendulum of the length l (⅔ m + c)/(m + c).
pub(super) fn swing(id: String, scene: String, [m, c]: [f64; 2]) -> Case {
    let length = (2.0 / 3.0 * m + c) / (m + c);
    let period = reference("pendulum.period[1 rad]") * length.sqrt();
    // A relative error of the tolerance in each of some hundred steps.
    let expectations = vec![expect("φ", 1.0, 1e-10), expect("φ'", 0.0, 1e-10)];
    let spec = RunSpec::with(&[("m", m), ("l", 1.0), ("c", c), ("d", 2.0), ("g", 1.0)])
        .start(&[("phi", 1.0)])
        .until(&format!("t = {period}"));
    Case::numbers(id, scene, "elliptic integral", expectations, move |by| {
        let state = last(&run("parallelogram", by, &spec)?);
        Ok(vec![state[0], state[3]])
    })
}

fn coupler(ratio: &str) -> Case {
    let scene = format!("parallelogram, coupler {ratio} times as heavy as a crank, one period of 1 rad");
    swing(format!("ratios.coupler/crank={ratio}"), scene, masses(ratio))
}

fn lower(ratio: &str) -> Case {
    let [m1, m2] = masses(ratio);
    let spec = RunSpec::with(&[("m1", m1), ("m2", m2), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi_1", 1.0), ("phi_2", 0.5)])
        .until("t = 4");
    let scene = format!("unequal-pendulum, lower bar {ratio} times as heavy as the upper, t = 4");
    Case::numbers(format!("ratios.lower/upper={ratio}"), scene, MPMATH, pendulum(ratio), move |by| {
        Ok(last(&run("unequal-pendulum", by, &spec)?))
    })
}

/// The state of the unequal pendulum at t = 4; errors of the tolerance grow by some hundred.
pub(super) fn pendulum(ratio: &str) -> Vec<Expectation> {
    ["phi_1", "phi_2", "phi_1'", "phi_2'"]
        .map(|name| expect(name, reference(&format!("unequal-pendulum.{name}[{ratio}]")), 1e-9))
        .into()
}

fn outer(ratio: &str, opens: &str) -> Case {
    let [m1, m2] = masses(ratio);
    let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
    let open = opens.split(',').next().unwrap_or_default();
    let spec = RunSpec::with(&[("m1", m1), ("m2", m2), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi_inner", 1.56), ("phi_outer", 1.56)])
        .energy_of(&upright)
        .until(&format!("gap({open}) > 1e-9"));
    let scene = format!("zigzag, outer bars {ratio} times as heavy as the inner ones, until {opens} open");
    let expectations = vec![expect("φ", reference(&format!("zigzag.open[{ratio}]")), 1e-10)];
    let outcome = format!("open {opens}");
    Case::text_and_numbers(
        format!("ratios.outer/inner={ratio}"),
        scene,
        MPMATH,
        (&outcome, expectations),
        move |by| {
            let record = run("zigzag", by, &spec)?;
            Ok((first(&record), vec![event(&record, 0).state[0]]))
        },
    )
}
