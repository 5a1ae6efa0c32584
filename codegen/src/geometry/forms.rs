//! Forms, with numbers and points by their indices.

use super::Number;

/// A place.
#[derive(Clone, Copy, Debug)]
pub enum Spot {
    /// That of a point.
    Point(usize),
    /// Of the ground.
    Fixed([Number; 2]),
}

/// A direction.
#[derive(Clone, Copy, Debug)]
pub enum DrawnDirection {
    /// At an angle.
    Fixed(Number),
    /// From one place to another.
    Towards(Spot, Spot),
    /// The first axis of a body's frame: two of its points, and the step between them in the frame.
    Axis([usize; 2], [Number; 2]),
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct DrawnBody {
    /// Its ends or corners.
    pub outline: Vec<usize>,
    /// Its other points.
    pub inner: Vec<usize>,
}

/// A circle about a point.
#[derive(Clone, Debug)]
pub struct Round {
    /// The point.
    pub centre: usize,
    /// Its radius.
    pub radius: Number,
    /// The radius as a formula.
    pub text: String,
    /// What it bounds.
    pub solid: Solid,
    /// A direction that turns with it.
    pub along: Option<DrawnDirection>,
}

/// Where a circle bounds something solid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Solid {
    /// Inside.
    Within,
    /// Outside.
    Around,
    /// Nowhere: it is a line.
    Nowhere,
}

/// A thread.
#[derive(Clone, Debug)]
pub struct DrawnThread {
    /// Its name.
    pub name: String,
    /// Its points from end to end.
    pub path: Vec<usize>,
    /// Its length.
    pub length: Number,
    /// The length as a formula.
    pub text: String,
}

/// A coil, a dashpot or both.
#[derive(Clone, Debug)]
pub struct DrawnSpring {
    /// Its name.
    pub name: String,
    /// Its ends.
    pub ends: [usize; 2],
    /// Whether there is a coil.
    pub coil: bool,
    /// Whether there is a dashpot.
    pub dashpot: bool,
    /// Stiffness and damping as formulas.
    pub text: String,
}

/// Looks of a mark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Look {
    /// A disc that a thread passes over.
    Peg,
    /// A mass.
    Mass,
    /// A joint that turns.
    Ring,
    /// A joint that does not turn.
    Disc,
    /// A foot on the ground.
    Foot,
    /// A piece of the ground itself.
    Ground,
}

/// What stands still.
#[derive(Clone, Debug)]
pub struct Fixture {
    /// The support or guide.
    pub name: String,
    /// A place of it.
    pub at: [Number; 2],
    /// Its shape.
    pub shape: DrawnShape,
}

/// Shapes of a [`Fixture`].
#[derive(Clone, Debug)]
pub enum DrawnShape {
    /// A straight line, or the edge of something solid to its right.
    Line {
        /// Its angle.
        angle: Number,
        /// Whether it is an edge.
        solid: bool,
    },
    /// A circle.
    Circle {
        /// Its radius.
        radius: Number,
        /// Where it is solid.
        solid: Solid,
        /// The radius as a formula.
        text: String,
    },
    /// An edge that points where its support pushes.
    Wedge,
}

/// A section of a bar.
#[derive(Clone, Debug)]
pub struct DrawnSection {
    /// Its name.
    pub name: String,
    /// Ends of the bar.
    pub ends: [usize; 2],
    /// The distance from the first.
    pub at: Number,
}

/// What a coordinate measures.
#[derive(Clone, Copy, Debug)]
pub enum DrawnReading {
    /// An angle.
    Angle {
        /// The point at which it is shown.
        vertex: usize,
        /// The other end of the bar.
        tip: usize,
        /// What it is measured from.
        from: DrawnDirection,
        /// Whether the bar is read from the tip to the vertex.
        against: bool,
        /// ±1.
        sign: i8,
    },
    /// A position.
    Position {
        /// The point.
        point: usize,
        /// 0 for x, 1 for y.
        axis: usize,
        /// ±1.
        sign: i8,
    },
}

/// A length.
#[derive(Clone, Debug)]
pub struct Length {
    /// Its value.
    pub value: Number,
    /// The same as a formula.
    pub text: String,
    /// Pairs of points that have it.
    pub between: Vec<[usize; 2]>,
}

/// Where a unit reaction acts, and which way.
#[derive(Clone, Debug)]
pub struct Push {
    /// The support or thread.
    pub support: String,
    /// Where it acts, or the middle of what touches with its rim.
    pub at: Spot,
    /// How far the rim is from there, against the reaction.
    pub rim: Option<Number>,
    /// A direction of the contact.
    pub along: DrawnDirection,
    /// Quarter turns from it to the reaction.
    pub turns: u8,
    /// The quarter turn from there to the tangential reaction; 0 for none.
    pub slip: i8,
}
