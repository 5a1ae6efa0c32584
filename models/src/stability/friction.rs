//! Dry friction: a block that brakes, stick–slip on a belt, a rod at the border of Painlevé's
//! paradox.

use super::run;
use core::f64::consts::PI;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::{Case, Effort, expect};

const CLOSED: &str = "closed form";

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let braking = ["1e-14", "1e-6", "0.3", "50"].map(brakes);
    let belts = ["1e-2", "0.3", "3"].map(sticks_and_slips);
    let borders = ["1e-2", "1e-6", "1e-9"].map(borders);
    braking.into_iter().chain(belts).chain(borders).collect()
}

/// From v = 1 the block loses μ g t, and has come to rest at v²/(2 μ g) where that is one.
fn brakes(text: &str) -> Case {
    let mu: f64 = text.parse().unwrap_or(f64::NAN);
    let (end, lost) = (2.0, (2.0 * mu).min(1.0));
    let way = if lost < 1.0 { end - 0.5 * mu * end * end } else { 0.5 / mu };
    let spec = RunSpec::with(&[("m", 1.0), ("mu", mu), ("g", 1.0)])
        .start(&[("x", 0.0), ("y", 0.0), ("x'", 1.0)])
        .until(&format!("t = {end}"));
    let expectations = vec![expect("v lost", lost, 4.0 * f64::EPSILON), expect("x", way, 1e-11)];
    let scene = format!("block with v = 1 on a floor, friction {text}");
    Case::numbers(format!("friction.brakes μ={text}"), scene, CLOSED, expectations, move |by| {
        let state = run("block", by, &spec)?.final_state().to_vec();
        Ok(vec![1.0 - state[2], state[0]])
    })
}

/// It sticks until k x = μₛ m g, and slips as an oscillator about μ m g/k until it has the belt's
/// speed again: period (2 π − 2 β)/ω + 2 u/w with u = (μₛ − μ) m g/k, tan β = u ω/w. From the
/// middle of the sticking, ten periods.
fn sticks_and_slips(text: &str) -> Case {
    let w: f64 = text.parse().unwrap_or(f64::NAN);
    let (k, mu, mu_s) = (4.0_f64, 0.3, 0.5);
    let (omega, u) = (k.sqrt(), (mu_s - mu) / k);
    let period = (2.0 * PI - 2.0 * (u * omega / w).atan()) / omega + 2.0 * u / w;
    let middle = mu / k;
    let spec =
        RunSpec::with(&[("m", 1.0), ("l", 10.0), ("k", k), ("mu", mu), ("mu_s", mu_s), ("w", w), ("g", 1.0)])
            .start(&[("x", middle), ("y", 0.0), ("x'", w)])
            .tolerance(1e-12)
            .limit(10.0 * period);
    let expectations = vec![expect("x", middle, 1e-9), expect("x'", w, 1e-12)];
    let scene = format!("belt with speed {text}, ten periods of stick and slip");
    Case::numbers(format!("friction.belt w={text}"), scene, CLOSED, expectations, move |by| {
        let state = run("belt", by, &spec)?.final_state().to_vec();
        Ok(vec![state[0], state[2]])
    })
}

/// A uniform rod that slides to the left on its foot and else is at rest:
/// N (1 + 3 cos²θ − 3 μ sin θ cos θ) = m g. The factor is zero at the border; short of it by δ,
/// N = m g/(δ (1 + 3 cos²θ)).
fn borders(text: &str) -> Case {
    let delta: f64 = text.parse().unwrap_or(f64::NAN);
    let (sin, cos) = 1.0_f64.sin_cos();
    let whole = 1.0 + 3.0 * cos * cos;
    let mu = (1.0 - delta) * whole / (3.0 * sin * cos);
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("mu", mu), ("e", 0.0), ("g", 1.0)])
        .start(&[("theta", 1.0), ("x", 0.0), ("y", 0.0), ("theta'", 0.0), ("x'", -1.0)])
        .limit(1e-3 * delta);
    // The factor is known to some roundings of its terms.
    let expectations = vec![expect("N δ (1 + 3 cos²θ)/(m g)", 1.0, 64.0 * f64::EPSILON / delta)];
    let scene = format!("painleve short of the paradox by {text}");
    Case::numbers(format!("friction.border δ={text}"), scene, CLOSED, expectations, move |by| {
        let record = run("painleve", by, &spec)?;
        Ok(vec![record.function("N(A)")?(0.0) * delta * whole])
    })
}
