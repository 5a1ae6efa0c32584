//! Rows of points: components, distances, and distances from the axis of a body.

use nalgebra::Vector2;

use super::Row;
use crate::oracle::state::{across, axes};
use crate::oracle::{Assembly, Mark, Place, State};

impl Assembly {
    /// g = d·P for a point P and a fixed direction d.
    pub(in crate::oracle) fn projection(&self, state: &State, place: Place, d: Vector2<f64>) -> Row {
        let (gradient, bias) = match place {
            Place::Body(mark) => {
                let (at, arm) = (3 * mark.body, self.arm(state, mark));
                let gradient = vec![(at, d.x), (at + 1, d.y), (at + 2, d.dot(&across(arm)))];
                (gradient, -state.spin(mark.body).powi(2) * d.dot(&arm))
            }
            Place::Particle(index) => {
                let at = self.particle_at(index);
                (vec![(at, d.x), (at + 1, d.y)], 0.0)
            }
            Place::Ground(_) => (Vec::new(), 0.0),
        };
        let value = d.dot(&self.position(state, place));
        Row { value, prescribed_gap_rate: 0.0, bias, gradient, forces: vec![(place, d)] }
    }

    /// g = |B − A| = r: J = e·∂(B − A), b = e·(B̈ − Ä) + (|v|² − (e·v)²)/r with e = (B − A)/r, v =
    /// Ḃ − Ȧ.
    pub(in crate::oracle) fn distance(&self, state: &State, [a, b]: [Place; 2]) -> Row {
        let r = self.position(state, b) - self.position(state, a);
        let v = self.velocity(state, b) - self.velocity(state, a);
        let (length, e) = (r.norm(), r.normalize());
        let mut row = self.projection(state, b, e).minus(self.projection(state, a, e));
        row.bias += e.perp(&v).powi(2) / length;
        row
    }

    /// g = n·(P − A): the distance of P to the left of the axis of a body with first point A, with
    /// n·(P − A) = n·(P − C) + c_across, dn/dθ = −e and de/dθ = n. The force acts on the body at
    /// the position of P.
    pub(super) fn offset(&self, state: &State, place: Place, body: usize) -> Row {
        let [e, n] = axes(state, body);
        let centre = Place::Body(Mark { body, local: self.bodies[body].centre });
        let reach = self.position(state, place) - self.position(state, centre);
        let velocity = self.velocity(state, place) - self.velocity(state, centre);
        let spin = state.spin(body);
        let foot =
            Mark { body, local: self.bodies[body].centre + Vector2::new(e.dot(&reach), n.dot(&reach)) };
        let mut row = self.projection(state, place, n);
        row.value = n.dot(&reach) + self.bodies[body].centre.y;
        row.bias -= 2.0 * spin * e.dot(&velocity) + spin * spin * n.dot(&reach);
        row.gradient.extend([(3 * body, -n.x), (3 * body + 1, -n.y), (3 * body + 2, -e.dot(&reach))]);
        row.forces.push((foot.into(), -n));
        row
    }
}
