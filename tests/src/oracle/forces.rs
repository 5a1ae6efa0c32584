//! Applied forces: gravity, loads, couples, springs.

use nalgebra::{DVector, Vector2};

use super::state::axes;
use super::{Assembly, Load, Place, Spring, State, Torsion};

impl Assembly {
    /// m g on every body and particle.
    pub(super) fn weights(&self) -> DVector<f64> {
        let mut weights = DVector::zeros(self.dimension());
        for (index, body) in self.bodies.iter().enumerate() {
            weights.fixed_rows_mut::<2>(3 * index).copy_from(&(self.gravity * body.mass));
        }
        for (index, particle) in self.particles.iter().enumerate() {
            let at = self.particle_at(index);
            weights.fixed_rows_mut::<2>(at).copy_from(&(self.gravity * particle.mass));
        }
        weights
    }

    /// Everything applied, as forces on the maximal coordinates.
    pub fn forces(&self, state: &State) -> DVector<f64> {
        let mut forces = self.weights();
        for (place, force) in self.applied(state) {
            for (index, entry) in self.projection(state, place, force).gradient {
                forces[index] += entry;
            }
        }
        let couples = self.couples.iter().map(|c| (c.on, c.from, c.value.value(self, state)));
        let torsions = self.torsions.iter().map(|t| (t.on, t.from, self.torque(state, t)));
        for (on, from, couple) in couples.chain(torsions) {
            forces[3 * on + 2] += couple;
            if let Some(from) = from {
                forces[3 * from + 2] -= couple;
            }
        }
        forces
    }

    /// Loads and springs, each force with its point of application.
    pub(super) fn applied(&self, state: &State) -> Vec<(Place, Vector2<f64>)> {
        let loads = self.loads.iter().map(|load| (load.at, self.load(state, load)));
        let springs = self.springs.iter().flat_map(|spring| {
            let [a, b] = spring.ends.map(|end| self.position(state, end));
            let pull = (b - a).normalize() * self.tension(state, spring);
            [(spring.ends[0], pull), (spring.ends[1], -pull)]
        });
        loads.chain(springs).collect()
    }

    fn load(&self, state: &State, load: &Load) -> Vector2<f64> {
        let [x, y] = load.force.each_ref().map(|formula| formula.value(self, state));
        match load.frame {
            None => Vector2::new(x, y),
            Some(body) => {
                let [e, n] = axes(state, body);
                e * x + n * y
            }
        }
    }

    /// Tension of a spring and its damper.
    pub fn tension(&self, state: &State, spring: &Spring) -> f64 {
        let distance = self.distance(state, spring.ends);
        spring.stiffness * (distance.value - spring.length) + spring.damping * distance.rate(&state.rates)
    }

    /// Torque of a torsion spring and its damper on its body.
    pub fn torque(&self, state: &State, torsion: &Torsion) -> f64 {
        let [angle, spin] = torsion.from.map_or([0.0; 2], |from| [state.angle(from), state.spin(from)]);
        let turned = state.angle(torsion.on) - angle - torsion.angle;
        -torsion.stiffness * turned - torsion.damping * (state.spin(torsion.on) - spin)
    }
}
