//! Fig. 1b as published: four bars of length l as an M, feet A, C, E on the floor, all angles equal
//! to φ.
//!
//! Inner bars m₁, outer bars m₂, λ = m₂/(m₁ + m₂); at rest at φ(0). In flight y is the drop of C.

use crate::numerics::integral;

/// Masses, length, gravity and the angle of rest.
#[derive(Clone, Copy, Debug)]
pub struct Zigzag {
    /// Mass of an inner bar.
    pub m1: f64,
    /// Mass of an outer bar.
    pub m2: f64,
    /// Length of each bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
    /// φ(0), where the bars were at rest.
    pub start: f64,
}

impl Zigzag {
    /// λ = m₂/(m₁ + m₂).
    pub fn lambda(&self) -> f64 {
        self.m2 / (self.m1 + self.m2)
    }

    /// 1/3 + 2λ sin²φ.
    fn bracket(&self, phi: f64) -> f64 {
        1.0 / 3.0 + 2.0 * self.lambda() * phi.sin().powi(2)
    }

    /// 1/12 + (1/4 + 2λ) sin²φ.
    fn free_bracket(&self, phi: f64) -> f64 {
        1.0 / 12.0 + (0.25 + 2.0 * self.lambda()) * phi.sin().powi(2)
    }

    /// (3.9): the centre of an outer bar from C, (3l/2) cos φ outward, (l/2) sin φ up.
    pub fn outer_centre(&self, phi: f64) -> [f64; 2] {
        [1.5 * self.l * phi.cos(), 0.5 * self.l * phi.sin()]
    }

    /// (3.10): its speed squared, (l²/4)(1 + 8 sin²φ) φ̇².
    pub fn outer_speed_squared(&self, phi: f64, rate: f64) -> f64 {
        0.25 * self.l * self.l * (1.0 + 8.0 * phi.sin().powi(2)) * rate * rate
    }

    /// (3.11): T = (m₁ + m₂)(1/3 + 2λ sin²φ) l²φ̇².
    pub fn constrained_energy(&self, phi: f64, rate: f64) -> f64 {
        (self.m1 + self.m2) * self.bracket(phi) * (self.l * rate).powi(2)
    }

    /// (3.12): work of gravity from φ(0), (m₁ + m₂) g l (sin φ(0) − sin φ).
    pub fn work(&self, phi: f64) -> f64 {
        (self.m1 + self.m2) * self.g * self.l * self.fall(phi)
    }

    /// sin φ(0) − sin φ as a product.
    fn fall(&self, phi: f64) -> f64 {
        2.0 * (0.5 * (self.start + phi)).cos() * (0.5 * (self.start - phi)).sin()
    }

    /// (3.13): φ̇² = (g/l)(sin φ(0) − sin φ)/(1/3 + 2λ sin²φ).
    pub fn rate_squared(&self, phi: f64) -> f64 {
        self.g / self.l * self.fall(phi) / self.bracket(phi)
    }

    /// (3.14): φ̈ = −(g/2l) cos φ (1/3 + 4λ sin φ(0) sin φ − 2λ sin²φ)/(1/3 + 2λ sin²φ)².
    pub fn acceleration(&self, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let lambda = self.lambda();
        let top = 1.0 / 3.0 + 4.0 * lambda * self.start.sin() * sin - 2.0 * lambda * sin * sin;
        -0.5 * self.g / self.l * cos * top / self.bracket(phi).powi(2)
    }

    /// (3.15)–(3.16): the total reaction 2(m₁ + m₂) g (1 − μ/2).
    pub fn reaction(&self, phi: f64) -> f64 {
        2.0 * (self.m1 + self.m2) * self.g * (1.0 - 0.5 * self.mu(phi))
    }

    /// (3.17)–(3.19): μ = (l/g)(φ̇² sin φ − φ̈ cos φ); the feet are pressed to the floor while μ < 2.
    pub fn mu(&self, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        self.l / self.g * (self.rate_squared(phi) * sin - self.acceleration(phi) * cos)
    }

    /// (3.20): T = (m₁ + m₂)[ẏ² − ẏ φ̇ l cos φ + (1/3 + 2λ sin²φ) l²φ̇²] in flight.
    pub fn free_energy(&self, phi: f64, rate: f64, drop_rate: f64) -> f64 {
        let mixed = drop_rate * (drop_rate - rate * self.l * phi.cos());
        (self.m1 + self.m2) * mixed + self.constrained_energy(phi, rate)
    }

    /// (3.21): left minus right sides of Lagrange's equations in flight, both divided by (m₁ + m₂):
    /// −ÿ cos φ + 2l φ̈(1/3 + 2λ sin²φ) + 4λ l φ̇² sin φ cos φ = −g cos φ and ÿ = g + (l/2)(φ̈ cos
    /// φ − φ̇² sin φ).
    pub fn free_residuals(&self, phi: f64, rate: f64, accelerations: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = phi.sin_cos();
        let [turn, drop] = accelerations;
        let swing = 4.0 * self.lambda() * self.l * rate * rate * sin * cos;
        let rise = 0.5 * self.l * (turn * cos - rate * rate * sin);
        [-drop * cos + 2.0 * self.l * turn * self.bracket(phi) + swing + self.g * cos, drop - self.g - rise]
    }

    /// Between (3.21) and (3.22): the first integral h = φ̇² (1/12 + (1/4 + 2λ) sin²φ) of flight.
    pub fn free_integral(&self, phi: f64, rate: f64) -> f64 {
        rate * rate * self.free_bracket(phi)
    }

    /// Between (3.21) and (3.22): φ̇ = −√(h/(1/12 + (1/4 + 2λ) sin²φ)).
    pub fn free_rate(&self, h: f64, phi: f64) -> f64 {
        -(h / self.free_bracket(phi)).sqrt()
    }

    /// Between (3.21) and (3.22): φ̈ = −h (1/4 + 2λ) sin φ cos φ/(1/12 + (1/4 + 2λ) sin²φ)².
    pub fn free_acceleration(&self, h: f64, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        -h * (0.25 + 2.0 * self.lambda()) * sin * cos / self.free_bracket(phi).powi(2)
    }

    /// (3.22): downward acceleration of C in flight, g − (h l/2)(1/3 + 2λ) sin φ/(1/12 + (1/4 + 2λ)
    /// sin²φ)².
    pub fn free_drop_acceleration(&self, h: f64, phi: f64) -> f64 {
        let top = 0.5 * h * self.l * (1.0 / 3.0 + 2.0 * self.lambda()) * phi.sin();
        self.g - top / self.free_bracket(phi).powi(2)
    }

    /// Time of flight from `start` to φ < start.
    pub fn flight_time(&self, h: f64, start: f64, phi: f64) -> f64 {
        integral(|angle| 1.0 / self.free_rate(h, angle), start, phi)
    }

    /// Behind (3.22): rise of C at φ in flight that began at `start`: the centre of mass, (l/2) sin
    /// φ above C, falls freely.
    pub fn rise(&self, h: f64, start: f64, phi: f64) -> f64 {
        let time = self.flight_time(h, start, phi);
        let climb = 0.5 * self.l * start.cos() * self.free_rate(h, start);
        0.5 * self.l * (start.sin() - phi.sin()) + climb * time - 0.5 * self.g * time * time
    }
}
