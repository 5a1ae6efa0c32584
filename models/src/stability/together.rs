//! Contacts that act within one rounding of each other are one event.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, first};
use liftoff_verification::cases::{Case, Effort, expect};
use std::f64::consts::FRAC_PI_2;

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    vec![quarter(), corners(0.0), corners(f64::EPSILON), ends(0), ends(1), ends(-1)]
}

/// λ = ¼: N_C = 6 N_E at every angle, all three vanish at once.
fn quarter() -> Case {
    let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
    let spec = RunSpec::with(&[("m1", 0.75), ("m2", 0.25), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi_inner", 1.56), ("phi_outer", 1.56)])
        .energy_of(&upright);
    let expectations = vec![expect("φ", reference("zigzag.open[1/3]"), 1e-11)];
    let scene = "zigzag, λ = 1/4: three reactions vanish in one instant";
    Case::text_and_numbers("together.zigzag", scene, MPMATH, ("open A, C, E", expectations), move |by| {
        let record = run("zigzag", by, &spec)?;
        Ok((first(&record), vec![event(&record, 0).state[0]]))
    })
}

/// Fig. 1a without symmetry, one bar ahead by this.
fn corners(ahead: f64) -> Case {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi_left", 0.1), ("phi_right", 0.1 * (1.0 + ahead))])
        .until("gap(P) > 0.01");
    let [phi, t] = ["lift-off", "time"].map(|what| reference(&format!("falling-pair.{what}[1e-1]")));
    let expectations =
        vec![expect("φ left", phi, 1e-10), expect("φ right", phi, 1e-10), expect("t", t, 1e-10)];
    let scene = format!("falling-pair-full, one bar ahead by {ahead:.0e} of its angle");
    Case::text_and_numbers(
        format!("together.corners ahead={ahead:.0e}"),
        scene,
        MPMATH,
        ("open P, Q", expectations),
        move |by| {
            let record = run("falling-pair-full", by, &spec)?;
            let open = event(&record, 0);
            Ok((first(&record), vec![open.state[0], open.state[1], open.t]))
        },
    )
}

/// A bar dropped all but level: B is higher by so many roundings of the height, and later by half
/// as many.
fn ends(roundings: i32) -> Case {
    let tilt = f64::from(roundings) * f64::EPSILON;
    let e = 0.5;
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0), ("e", e)])
        .start(&[("phi", tilt), ("y", 1.0), ("x", 0.0)])
        .until("t = 2");
    let (t, impulse) = (2.0_f64.sqrt(), 0.5 * (1.0 + e) * 2.0_f64.sqrt());
    let expectations = vec![
        expect("t", t, 1e-11),
        expect("impulse at A", impulse, 1e-11),
        expect("impulse at B", impulse, 1e-11),
    ];
    let scene = format!("bouncing-bar dropped level but for {roundings} roundings");
    Case::text_and_numbers(
        format!("together.ends roundings={roundings}"),
        scene,
        "closed form",
        ("impact A, B", expectations),
        move |by| {
            let record = run("bouncing-bar", by, &spec)?;
            let impact = event(&record, 0);
            let impulse =
                |end: &str| impact.impulses.iter().find(|r| r.label == end).map_or(f64::NAN, |r| r.value);
            Ok((first(&record), vec![impact.t, impulse("A"), impulse("B")]))
        },
    )
}
