//! How a model looks: forms with a role, between points and at places that parameters determine.
//! They tell what is drawn and measured, not what kind of joint or support it stands for.
//!
//! A `usize` called a point is an index into [`Layout::points`](super::Layout::points).

mod measured;
mod moving;
mod places;
mod standing;

pub use measured::{Length, Reading};
pub use moving::{Block, Body, Look, Mark, Round, Section, Spiral, Spring, Thread};
pub use places::{Direction, Number, Spot};
pub use standing::{Fixture, Push, Shape, Solid};

/// What is seen of a model, whatever the values of its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Geometry {
    /// Rigid bodies, one for each of [`Layout::bars`](super::Layout::bars).
    pub bodies: &'static [Body],
    /// Discs, and circles that move.
    pub rounds: &'static [Round],
    /// Threads.
    pub threads: &'static [Thread],
    /// Springs and dampers between points.
    pub springs: &'static [Spring],
    /// Torsion springs.
    pub spirals: &'static [Spiral],
    /// Blocks that slide on guides.
    pub blocks: &'static [Block],
    /// Marks at points, in drawing order.
    pub marks: &'static [Mark],
    /// Surfaces and lines that stand still.
    pub fixtures: &'static [Fixture],
    /// Sections of bars.
    pub sections: &'static [Section],
    /// What each coordinate measures, in the layout's order.
    pub readings: &'static [Reading],
    /// Lengths of bars, one for all that have it.
    pub lengths: &'static [Length],
    /// Where supports and threads push or pull.
    pub pushes: &'static [Push],
    /// The components of gravity.
    pub gravity: Option<[Number; 2]>,
}

impl Geometry {
    /// Nothing.
    pub const EMPTY: Self = Self {
        bodies: &[],
        rounds: &[],
        threads: &[],
        springs: &[],
        spirals: &[],
        blocks: &[],
        marks: &[],
        fixtures: &[],
        sections: &[],
        readings: &[],
        lengths: &[],
        pushes: &[],
        gravity: None,
    };

    /// The first place where what has this name pushes.
    pub fn push(&self, support: &str) -> Option<&'static Push> {
        self.pushes.iter().find(|push| push.support == support)
    }

    /// The points that have such a mark.
    pub fn marked(&self, look: Look) -> impl Iterator<Item = usize> + use<> {
        self.marks.iter().filter(move |mark| mark.look == look).map(|mark| mark.point)
    }

    /// The points of the ground: those with a foot, then all others.
    pub fn grounded(&self) -> impl Iterator<Item = (usize, Look)> + use<> {
        let marks = self.marks;
        let feet = move || marks.iter().filter(|mark| mark.look == Look::Foot);
        let others = marks.iter().filter(move |mark| match mark.look {
            Look::Ground | Look::Peg => feet().all(|foot| foot.point != mark.point),
            _ => false,
        });
        feet().chain(others).map(|mark| (mark.point, mark.look))
    }
}

#[cfg(test)]
mod tests;
