//! A second opinion on motions, from the declaration alone.
//!
//! What is judged is told in plain numbers, a [`Record`]; nothing of the engine, its equations or
//! its decisions has a part here. Of the generator only the resolved declaration is read: names,
//! points, figure, sides.
//!
//! - [`scene`]: the declaration in maximal coordinates, on a [`tape`] of its own.
//! - `expansion`: motion as power series in time, order by order from one dense factorisation.
//! - `decision`, `impact`: which contacts stay closed, and what an impact does.
//! - `motion`: the motion followed, with the events that the judge finds itself.
//! - `condition`: what a motion is asked to end by.
//! - `audit`: what must hold of any motion; `verdict`: a motion against the judge's own.

mod audit;
mod condition;
mod decision;
mod expansion;
mod impact;
mod motion;
mod numerics;
mod place;
mod record;
mod verdict;

pub mod scene;
pub mod tape;

use liftoff_core::scalar::DoubleDouble;
use scene::{Scene, SceneError};

pub use condition::{Condition, Expression, Function, Operator, Relation};
pub use motion::{Action, Change, Event, Motion, NotJudged, Task};
pub use record::{MotionSegment, Record, RecordedEvent, Verdict};

/// A declared system with values of its parameters, by which motions are judged.
pub struct Judge {
    scene: Scene<DoubleDouble>,
}

/// The square of its reciprocal, times the square of the unit roundoff, is no less than the least
/// normal number.
const LARGE: f64 = 1e137;

impl Judge {
    /// The judge of a declaration with values of its parameters; states are told in these
    /// coordinates.
    ///
    /// # Errors
    /// The declaration is not understood, or too large; or parameters are so far from one that
    /// products of double-doubles lose their second half.
    pub fn new(declaration: &str, parameters: &[f64], coordinates: &[&str]) -> Result<Self, SceneError> {
        let is_far = |x: f64| x != 0.0 && !(1.0 / LARGE..=LARGE).contains(&x.abs());
        if let Some(&far) = parameters.iter().find(|x| is_far(**x)) {
            return Err(SceneError::Range(format!("{far:e}")));
        }
        Ok(Self { scene: Scene::new(declaration, parameters, coordinates)? })
    }

    /// The motion by itself, in double-double.
    pub fn follow<'a>(&'a self, task: &Task<'a>) -> Motion {
        motion::follow(&self.scene, task)
    }

    /// The motion of a record by itself, in double-double: start, what is held, done and waited for
    /// are those of the record, all else is the task's.
    pub fn repeated(&self, record: &Record, task: Task) -> Motion {
        verdict::repeated(&self.scene, record, task)
    }

    /// What must hold of any motion: no jump, no penetration, nothing that pulls, no energy gained.
    pub fn audit(&self, record: &Record) -> Verdict {
        audit::audit(&self.scene, record)
    }

    /// An audit, then the motion against the judge's own, which may take so much work.
    pub fn verdict(&self, record: &Record, most_work: u64) -> Verdict {
        verdict::verdict(&self.scene, record, most_work)
    }

    /// Names of the contacts, in the order of their places.
    pub fn contacts(&self) -> impl Iterator<Item = &str> {
        self.scene.contacts.iter().map(|contact| contact.name.as_str())
    }
}
