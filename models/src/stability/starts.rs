//! Fig. 1a from rest at φ₀: V ∝ −φ³, so that the fall takes 0.99149/√φ₀ − 0.53719 natural times; φ₀ = 0 never moves.

use super::Effort;
use super::answer::want;
use super::case::Case;
use super::reference::{MPMATH, reference};
use super::story::{event, first, run};
use crate::scene::Setup;

pub(super) fn cases(_: Effort) -> Vec<Case> {
    let level = Setup::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]).start(&[("phi", 0.0)]);
    let equilibrium =
        Case::refused("starts.phi0=0", "falling-pair at rest at φ = 0", "equilibrium", move || {
            run("falling-pair", &level)
        });
    (1..=12).map(|k| case(&format!("1e-{k}"))).chain([equilibrium]).collect()
}

fn case(start: &str) -> Case {
    let [phi, t] = ["lift-off", "time"].map(|what| reference(&format!("falling-pair.{what}[{start}]")));
    let scene = format!("falling-pair from rest at φ = {start}");
    // The angle is settled by the energy, within the tolerance and what is lost on the way; a start of relative
    // accuracy ε shifts the time by ½ t ε, and each of the many steps adds as much as the tolerance.
    let wants = vec![want("φ", phi, 1e-11), want("t", t, 1e-10 * t)];
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 1.0)];
    let given = start.parse().unwrap_or(f64::NAN);
    let setup = Setup::with(&parameters).start(&[("phi", given)]).until("gap(P) > 0.01").limit(2.0 * t);
    Case::told(format!("starts.phi0={start}"), scene, MPMATH, ("open P, Q", wants), move || {
        let record = run("falling-pair", &setup)?;
        let open = event(&*record, 0);
        Ok((first(&*record), vec![open.state[0], open.t]))
    })
}
