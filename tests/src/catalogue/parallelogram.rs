//! Entry 13: a bar of mass c on two equal cranks (m, l): T = ½ (⅔ m + c) l² φ̇², V = −(m + c) g l
//! cos φ.

use crate::numerics::elliptic_k;

/// Square of the frequency of small swings.
pub fn frequency_squared(crank: f64, coupler: f64, length: f64, gravity: f64) -> f64 {
    (crank + coupler) * gravity / (length * (2.0 / 3.0 * crank + coupler))
}

/// Period of amplitude α: (4/ω) K(sin² ½α).
pub fn period(frequency_squared: f64, amplitude: f64) -> f64 {
    4.0 / frequency_squared.sqrt() * elliptic_k((0.5 * amplitude).sin().powi(2))
}

/// φ̇² of N loops in a row of equal bars that start upright (φ = 0) at the rate ω: N + 1 uprights,
/// N level bars.
pub fn row_rate_squared(loops: f64, length: f64, gravity: f64, rate: f64, phi: f64) -> f64 {
    let (fall, inertia) = (0.5 * (loops + 1.0) + loops, (loops + 1.0) / 3.0 + loops);
    rate * rate + 4.0 * gravity * fall * (0.5 * phi).sin().powi(2) / (length * inertia)
}
