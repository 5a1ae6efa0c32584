//! Entry 3: a rod about a rough point, θ from the vertical, from rest upright: θ̇² = 3(1 − cos θ).

use crate::numerics::root;

/// θ̇².
pub fn rate_squared(theta: f64) -> f64 {
    6.0 * (0.5 * theta).sin().powi(2)
}

/// N = ¼(1 − 3 cos θ)².
pub fn reaction(theta: f64) -> f64 {
    0.25 * (1.0 - 3.0 * theta.cos()).powi(2)
}

/// Friction towards the side of the fall, ¾ sin θ (3 cos θ − 2).
pub fn friction(theta: f64) -> f64 {
    0.75 * theta.sin() * (3.0 * theta.cos() - 2.0)
}

/// Time between two angles: ∫ dθ/(√6 sin ½θ).
pub fn time(from: f64, to: f64) -> f64 {
    (2.0_f64 / 3.0).sqrt() * ((0.25 * to).tan() / (0.25 * from).tan()).ln()
}

/// Where friction first reaches μN: backwards at F = μN if μ < 15√40/256, else forwards at F = −μN.
pub fn slip_angle(mu: f64) -> Option<f64> {
    let touch = (1.0_f64 / 3.0).acos();
    let strongest = 15.0 * 40.0_f64.sqrt() / 256.0;
    if mu < strongest {
        // F/N = 3 sin θ (3 cos θ − 2)/(3 cos θ − 1)² is largest where cos θ = 9/11.
        return root(|theta| friction(theta) - mu * reaction(theta), 1e-3, (9.0_f64 / 11.0).acos());
    }
    root(|theta| friction(theta) + mu * reaction(theta), (2.0_f64 / 3.0).acos(), touch - 1e-3)
}
