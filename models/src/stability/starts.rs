//! Fig. 1a from rest at φ₀: V ∝ −φ³, so that the fall takes 0.99149/√φ₀ − 0.53719 natural times; φ₀ = 0 never moves.

use super::reference::{MPMATH, reference};
use crate::FallingPair;
use liftoff::catalog::{Integrator, run};
use liftoff::scene::Setup;
use liftoff::stability::Case;
use liftoff::stability::Effort;
use liftoff::stability::story::{event, first};
use liftoff::stability::want;

pub(super) fn cases(_: Integrator, _: Effort) -> Vec<Case> {
    let level = Setup::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]).start(&[("phi", 0.0)]);
    let equilibrium =
        Case::refused("starts.phi0=0", "falling-pair at rest at φ = 0", "equilibrium", move |by| {
            run::<FallingPair>(by, &level)
        });
    (1..=12).map(|k| case(&format!("1e-{k}"))).chain([equilibrium]).collect()
}

fn case(start: &str) -> Case {
    let [phi, t] = ["lift-off", "time"].map(|what| reference(&format!("falling-pair.{what}[{start}]")));
    let given: f64 = start.parse().unwrap_or(f64::NAN);
    // Errors per step are relative to one radian; of φ near its start they shift the time by ½ t/φ₀ each.
    let tolerance = (1e-10 * given).clamp(1e-15, 1e-12);
    let within = t * (10.0 * tolerance / given).max(1e-10);
    // Of φ at the lift-off, that and the rounding of t, φ̇ < 1.
    let wants = vec![want("φ", phi, 1e-11 + f64::EPSILON * t), want("t", t, within)];
    let scene = format!("falling-pair from rest at φ = {start}, tolerance {tolerance:.0e}");
    let setup = Setup::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", given)])
        .until("gap(P) > 0.01")
        .tolerance(tolerance)
        .limit(2.0 * t);
    Case::told(format!("starts.phi0={start}"), scene, MPMATH, ("open P, Q", wants), move |by| {
        let record = run::<FallingPair>(by, &setup)?;
        let open = event(&*record, 0);
        Ok((first(&*record), vec![open.state[0], open.t]))
    })
}
