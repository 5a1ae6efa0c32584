//! What is to be followed, and what comes of it.

use crate::condition::Condition;
use crate::scene::SceneError;
use liftoff_core::scalar::DoubleDouble;

/// Why a motion is not judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotJudged {
    /// The declaration has no scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A start that the constraints do not allow.
    #[error("the start is {0:.0e} lengths off its constraints")]
    Start(f64),
    /// A name that the declaration does not have.
    #[error("`{0}` is not in the declaration")]
    Name(String),
    /// The equations have no solution.
    #[error("the equations are singular at t = {0}")]
    Singular(f64),
    /// No contact set is admissible.
    #[error("no contact set is admissible at t = {0}")]
    Jammed(f64),
    /// More rough contacts than are tried, or rough ones with restitution.
    #[error("the rough contacts at t = {0} are beyond the judge")]
    Rough(f64),
    /// The end of a bar passes a corner from outside.
    #[error("the end of a bar meets a corner at t = {0}")]
    Corner(f64),
    /// A value is not finite.
    #[error("the motion is not finite at t = {0}")]
    NotFinite(f64),
    /// Steps or work are used up.
    #[error("the work limit is reached at t = {0}")]
    Work(f64),
    /// Powers of its natural time are no numbers.
    #[error("motions whose natural time is {0:.0e} are beyond the judge")]
    Scale(f64),
    /// Nothing follows from such a tolerance.
    #[error("at the tolerance {0} the events of a run are not reliable")]
    Coarse(f64),
    /// Nothing was computed.
    #[error("there is no motion")]
    Empty,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Contacts are struck.
    Impact,
    /// Contacts open.
    Open,
    /// Corners have reached the end of their bar.
    SlideOff,
    /// Infinitely many impacts have come to their end.
    Settle,
    /// Contacts have been taken away.
    Remove,
    /// An impulse has been applied.
    Impulse,
    /// A condition is met, or a contact that ends the motion is struck: it ends in this state.
    Stop,
}

/// Something that happened.
#[derive(Clone, Debug)]
pub struct Event {
    /// When.
    pub t: DoubleDouble,
    /// What.
    pub change: Change,
    /// To which contacts, by their places in the declaration.
    pub contacts: Vec<usize>,
    /// Those that are closed after it.
    pub closed: Vec<usize>,
    /// Coordinates, then rates, after it.
    pub state: Vec<DoubleDouble>,
}

/// What is done to a system from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Contacts of these names are taken away.
    Remove(Vec<String>),
    /// An impulse is applied at a point.
    Impulse {
        /// The point.
        point: String,
        /// Its components.
        impulse: [f64; 2],
    },
}

/// A motion as far as it was followed.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// In order of time.
    pub events: Vec<Event>,
    /// States at the times asked for.
    pub samples: Vec<(f64, Vec<DoubleDouble>)>,
    /// Coordinates, then rates, at the end.
    pub end: Vec<DoubleDouble>,
    /// Why it ends before it should.
    pub stopped: Option<NotJudged>,
    /// What it took: for each expansion the operations of the scene times the square of the terms.
    /// A clock would judge otherwise on another machine.
    pub work: u64,
}

/// Where and how long to follow.
#[derive(Clone, Debug)]
pub struct Task<'a> {
    /// When it begins.
    pub t: f64,
    /// Coordinates, then rates.
    pub state: &'a [f64],
    /// When it ends.
    pub until: f64,
    /// Contacts that do not open.
    pub held: &'a [String],
    /// What is done, and when, in order of time.
    pub actions: &'a [(f64, Action)],
    /// What is waited for.
    pub conditions: &'a [Condition],
    /// Whether any impact ends it.
    pub ends_at_impacts: bool,
    /// Entries of the state that the others follow from, as far as contacts are closed; all if
    /// there are none.
    pub kept: &'a [usize],
    /// Terms of the series; [`Task::TERMS`].
    pub terms: usize,
    /// Times at which the state is wanted, in order.
    pub samples: &'a [f64],
    /// The most work it may take, [`Motion::work`].
    pub most_work: u64,
}

impl Default for Task<'_> {
    fn default() -> Self {
        Task::new(&[], 0.0)
    }
}

impl Task<'_> {
    /// Terms of series unless others are asked for.
    pub const TERMS: usize = 28;

    /// The work that a motion takes at most unless more is allowed: that of a minute, or so.
    pub const WORK: u64 = 6_000_000_000;

    /// Nothing but the fall from a state for a time.
    pub fn new(state: &[f64], until: f64) -> Task<'_> {
        Task {
            t: 0.0,
            state,
            until,
            held: &[],
            actions: &[],
            conditions: &[],
            ends_at_impacts: false,
            kept: &[],
            terms: Task::TERMS,
            samples: &[],
            most_work: Task::WORK,
        }
    }
}
