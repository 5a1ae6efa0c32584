//! Two-sided constraints.

use nalgebra::Vector2;

use super::{Coordinate, Formula, Mark, Place};

/// Two points that stay together.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The point whose body receives [`Motion::hinges`](super::Motion::hinges).
    pub first: Mark,
    /// The point whose body receives the opposite force.
    pub second: Mark,
}

/// A point that stays at a place of the ground.
#[derive(Clone, Debug)]
pub struct Pin {
    /// The point.
    pub at: Mark,
    /// The place.
    pub ground: Vector2<f64>,
}

/// Σ cᵢ θᵢ = value over body angles: equal angles, and with a hinge a weld.
#[derive(Clone, Debug)]
pub struct AngleTie {
    /// (body, cᵢ).
    pub terms: Vec<(usize, f64)>,
    /// Right-hand side.
    pub value: f64,
}

/// A point that stays on a straight guide.
#[derive(Clone, Debug)]
pub struct Slider {
    /// The point.
    pub point: Place,
    /// What it slides along.
    pub guide: Guide,
}

/// What a point slides along.
#[derive(Clone, Copy, Debug)]
pub enum Guide {
    /// n·(P − O) = 0.
    Line {
        /// O.
        through: Vector2<f64>,
        /// n.
        normal: Vector2<f64>,
    },
    /// The axis of a body: through its first point, along its first axis.
    Axis(usize),
}

/// A coordinate that follows a function of time.
#[derive(Clone, Debug)]
pub struct Drive {
    /// What is driven.
    pub reading: Coordinate,
    /// Its value; reads nothing but time.
    pub value: Formula,
}
