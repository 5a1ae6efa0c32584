//! Maximal coordinates: (x, y, θ) of each body at its centre of mass, then (x, y) of each particle.
//!
//! A point with frame coordinates p on a body with centre c: P = C + r, r = R(θ)(p − c),
//! Ṗ = Ċ + θ̇ r⊥, P̈ = C̈ + θ̈ r⊥ − θ̇² r, where r⊥ = (−r_y, r_x).

use nalgebra::{DVector, Rotation2, Vector2};

use super::{Assembly, Mark, Place};

/// Positions and rates of every body and particle.
#[derive(Clone, Debug)]
pub struct State {
    /// x, y, θ of each body, then x, y of each particle.
    pub positions: DVector<f64>,
    /// Their rates, in the same order.
    pub rates: DVector<f64>,
    /// t.
    pub time: f64,
}

/// A known point: what a component without pins, or a free particle, is placed by.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    /// The point.
    pub at: Place,
    /// Its position.
    pub position: Vector2<f64>,
    /// Its velocity.
    pub velocity: Vector2<f64>,
}

/// The two entries from an index on.
pub(super) fn pair(vector: &DVector<f64>, at: usize) -> Vector2<f64> {
    Vector2::new(vector[at], vector[at + 1])
}

/// A quarter turn counter-clockwise.
pub(super) fn across(r: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-r.y, r.x)
}

/// The first and second axis of a body's frame.
pub(super) fn axes(state: &State, body: usize) -> [Vector2<f64>; 2] {
    let (sin, cos) = state.angle(body).sin_cos();
    [Vector2::new(cos, sin), Vector2::new(-sin, cos)]
}

impl State {
    /// Angle of a body from the +x axis, counter-clockwise, of its second point seen from its
    /// first.
    pub fn angle(&self, body: usize) -> f64 {
        self.positions[3 * body + 2]
    }

    /// Rate of that angle.
    pub fn spin(&self, body: usize) -> f64 {
        self.rates[3 * body + 2]
    }
}

impl Assembly {
    /// Number of maximal coordinates.
    pub fn dimension(&self) -> usize {
        3 * self.bodies.len() + 2 * self.particles.len()
    }

    /// r of a point of a body: its place from the centre of mass, turned with the body.
    pub(super) fn arm(&self, state: &State, mark: Mark) -> Vector2<f64> {
        Rotation2::new(state.angle(mark.body)) * (mark.local - self.bodies[mark.body].centre)
    }

    /// Where the coordinates of a particle begin.
    pub(super) fn particle_at(&self, particle: usize) -> usize {
        3 * self.bodies.len() + 2 * particle
    }

    /// Position of a point.
    pub fn position(&self, state: &State, place: impl Into<Place>) -> Vector2<f64> {
        match place.into() {
            Place::Body(mark) => pair(&state.positions, 3 * mark.body) + self.arm(state, mark),
            Place::Particle(index) => pair(&state.positions, self.particle_at(index)),
            Place::Ground(position) => position,
        }
    }

    /// Velocity of a point.
    pub fn velocity(&self, state: &State, place: impl Into<Place>) -> Vector2<f64> {
        match place.into() {
            Place::Body(mark) => {
                let arm = across(self.arm(state, mark));
                pair(&state.rates, 3 * mark.body) + arm * state.spin(mark.body)
            }
            Place::Particle(index) => pair(&state.rates, self.particle_at(index)),
            Place::Ground(_) => Vector2::zeros(),
        }
    }

    /// The state with these body angles and spins, every body placed from pins and anchors along
    /// the hinges, at t = 0; free particles are where their anchors are. `None` where a body is
    /// reached from neither. Pins and hinges that close loops are taken as they fall:
    /// [`Assembly::residual`] tells whether they hold, [`Assembly::settle`] makes them.
    pub fn state(&self, angles: &[f64], spins: &[f64], anchors: &[Anchor]) -> Option<State> {
        let zeros = || DVector::zeros(self.dimension());
        let mut state = State { positions: zeros(), rates: zeros(), time: 0.0 };
        for body in 0..self.bodies.len() {
            state.positions[3 * body + 2] = angles[body];
            state.rates[3 * body + 2] = spins[body];
        }
        self.place_bodies(&mut state, anchors)?;
        self.place_particles(&mut state, anchors);
        Some(state)
    }

    fn place_bodies(&self, state: &mut State, anchors: &[Anchor]) -> Option<()> {
        let of_body = |anchor: &Anchor| match anchor.at {
            Place::Body(mark) => Some((mark, anchor.position, anchor.velocity)),
            _ => None,
        };
        let pinned = self.pins.iter().map(|pin| (pin.at, pin.ground, Vector2::zeros()));
        let mut known: Vec<_> = pinned.chain(anchors.iter().filter_map(of_body)).collect();
        let mut placed = vec![false; self.bodies.len()];
        while let Some((mark, position, velocity)) = known.pop() {
            if std::mem::replace(&mut placed[mark.body], true) {
                continue;
            }
            self.place_body(state, mark, position, velocity);
            let ends = self.hinges.iter().flat_map(|h| [(h.first, h.second), (h.second, h.first)]);
            for (near, far) in ends.filter(|(near, _)| near.body == mark.body) {
                known.push((far, self.position(state, near), self.velocity(state, near)));
            }
        }
        placed.iter().all(|&is| is).then_some(())
    }

    fn place_body(&self, state: &mut State, mark: Mark, position: Vector2<f64>, velocity: Vector2<f64>) {
        let at = 3 * mark.body;
        let arm = self.arm(state, mark);
        let centre = position - arm;
        let velocity = velocity - across(arm) * state.spin(mark.body);
        state.positions.fixed_rows_mut::<2>(at).copy_from(&centre);
        state.rates.fixed_rows_mut::<2>(at).copy_from(&velocity);
    }

    fn place_particles(&self, state: &mut State, anchors: &[Anchor]) {
        for (index, particle) in self.particles.iter().enumerate() {
            let anchor = anchors.iter().find(|anchor| anchor.at == Place::Particle(index));
            let (position, velocity) = match (particle.carrier, anchor) {
                (Some(mark), _) => (self.position(state, mark), self.velocity(state, mark)),
                (None, Some(anchor)) => (anchor.position, anchor.velocity),
                (None, None) => continue,
            };
            let at = self.particle_at(index);
            state.positions.fixed_rows_mut::<2>(at).copy_from(&position);
            state.rates.fixed_rows_mut::<2>(at).copy_from(&velocity);
        }
    }
}
