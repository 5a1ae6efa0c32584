//! Fig. 1a: bars AD, DB hinged at D over two smooth corners a bar length apart; y = drop of D.

use crate::numerics::integral;

/// Mass and length of one bar, gravity.
#[derive(Clone, Copy, Debug)]
pub struct FallingPair {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}

impl FallingPair {
    /// 4/3 + sec⁴φ − 2 sec φ, the bracket of (3.1) and (3.2).
    fn bracket(phi: f64) -> f64 {
        let sec = 1.0 / phi.cos();
        4.0 / 3.0 + sec.powi(4) - 2.0 * sec
    }

    /// Drop of D with both corners touching: y = (l/2) tan φ.
    pub fn drop(&self, phi: f64) -> f64 {
        0.5 * self.l * phi.tan()
    }

    /// (3.1), both bars: T = (m l²/4)(4/3 + sec⁴φ − 2 sec φ) φ̇².
    pub fn constrained_energy(&self, phi: f64, rate: f64) -> f64 {
        0.25 * self.m * self.l * self.l * Self::bracket(phi) * rate * rate
    }

    /// (3.2): φ̇² from rest at φ = 0, (4g/l)(1 − cos φ) tan φ over the bracket; 1 − cos φ as 2
    /// sin²(φ/2).
    pub fn rate_squared(&self, phi: f64) -> f64 {
        8.0 * self.g / self.l * (0.5 * phi).sin().powi(2) * phi.tan() / Self::bracket(phi)
    }

    /// (3.3): φ̈ = ½ d(φ̇²)/dφ along the motion from rest at φ = 0.
    pub fn acceleration(&self, phi: f64) -> f64 {
        self.acceleration_at(phi, self.rate_squared(phi).sqrt())
    }

    /// φ̈ at any rate with both corners touching: Lagrange's equation of (3.1) with V = −2 m g
    /// (l/2)(tan φ − sin φ), B φ̈ + ½ B′ φ̇² = (2g/l)(sec²φ − cos φ), B the bracket, B′ = (4 sec⁴φ
    /// − 2 sec φ) tan φ.
    pub fn acceleration_at(&self, phi: f64, rate: f64) -> f64 {
        let sec = 1.0 / phi.cos();
        let slope = (4.0 * sec.powi(4) - 2.0 * sec) * phi.tan();
        let pull = 2.0 * self.g / self.l * versed_pull(phi);
        (pull - 0.5 * slope * rate * rate) / Self::bracket(phi)
    }

    /// Downward acceleration of a bar's centre, ÿ_C with y_C = (l/2)(tan φ − sin φ).
    pub fn centre_acceleration(&self, phi: f64, rate: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let second = 2.0 * sin / cos.powi(3) + sin;
        let acceleration = self.acceleration_at(phi, rate);
        0.5 * self.l * (second * rate * rate + versed_pull(phi) * acceleration)
    }

    /// (3.4): reaction of one corner, N = m (g − ÿ_C)/cos φ.
    pub fn reaction(&self, phi: f64, rate: f64) -> f64 {
        self.m * (self.g - self.centre_acceleration(phi, rate)) / phi.cos()
    }

    /// (3.5): T = m (ẏ² − ẏ l φ̇ cos φ + l²φ̇²/3) in free flight.
    pub fn free_energy(&self, phi: f64, rate: f64, drop_rate: f64) -> f64 {
        let spin = self.l * rate;
        self.m * (drop_rate * drop_rate - drop_rate * spin * phi.cos() + spin * spin / 3.0)
    }

    /// (3.6): (φ̈, ÿ) from (2/3) l²φ̈ − ÿ l cos φ = −g l cos φ and 2ÿ − l φ̈ cos φ + l φ̇² sin φ =
    /// 2g.
    pub fn free_accelerations(&self, phi: f64, rate: f64) -> [f64; 2] {
        let (sin, cos) = phi.sin_cos();
        let [a, b, c] = [2.0 / 3.0 * self.l * self.l, -self.l * cos, -self.l * cos];
        let right = [-self.g * self.l * cos, 2.0 * self.g - self.l * rate * rate * sin];
        let determinant = 2.0 * a - b * c;
        [(2.0 * right[0] - b * right[1]) / determinant, (a * right[1] - c * right[0]) / determinant]
    }

    /// (3.7): φ̈ (2/3 − ½cos²φ) + ½φ̇² sin φ cos φ, zero in free flight.
    pub fn free_residual(&self, phi: f64, rate: f64, acceleration: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        acceleration * (2.0 / 3.0 - 0.5 * cos * cos) + 0.5 * rate * rate * sin * cos
    }

    /// (3.8): the first integral φ̇² (2/3 − ½cos²φ) of free flight.
    pub fn free_integral(&self, phi: f64, rate: f64) -> f64 {
        rate * rate * (2.0 / 3.0 - 0.5 * phi.cos().powi(2))
    }

    /// (3.8) solved: φ̇(φ) in flight after `rate` at `start`.
    pub fn free_rate(&self, start: f64, rate: f64, phi: f64) -> f64 {
        (self.free_integral(start, rate) / self.free_integral(phi, 1.0)).sqrt()
    }

    /// Duration of the flight from `start` to φ.
    pub fn flight_time(&self, start: f64, rate: f64, phi: f64) -> f64 {
        integral(|angle| 1.0 / self.free_rate(start, rate, angle), start, phi)
    }

    /// Drop of D at φ in flight: the centre of mass falls freely, y = y_C + (l/2) sin φ.
    pub fn free_drop(&self, start: f64, rate: f64, phi: f64) -> f64 {
        let time = self.flight_time(start, rate, phi);
        let centre = 0.5 * self.l * (start.tan() - start.sin());
        let speed = 0.5 * self.l * versed_pull(start) * rate;
        centre + speed * time + 0.5 * self.g * time * time + 0.5 * self.l * phi.sin()
    }
}

/// sec²φ − cos φ without cancellation: tan²φ + 2 sin²(φ/2).
fn versed_pull(phi: f64) -> f64 {
    phi.tan().powi(2) + 2.0 * (0.5 * phi).sin().powi(2)
}
