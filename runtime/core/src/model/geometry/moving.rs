//! What moves: outlines, threads, springs, blocks, marks at points.

use super::{Direction, Number, Solid};

/// A rigid body: a bar between two points, a plate of more.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Its ends or corners.
    pub outline: &'static [usize],
    /// Its other points.
    pub inner: &'static [usize],
}

/// A circle about a point.
#[derive(Clone, Copy, Debug)]
pub struct Round {
    /// The point.
    pub centre: usize,
    /// Its radius.
    pub radius: Number,
    /// The radius as a formula; empty for a plain number.
    pub text: &'static str,
    /// What it bounds.
    pub solid: Solid,
    /// A direction that turns with it; none of what does not turn.
    pub along: Option<Direction>,
}

/// A line from point to point that can be slack.
#[derive(Clone, Copy, Debug)]
pub struct Thread {
    /// Its name.
    pub name: &'static str,
    /// Its points from end to end.
    pub path: &'static [usize],
    /// Its length, which it has when taut.
    pub length: Number,
    /// The length as a formula; empty for a plain number.
    pub text: &'static str,
}

/// A coil, a dashpot or both side by side.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Its name.
    pub name: &'static str,
    /// Its ends.
    pub ends: [usize; 2],
    /// Whether there is a coil.
    pub coil: bool,
    /// Whether there is a dashpot.
    pub dashpot: bool,
    /// Stiffness and damping as formulas; empty for plain numbers.
    pub text: &'static str,
}

/// A spiral about a point.
#[derive(Clone, Copy, Debug)]
pub struct Spiral {
    /// The point.
    pub point: usize,
    /// Where its inner end points.
    pub from: Direction,
}

/// A block about a point.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    /// The point.
    pub point: usize,
    /// The direction in which it slides.
    pub along: Direction,
}

/// A mark at a point.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// The point.
    pub point: usize,
    /// What is drawn there.
    pub look: Look,
}

/// Looks of a [`Mark`].
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

/// A stroke across a bar.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Its name.
    pub name: &'static str,
    /// Ends of the bar.
    pub ends: [usize; 2],
    /// The distance from the first.
    pub at: Number,
}
