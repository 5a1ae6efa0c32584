//! T = ½ q̇ᵀM q̇ and V = −Σ m g·C + Σ ½ k (r − ℓ₀)² + Σ ½ k (Δ − a)², zero for bodies at the origin
//! (loads not counted); momenta p = Σ m Ċ and L = Σ m C×Ċ + I ω about the origin.

use nalgebra::Vector2;

use super::{Assembly, State};

impl Assembly {
    /// Kinetic energy of bodies and particles.
    pub fn kinetic_energy(&self, state: &State) -> f64 {
        0.5 * state.rates.dot(&self.masses().component_mul(&state.rates))
    }

    /// Potential energy in gravity and in springs.
    pub fn potential_energy(&self, state: &State) -> f64 {
        let stretched = self.springs.iter().map(|spring| {
            let [a, b] = spring.ends.map(|end| self.position(state, end));
            0.5 * spring.stiffness * ((b - a).norm() - spring.length).powi(2)
        });
        let twisted = self.torsions.iter().map(|torsion| {
            let from = torsion.from.map_or(0.0, |body| state.angle(body));
            0.5 * torsion.stiffness * (state.angle(torsion.on) - from - torsion.angle).powi(2)
        });
        stretched.chain(twisted).sum::<f64>() - state.positions.dot(&self.weights())
    }

    /// Linear momentum, then angular momentum about the origin, counter-clockwise.
    pub fn momenta(&self, state: &State) -> [f64; 3] {
        let pair = |v: &nalgebra::DVector<f64>, at: usize| Vector2::new(v[at], v[at + 1]);
        let bodies = self.bodies.iter().enumerate().map(|(i, body)| (3 * i, body.mass));
        let first = 3 * self.bodies.len();
        let particles = self.particles.iter().enumerate().map(|(i, particle)| (first + 2 * i, particle.mass));
        let mut momenta = [0.0; 3];
        for (at, mass) in bodies.chain(particles) {
            let (place, p) = (pair(&state.positions, at), pair(&state.rates, at) * mass);
            momenta[0] += p.x;
            momenta[1] += p.y;
            momenta[2] += place.perp(&p);
        }
        let spins = self.bodies.iter().enumerate().map(|(i, body)| body.inertia * state.spin(i));
        momenta[2] += spins.sum::<f64>();
        momenta
    }
}
