//! How a model looks: forms with a role, between points and at places that parameters determine.
//! Here kinds of joints, supports and loads become forms; what draws them knows forms only. The
//! runtime has the same types, filled by `emit`.
//!
//! - `forms`: what there is to draw; `numbers`: what depends on the parameters; `bodies`: what
//!   moves, and marks at points;
//! - `contacts`: what stands still, where it pushes; `measured`: what coordinates and lengths
//!   measure.

mod bodies;
mod contacts;
mod forms;
mod measured;
mod numbers;
#[cfg(test)]
mod tests;

use crate::algebra::Series;
use crate::kinematics::Coordinate;
use crate::system::System;

pub use forms::{
    DrawnBody, DrawnDirection, DrawnReading, DrawnSection, DrawnShape, DrawnSpring, DrawnThread, Fixture,
    Length, Look, Push, Round, Solid, Spot,
};
pub use numbers::{Number, Numbers, Value};

/// Everything that is drawn of a model.
#[derive(Clone, Debug)]
pub struct Geometry {
    /// Outline and other points of each body.
    pub bodies: Vec<DrawnBody>,
    /// Discs, and circles that move.
    pub rounds: Vec<Round>,
    /// Threads.
    pub threads: Vec<DrawnThread>,
    /// Springs and dampers.
    pub springs: Vec<DrawnSpring>,
    /// Torsion springs: the point, and where the inner end points.
    pub spirals: Vec<(usize, DrawnDirection)>,
    /// Blocks: the point, and the direction in which it slides.
    pub blocks: Vec<(usize, DrawnDirection)>,
    /// Marks at points.
    pub marks: Vec<(usize, Look)>,
    /// What stands still.
    pub fixtures: Vec<Fixture>,
    /// Sections of bars.
    pub sections: Vec<DrawnSection>,
    /// What each coordinate measures.
    pub readings: Vec<DrawnReading>,
    /// Lengths of bars, each once.
    pub lengths: Vec<Length>,
    /// Where supports and threads push or pull.
    pub pushes: Vec<Push>,
    /// Components of gravity.
    pub gravity: Option<[Number; 2]>,
    /// What [`Number`] is an index into.
    pub numbers: Numbers,
}

/// The system, and the numbers so far.
struct GeometryDraft<'a> {
    system: &'a System,
    numbers: Numbers,
}

impl Geometry {
    /// Of a system with its coordinates.
    pub fn from_system(system: &System, coordinates: &[Coordinate]) -> Self {
        let mut draft = GeometryDraft { system, numbers: Numbers::default() };
        Self {
            bodies: draft.bodies(),
            rounds: draft.rounds(),
            threads: draft.threads(),
            springs: draft.springs(),
            spirals: draft.spirals(),
            blocks: draft.blocks(),
            marks: draft.marks(),
            fixtures: draft.fixtures(),
            sections: draft.sections(),
            readings: coordinates.iter().map(|coordinate| draft.reading(&coordinate.reading)).collect(),
            lengths: draft.lengths(),
            pushes: draft.pushes(),
            gravity: system.gravity.as_ref().map(|components| draft.numbers.position(components)),
            numbers: draft.numbers,
        }
    }
}

impl GeometryDraft<'_> {
    /// The first and the last point of a body.
    fn ends(&self, body: usize) -> [usize; 2] {
        [self.system.bodies[body].from, self.system.bodies[body].to]
    }

    /// The first axis of a body's frame.
    fn axis(&mut self, body: usize) -> DrawnDirection {
        let [from, to] = self.ends(body);
        match self.system.oblique(body) {
            Some(step) => DrawnDirection::Axis([from, to], self.numbers.position(&step)),
            None => DrawnDirection::Towards(Spot::Point(from), Spot::Point(to)),
        }
    }

    /// A length or the like in print: `½ l`; nothing of a plain number.
    fn text(&self, series: &Series) -> String {
        series.as_constant().map_or_else(|| series.text(&self.system.names()), |_| String::new())
    }
}
