//! A bob on an axial spring in place of a rigid rod, k in mg/l, from rest at 60° on the slow
//! manifold r = l + (mg/k)(3 cos φ − 2 cos 60°). On it φ̇² = (2g/l) C (1 − (cos 60° + 15 C/2)/k), C =
//! cos φ − cos 60°: the period is T₀ (1 + c/k), so that after T₀ the bob is short of its turning
//! point by c T₀/k in time. What is left out is of order k^(−3/2), of which critical damping takes
//! 27 k^(−3/2) mgl from the energy.

use super::reference::reference;
use crate::models;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError, stopped};
use liftoff_verification::cases::{Case, Effort, Expectation, at_most, expect};
use std::f64::consts::FRAC_PI_3;

const SOURCE: &str = "elliptic integral, first order in 1/k";

/// Steps of a stiff method for one period, however stiff the spring.
const MOST: f64 = 2500.0;

pub(super) fn cases(by: MethodId, _: Effort) -> Vec<Case> {
    let bobs = |k: f64| [true, false].map(|damped| Bob { k, damped });
    if by == MethodId::Dop853 {
        // Stable for |h λ| ≤ 6, λ = √k.
        return bobs(1e6).map(|bob| swings(bob, 4.0 * period() * bob.k.sqrt())).into();
    }
    let all = [1e6, 1e8, 1e10, 1e12].map(bobs).concat();
    all.into_iter().map(|bob| swings(bob, MOST)).chain([rigid()]).collect()
}

/// A bob on its spring.
#[derive(Clone, Copy)]
struct Bob {
    k: f64,
    damped: bool,
}

impl Bob {
    fn name(self) -> String {
        let Self { k, damped } = self;
        format!("k={k:e} {}", if damped { "critically damped" } else { "undamped" })
    }

    fn scene(self, tolerance: f64) -> String {
        let Self { k, damped } = self;
        let damping = if damped { "critically damped" } else { "undamped" };
        format!(
            "spring-pendulum, k = {k:e} mg/l, {damping}, amplitude 60°, one period, tolerance {tolerance:.0e}"
        )
    }

    /// Before the turning point by δ: φ̇ = (g/l) sin 60° δ, φ = 60° − ½ (g/l) sin 60° δ².
    fn expectations(self, within: f64) -> Vec<Expectation> {
        let early = reference("spring.lengthening[60]") * period() / self.k;
        let rate = FRAC_PI_3.sin() * early;
        vec![expect("φ", FRAC_PI_3 - 0.5 * rate * early, within), expect("φ'", rate, within)]
    }

    /// φ, φ̇ after the rod's period, and the steps.
    fn swing(self, tolerance: f64, by: MethodId) -> Result<Vec<f64>, MotionError> {
        let Self { k, damped } = self;
        let length = 1.0 + FRAC_PI_3.cos() / k;
        let c = if damped { 2.0 * k.sqrt() } else { 0.0 };
        let start = [("x", length * FRAC_PI_3.sin()), ("y", length * FRAC_PI_3.cos())];
        let spec = RunSpec::with(&[("m", 1.0), ("k", k), ("l", 1.0), ("c", c), ("g", 1.0)]);
        let spec = spec.start(&start).limit(period()).tolerance(tolerance);
        let simulation = models().find("spring-pendulum")?.simulation(&spec)?.method(by);
        let run = simulation.observe(&mut ()).map_err(stopped)?;
        let [x, y, u, v] = run.final_state()[..] else { return Ok(Vec::new()) };
        let rate = (u * y - v * x) / (x * x + y * y);
        Ok(vec![x.atan2(y), rate, run.statistics().steps as f64])
    }
}

/// The period of the rod.
fn period() -> f64 {
    reference("pendulum.period[60]")
}

fn swings(bob: Bob, most: f64) -> Case {
    let expectations = [bob.expectations(1e-7), vec![at_most("steps", most)]].concat();
    Case::numbers(format!("springs.{}", bob.name()), bob.scene(1e-6), SOURCE, expectations, move |by| {
        bob.swing(1e-6, by)
    })
}

/// At k = 1e12 the spring differs from a rod by 1e-12.
fn rigid() -> Case {
    let bob = Bob { k: 1e12, damped: true };
    let expectations = vec![expect("φ", FRAC_PI_3, 1e-8), expect("φ'", 0.0, 1e-8)];
    Case::numbers("springs.rigid limit", bob.scene(1e-10), "elliptic integral", expectations, move |by| {
        Ok(bob.swing(1e-10, by)?[..2].to_vec())
    })
}
