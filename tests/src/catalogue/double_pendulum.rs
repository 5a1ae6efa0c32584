//! Entry 12: two equal uniform bars of mass m and length l, angles α, β from the downward vertical.
//!
//! Lagrange's equations over m l²: (4/3) α̈ + ½ cos(α−β) β̈ = −½ sin(α−β) β̇² − (3g/2l) sin α,
//! ½ cos(α−β) α̈ + (1/3) β̈ = ½ sin(α−β) α̇² − (g/2l) sin β.

/// (α̈, β̈).
pub fn accelerations(length: f64, gravity: f64, angles: [f64; 2], rates: [f64; 2]) -> [f64; 2] {
    let [alpha, beta] = angles;
    let (sin, cos) = (alpha - beta).sin_cos();
    let w = gravity / length;
    let first = -0.5 * sin * rates[1].powi(2) - 1.5 * w * alpha.sin();
    let second = 0.5 * sin * rates[0].powi(2) - 0.5 * w * beta.sin();
    let determinant = 4.0 / 9.0 - 0.25 * cos * cos;
    [(first / 3.0 - 0.5 * cos * second) / determinant, (4.0 / 3.0 * second - 0.5 * cos * first) / determinant]
}

/// Squares of the small modes' frequencies, (3 ∓ 6/√7) g/l.
pub fn modes(length: f64, gravity: f64) -> [f64; 2] {
    [-1.0, 1.0].map(|sign| (3.0 + sign * 6.0 / 7.0_f64.sqrt()) * gravity / length)
}

/// The table's states (α, β, α̇, β̇) for l = m = ½, g = 1, from rest at (0, π − 0.1), to the 8
/// digits printed.
pub const TABLE: [(f64, [f64; 4]); 2] = [
    (5.0, [-0.37594858, 0.95183977, 1.39101126, 0.33843165]),
    (10.0, [0.46046378, -1.47688764, 0.37824781, 2.23483667]),
];
