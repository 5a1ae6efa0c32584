//! What is measured: coordinates and lengths.

use super::{Direction, Number};

/// What a coordinate measures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reading {
    /// An angle between a direction and a bar: `sign` times the coordinate leads from one to the
    /// other.
    Angle {
        /// The point at which it is shown.
        vertex: usize,
        /// The other end of the bar.
        tip: usize,
        /// What it is measured from.
        from: Direction,
        /// Whether the bar is read from the tip to the vertex, so that the arc begins against
        /// `from`.
        against: bool,
        /// +1 counter-clockwise, −1 clockwise.
        sign: i8,
    },
    /// A position: `sign` times the coordinate is the point's place along the axis.
    Position {
        /// The point.
        point: usize,
        /// 0 for x, 1 for y.
        axis: usize,
        /// ±1.
        sign: i8,
    },
}

/// A length to be shown once.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    /// The length.
    pub value: Number,
    /// The same as a formula; empty for a plain number.
    pub text: &'static str,
    /// Pairs of points between which it may be shown.
    pub between: &'static [[usize; 2]],
}
