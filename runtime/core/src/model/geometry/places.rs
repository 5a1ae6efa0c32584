//! Numbers, places and directions.

/// An index into [`BarSystem::numbers`](crate::model::BarSystem::numbers): a length or an angle in
/// rad.
pub type Number = usize;

/// A place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Spot {
    /// That of a point, which moves.
    Point(usize),
    /// Of the ground, by its x and y.
    Fixed([Number; 2]),
}

/// A direction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// At this angle, counter-clockwise from the right.
    Fixed(Number),
    /// From one place to another.
    Towards(Spot, Spot),
    /// The first axis of a body's frame.
    Axis {
        /// Two points of the body.
        ends: [usize; 2],
        /// The components of the step between them in the frame.
        step: [Number; 2],
    },
}
