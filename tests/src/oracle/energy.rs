//! T = ½ q̇ᵀM q̇ and V = −Σ m g·C, zero for bodies at the origin (loads not counted).

use super::{Assembly, State};

impl Assembly {
    /// Kinetic energy of bodies and particles.
    pub fn kinetic_energy(&self, state: &State) -> f64 {
        0.5 * state.rates.dot(&self.masses().component_mul(&state.rates))
    }

    /// Potential energy in gravity.
    pub fn potential_energy(&self, state: &State) -> f64 {
        let unloaded = Assembly { loads: Vec::new(), ..self.clone() };
        -state.positions.dot(&unloaded.forces(state))
    }
}
