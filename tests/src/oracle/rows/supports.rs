//! Rows of the supports: gaps, and tangential velocities of rough ones.

use nalgebra::Vector2;

use super::Row;
use crate::oracle::state::{across, axes};
use crate::oracle::{Assembly, Contact, Mark, Place, State, Support};

/// The direction whose left normal is n.
fn along(n: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(n.y, -n.x)
}

impl Assembly {
    /// The gap of a support.
    pub fn support_row(&self, state: &State, support: usize) -> Row {
        match &self.supports[support].contact {
            &Contact::Point { point, through, normal } => {
                let mut row = self.projection(state, point, normal);
                row.value -= normal.dot(&through);
                row
            }
            &Contact::Corner { body, corner, side } => {
                self.offset(state, Place::Ground(corner), body).scaled(-side)
            }
            &Contact::Circle { point, centre, radius, inside } => {
                let mut row = self.distance(state, [Place::Ground(centre), point]);
                row.value -= radius;
                if inside { row.scaled(-1.0) } else { row }
            }
            Contact::Thread { path, length } => {
                let limit = Row { value: *length, ..Row::default() };
                path.windows(2).fold(limit, |row, ends| row.minus(self.distance(state, [ends[0], ends[1]])))
            }
        }
    }

    /// The slip of a rough support: ġ is the velocity of the touching point of the body along the
    /// tangent: of a line, to whose left the free side lies; of a bar on a corner; a quarter turn
    /// counter-clockwise from the radius of a circle. `None` for smooth supports and threads. It
    /// has no value.
    pub fn tangent_row(&self, state: &State, support: usize) -> Option<Row> {
        let row = if self.slips(support) { self.slip(state, support) } else { None };
        row.map(|row| Row { value: 0.0, ..row })
    }

    /// Whether a support has a tangential row.
    pub(in crate::oracle) fn slips(&self, support: usize) -> bool {
        let Support { contact, rough, .. } = &self.supports[support];
        *rough && !matches!(contact, Contact::Thread { .. })
    }

    fn slip(&self, state: &State, support: usize) -> Option<Row> {
        match self.supports[support].contact {
            Contact::Point { point, normal, .. } => Some(self.projection(state, point, along(normal))),
            Contact::Circle { point, centre, .. } => {
                let (r, v) = (self.position(state, point) - centre, self.velocity(state, point));
                let outwards = r.normalize();
                let turning = (v - outwards * outwards.dot(&v)) / r.norm();
                let mut row = self.projection(state, point, across(outwards));
                row.bias += across(turning).dot(&v);
                Some(row)
            }
            Contact::Corner { body, corner, .. } => Some(self.corner_slip(state, body, corner)),
            Contact::Thread { .. } => None,
        }
    }

    /// e·Ċ − ω n·(K − C), the velocity along the bar of its point at the corner K;
    /// b = 2 ω n·Ċ + ω² e·(K − C).
    fn corner_slip(&self, state: &State, body: usize, corner: Vector2<f64>) -> Row {
        let [e, n] = axes(state, body);
        let centre = Mark { body, local: self.bodies[body].centre };
        let (reach, velocity) = (corner - self.position(state, centre), self.velocity(state, centre));
        let local = centre.local + Vector2::new(e.dot(&reach), n.dot(&reach));
        let mut row = self.projection(state, Mark { body, local }.into(), e);
        let spin = state.spin(body);
        row.bias = 2.0 * spin * n.dot(&velocity) + spin * spin * e.dot(&reach);
        row
    }
}
