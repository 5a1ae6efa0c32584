//! A bob on an axial spring in place of a rigid rod, k in mg/l, from rest at 60° on the slow manifold
//! r = l + (mg/k)(3 cos φ − 2 cos 60°). On it φ̇² = (2g/l) C (1 − (cos 60° + 15 C/2)/k), C = cos φ − cos 60°: the period
//! is T₀ (1 + c/k), so that after T₀ the bob is short of its turning point by c T₀/k in time. What is left out is of
//! order k^(−3/2), of which critical damping takes 27 k^(−3/2) mgl from the energy.

use super::Effort;
use super::answer::{at_most, want};
use super::case::Case;
use super::reference::reference;
use super::story::{last, run};
use crate::scene::Setup;
use std::f64::consts::FRAC_PI_3;

const SOURCE: &str = "elliptic integral, first order in 1/k";
/// Stiffness up to which an explicit method is asked: its steps are bounded by stability, some √k a period.
const EXPLICIT: f64 = 1e6;

pub(super) fn cases(_: Effort) -> Vec<Case> {
    let mut cases = Vec::new();
    for k in [1e6, 1e8, 1e10, 1e12] {
        for damped in [true, false] {
            if k <= EXPLICIT {
                cases.push(period(k, damped));
            }
        }
    }
    cases
}

/// From rest at 60°.
fn setup(k: f64, damped: bool, period: f64) -> Setup {
    let length = 1.0 + FRAC_PI_3.cos() / k;
    let damping = if damped { 2.0 * k.sqrt() } else { 0.0 };
    Setup::with(&[("m", 1.0), ("k", k), ("l", 1.0), ("c", damping), ("g", 1.0)])
        .start(&[("x", length * FRAC_PI_3.sin()), ("y", length * FRAC_PI_3.cos())])
        .until(&format!("t = {period}"))
}

fn period(k: f64, damped: bool) -> Case {
    let (period, lengthening) = (reference("pendulum.period[60]"), reference("spring.lengthening[60]"));
    // Before the turning point by δ: φ̇ = (g/l) sin 60° δ, φ = 60° − ½ (g/l) sin 60° δ².
    let early = lengthening * period / k;
    let rate = FRAC_PI_3.sin() * early;
    let angle = FRAC_PI_3 - 0.5 * FRAC_PI_3.sin() * early * early;
    let name = if damped { "critically damped" } else { "undamped" };
    let scene = format!("spring-pendulum, k = {k:e} mg/l, {name}, amplitude 60°, one period");
    let setup = setup(k, damped, period).tolerance(1e-6);
    let wants = vec![want("φ", angle, 1e-5), want("φ'", rate, 1e-5), at_most("steps", 2500.0)];
    Case::numbers(format!("springs.k={k:e} {name}"), scene, SOURCE, wants, move || {
        let record = run("spring-pendulum", &setup)?;
        let state = last(&*record);
        let [x, y, u, v] = [state[0], state[1], state[2], state[3]];
        let rate = (u * y - v * x) / (x * x + y * y);
        Ok(vec![x.atan2(y), rate, record.statistics().steps as f64])
    })
}
