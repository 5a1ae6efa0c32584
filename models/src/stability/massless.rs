//! Massless bars: well where the masses are definite on the motions that the joints leave, a named
//! error elsewhere.

use super::ratios::{pendulum, swing};
use super::reference::MPMATH;
use super::{run, run_unjudged};
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, last, touched};
use liftoff_verification::cases::{Case, Effort, expect};
use std::f64::consts::FRAC_PI_2;

const SINGULAR: &str = "singular: the mass matrix does not determine the accelerations";

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    vec![
        swing(
            "massless.cranks".into(),
            "parallelogram with massless cranks, one period of 1 rad".into(),
            [0.0, 1.0],
        ),
        swing(
            "massless.coupler".into(),
            "parallelogram with a massless coupler, one period of 1 rad".into(),
            [1.0, 0.0],
        ),
        upper(),
        lower(),
        outer(),
        inner(),
    ]
}

fn bars(m1: f64, m2: f64) -> RunSpec {
    RunSpec::with(&[("m1", m1), ("m2", m2), ("l", 1.0), ("g", 1.0)])
}

fn upper() -> Case {
    let spec = bars(0.0, 1.0).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 4");
    let scene = "unequal-pendulum, upper bar massless, t = 4";
    Case::numbers("massless.upper", scene, MPMATH, pendulum("inf"), move |by| {
        Ok(last(&run("unequal-pendulum", by, &spec)?))
    })
}

fn lower() -> Case {
    let spec = bars(1.0, 0.0).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 4");
    let scene = "unequal-pendulum, lower bar massless: nothing determines its motion";
    Case::refused("massless.lower", scene, SINGULAR, move |by| run("unequal-pendulum", by, &spec))
}

/// N_E = N_A = 0 all the time, and N_C touches zero at sin φ = ⅓: no foot leaves the floor.
fn outer() -> Case {
    let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
    let spec = bars(1.0, 0.0).start(&[("phi_inner", 1.5), ("phi_outer", 1.5)]).energy_of(&upright);
    let scene = "zigzag, outer bars massless, held up by the floor alone";
    // N is within its bound of zero around its double root for some √1e-11.
    let expectations = vec![expect("φ", (1.0_f64 / 3.0).asin(), 5e-6)];
    Case::text_and_numbers("massless.outer", scene, "closed form", ("touch C", expectations), move |by| {
        let record = run_unjudged("zigzag", by, &spec)?;
        Ok((touched(&record), vec![event(&record, 0).state[0]]))
    })
}

fn inner() -> Case {
    let spec = bars(0.0, 1.0).start(&[("phi_inner", 0.8), ("phi_outer", 0.8)]);
    let scene = "zigzag, inner bars massless: det M ∝ sin² φ vanishes as they pass the horizontal in flight";
    Case::refused("massless.inner", scene, SINGULAR, move |by| run("zigzag", by, &spec))
}
