//! Maximal coordinates: (x, y, θ) of each body at its centre of mass, then (x, y) of each particle.
//!
//! A point with frame coordinates p on a body with centre c: P = C + r, r = R(θ)(p − c),
//! Ṗ = Ċ + θ̇ r⊥, P̈ = C̈ + θ̈ r⊥ − θ̇² r, where r⊥ = (−r_y, r_x).

use nalgebra::{DVector, Rotation2, Vector2};

use super::{Assembly, Mark};

/// Positions and rates of every body and particle.
#[derive(Clone, Debug)]
pub struct State {
    /// x, y, θ of each body, then x, y of each particle.
    pub positions: DVector<f64>,
    /// Their rates, in the same order.
    pub rates: DVector<f64>,
}

/// A known point: what a component without pins is placed by.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    /// The point.
    pub at: Mark,
    /// Its position.
    pub position: Vector2<f64>,
    /// Its velocity.
    pub velocity: Vector2<f64>,
}

/// A quarter turn counter-clockwise.
pub(super) fn across(r: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-r.y, r.x)
}

impl State {
    /// Angle of a body from the +x axis, counter-clockwise, of its second point seen from its first.
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

    /// Position of a point.
    pub fn position(&self, state: &State, mark: Mark) -> Vector2<f64> {
        let at = 3 * mark.body;
        Vector2::new(state.positions[at], state.positions[at + 1]) + self.arm(state, mark)
    }

    /// Velocity of a point.
    pub fn velocity(&self, state: &State, mark: Mark) -> Vector2<f64> {
        let at = 3 * mark.body;
        let arm = across(self.arm(state, mark));
        Vector2::new(state.rates[at], state.rates[at + 1]) + arm * state.spin(mark.body)
    }

    /// The state with these body angles and spins, every body placed from pins and anchors along the hinges.
    /// `None` where a body is reached from neither. Pins and hinges that close loops are taken as they fall:
    /// [`Assembly::residual`] tells whether they hold, [`Assembly::settle`] makes them.
    pub fn state(&self, angles: &[f64], spins: &[f64], anchors: &[Anchor]) -> Option<State> {
        let mut state =
            State { positions: DVector::zeros(self.dimension()), rates: DVector::zeros(self.dimension()) };
        for body in 0..self.bodies.len() {
            state.positions[3 * body + 2] = angles[body];
            state.rates[3 * body + 2] = spins[body];
        }
        self.place_bodies(&mut state, anchors)?;
        self.place_particles(&mut state);
        Some(state)
    }

    fn place_bodies(&self, state: &mut State, anchors: &[Anchor]) -> Option<()> {
        let pinned = self.pins.iter().map(|pin| Anchor {
            at: pin.at,
            position: pin.ground,
            velocity: Vector2::zeros(),
        });
        let mut known: Vec<Anchor> = pinned.chain(anchors.iter().copied()).collect();
        let mut placed = vec![false; self.bodies.len()];
        while let Some(anchor) = known.pop() {
            if std::mem::replace(&mut placed[anchor.at.body], true) {
                continue;
            }
            self.place(state, anchor);
            let ends = self.hinges.iter().flat_map(|h| [(h.first, h.second), (h.second, h.first)]);
            for (near, far) in ends.filter(|(near, _)| near.body == anchor.at.body) {
                known.push(Anchor {
                    at: far,
                    position: self.position(state, near),
                    velocity: self.velocity(state, near),
                });
            }
        }
        placed.iter().all(|&is| is).then_some(())
    }

    fn place(&self, state: &mut State, anchor: Anchor) {
        let at = 3 * anchor.at.body;
        let arm = self.arm(state, anchor.at);
        let centre = anchor.position - arm;
        let velocity = anchor.velocity - across(arm) * state.spin(anchor.at.body);
        state.positions.fixed_rows_mut::<2>(at).copy_from(&centre);
        state.rates.fixed_rows_mut::<2>(at).copy_from(&velocity);
    }

    fn place_particles(&self, state: &mut State) {
        for (index, particle) in self.particles.iter().enumerate() {
            let at = 3 * self.bodies.len() + 2 * index;
            let (position, velocity) = (self.position(state, particle.at), self.velocity(state, particle.at));
            state.positions.fixed_rows_mut::<2>(at).copy_from(&position);
            state.rates.fixed_rows_mut::<2>(at).copy_from(&velocity);
        }
    }
}
