//! What stands still, and where it pushes what moves.

use super::{Direction, Number, Spot};

/// What stands still.
#[derive(Clone, Copy, Debug)]
pub struct Fixture {
    /// The support or guide it belongs to.
    pub name: &'static str,
    /// A place of it.
    pub at: [Number; 2],
    /// Its shape.
    pub shape: Shape,
}

/// Shapes of a [`Fixture`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A straight line through its place.
    Line {
        /// Its angle, counter-clockwise from the right.
        angle: Number,
        /// Whether it is the edge of something solid, to the right as one goes along it.
        solid: bool,
    },
    /// A circle about its place.
    Circle {
        /// Its radius.
        radius: Number,
        /// Where it is solid.
        solid: Solid,
        /// The radius as a formula; empty for a plain number.
        text: &'static str,
    },
    /// An edge that points where its support pushes.
    Wedge,
}

/// Where a circle bounds something solid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Solid {
    /// Inside: a disc.
    Within,
    /// Outside: a bowl.
    Around,
    /// Nowhere: it is a line.
    Nowhere,
}

/// Where a unit reaction acts, and which way.
#[derive(Clone, Copy, Debug)]
pub struct Push {
    /// The support or thread.
    pub support: &'static str,
    /// Where it acts, or the middle of what touches with its rim.
    pub at: Spot,
    /// How far the rim is from there, against the reaction; none of a point.
    pub rim: Option<Number>,
    /// A direction of the contact.
    pub along: Direction,
    /// Quarter turns counter-clockwise from `along` to the reaction.
    pub turns: u8,
    /// Where a positive tangential reaction points: a quarter turn from the normal one, +1
    /// counter-clockwise, −1 clockwise; 0 where there can be none.
    pub slip: i8,
}
