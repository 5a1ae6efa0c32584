//! A rod that topples on a rough floor, m = l = 1, μ = 0.3, φ from the vertical.

use super::integrate;
use crate::GRAVITY;

/// μ.
pub const FRICTION: f64 = 0.3;

/// Rates of φ and of its rate while the foot sticks: ⅓ φ̈ = ½ g sin φ.
pub fn stick(&[phi, w]: &[f64; 2]) -> [f64; 2] {
    [w, 1.5 * GRAVITY * phi.sin()]
}

/// Tangential and normal force on the foot that sticks.
pub fn forces(state: &[f64; 2]) -> [f64; 2] {
    let (s, c) = state[0].sin_cos();
    let [w, spin] = stick(state);
    [0.5 * (spin * c - w * w * s), GRAVITY - 0.5 * (spin * s + w * w * c)]
}

/// Rates of φ, the foot's x, and their rates while it slides one way (`sense` is the sign of ẋ), R
/// = −sense μ N: (1/12 + ¼ sin φ (sin φ + sense μ cos φ)) φ̈ = ½ (g − ½ φ̇² cos φ) (sin φ + sense μ
/// cos φ).
pub fn slide(sense: f64, &[phi, _, w, u]: &[f64; 4]) -> [f64; 4] {
    let (s, c) = phi.sin_cos();
    let arm = s + sense * FRICTION * c;
    let spin = 0.5 * (GRAVITY - 0.5 * w * w * c) * arm / (1.0 / 12.0 + 0.25 * s * arm);
    let normal = GRAVITY - 0.5 * (spin * s + w * w * c);
    [w, u, spin, -sense * FRICTION * normal - 0.5 * (spin * c - w * w * s)]
}

/// The times and states φ, x, and their rates where the foot slips, where it turns back, and of the
/// end.
pub fn run(start: [f64; 2], end: f64) -> Vec<(f64, [f64; 4])> {
    let margin = |state: &[f64; 2]| {
        let [tangential, normal] = forces(state);
        FRICTION * normal - tangential.abs()
    };
    let (t, held) = integrate(stick, margin, (0.0, start), (end, 1e-9));
    let mut sense = -forces(&held)[0].signum();
    let mut found = vec![(t, [held[0], 0.0, held[1], 0.0])];
    while let Some(&from) = found.last().filter(|(t, _)| *t < end) {
        // The foot moves as it begins to, wherever rounding begins.
        let speed = |state: &[f64; 4]| sense * state[3] + 1e-12;
        found.push(integrate(|state| slide(sense, state), speed, from, (end, 1e-9)));
        sense = -sense;
    }
    found
}
