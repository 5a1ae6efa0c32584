//! Events of a motion.

pub(crate) mod detection;
mod filter;
mod note;
mod occurrence;

pub use detection::{FrictionGuard, Guard};
pub use filter::EventFilter;
pub use note::{FrictionState, ImpactOrder, Note};
pub use occurrence::Occurrence;

use core::fmt;

use crate::expression::{significant, unrounded};
use crate::model::{ContactSet, Coordinate, Energy, Layout};

/// Significant digits of a number in an event's line.
const DIGITS: usize = 4;

/// Something that happened.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Event {
    /// Time, s.
    pub t: f64,
    /// What happens.
    pub kind: EventKind,
    /// The supports it happened to, in alphabetical order.
    pub supports: Vec<&'static str>,
    /// The full state after it: coordinates, then rates.
    pub state: Vec<f64>,
    /// Kinetic and potential energy after it, J.
    pub energy: Energy<f64>,
    /// What an impact or an impulse found; none of events at which no velocity jumps.
    pub before: Option<PreImpact>,
    /// Reactions after the event.
    pub reactions: Vec<Reaction>,
    /// Impulses of the contacts that are named here, of all contacts where an impulse was applied;
    /// empty for events that are no impacts.
    pub impulses: Vec<Reaction>,
    /// What else there is to say.
    pub note: Option<Note>,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) coordinates: &'static [Coordinate],
    /// Value and rate of each dependent angle.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) dependent: Vec<(&'static str, [f64; 2])>,
    /// Natural length of the run, m.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) length: f64,
}

impl Event {
    /// A coordinate `phi`, a rate `phi'` or the time `t` by its name, after the event; none where
    /// the model has no such name.
    ///
    /// ```
    /// # use liftoff::prelude::*;
    /// # /// A bar that swings.
    /// # #[derive(BarSystem)]
    /// # #[gravity(g)]
    /// # #[bar(OA, mass = m, length = l)]
    /// # #[pin(O = (0, 0))]
    /// # #[figure(A = (0, -l))]
    /// # #[coordinate(phi = angle(OA), from = down)]
    /// # struct Pendulum { m: f64, l: f64, g: f64 }
    /// # let pendulum = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
    /// let run = Simulation::new(&pendulum)?.start(Pose::new("phi", 1.0))?.until("phi = 0.5")?.run()?;
    /// let stop = run.events().last().expect("an end");
    /// assert!((stop["phi"] - 0.5).abs() < 1e-12 && stop["phi'"] < 0.0);
    /// assert!(stop.get("psi").is_none());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn get(&self, name: &str) -> Option<f64> {
        self.entry(name).copied()
    }

    fn entry(&self, name: &str) -> Option<&f64> {
        let (bare, rates) = name.strip_suffix('\'').map_or((name, 0), |bare| (bare, self.coordinates.len()));
        let follows = || {
            let (_, motion) = self.dependent.iter().find(|(known, _)| *known == bare)?;
            Some(&motion[usize::from(bare != name)])
        };
        match self.coordinates.iter().position(|coordinate| coordinate.name == bare) {
            Some(place) => self.state.get(rates + place),
            None => follows().or_else(|| (name == "t").then_some(&self.t)),
        }
    }

    /// The reaction of a support, or of the contact it belongs to where the supports' shares are
    /// not determined; none where the model has no such support.
    pub fn reaction(&self, support: &str) -> Option<f64> {
        let is = |reaction: &&Reaction| reaction.label.split(',').any(|label| label.trim() == support);
        self.reactions.iter().find(is).map(|reaction| reaction.value)
    }

    /// Whether the motion may as well go on otherwise, for all that the tolerance tells: a touch
    /// may have been a crossing, what has come to rest at its limit of friction may slide.
    pub fn is_undecided(&self) -> bool {
        match &self.note {
            Some(Note::Undecided | Note::GapUndecided) => true,
            Some(Note::Friction(states)) => states.iter().any(|state| state.undecided),
            _ => false,
        }
    }
}

/// The motion just before an impact or an impulse.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PreImpact {
    /// The full state: coordinates, then rates.
    pub state: Vec<f64>,
    /// Kinetic and potential energy, J.
    pub energy: Energy<f64>,
    /// The contacts that bear.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) active_basis: ContactSet,
    /// The impulses of all rows, N s or N m s; none where one was applied.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) impulses: Vec<f64>,
}

/// A coordinate, a rate or the time by its name: `event["phi'"]`; [`Event::get`] does not panic.
impl core::ops::Index<&str> for Event {
    type Output = f64;

    /// # Panics
    /// The model has no such name.
    fn index(&self, name: &str) -> &f64 {
        let dependent = || self.dependent.iter().map(|(name, _)| *name);
        let names = || self.coordinates.iter().map(|coordinate| coordinate.name).chain(dependent());
        let known = || names().collect::<Vec<_>>().join(", ");
        self.entry(name).unwrap_or_else(|| panic!("no coordinate `{name}` in an event; known: {}", known()))
    }
}

/// Kinds of [`Event`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum EventKind {
    /// The run begins.
    Start,
    /// Contacts open: their reactions have fallen to zero.
    Open,
    /// Threads open: their tensions have fallen to zero.
    Slack,
    /// Contacts are struck.
    Impact,
    /// Threads become taut, with a jerk.
    Taut,
    /// Impacts of shrinking intervals have come to their end: the contacts stay closed.
    Settle,
    /// Contacts close; the run ends.
    Close,
    /// A reaction or a gap touches zero and comes back.
    Touch,
    /// Contacts that stuck begin to slide: their friction forces have reached their limits.
    Slip,
    /// Contacts that slid stick.
    Stick,
    /// Contacts slide back: their slip velocities change their signs.
    Reverse,
    /// Guides with friction press to the other side: their reactions have changed their signs.
    Side,
    /// A corner has reached the end of its bar and is open from there on.
    SlideOff,
    /// A support has been taken away.
    Release,
    /// A thread has been cut.
    Cut,
    /// Contacts are there from now on: the conditions on which they are have come to hold.
    Arm,
    /// Contacts are not there any more: their conditions hold no longer.
    Disarm,
    /// An impulse has been applied.
    Impulse,
    /// A condition is met; the run ends.
    Stop,
    /// The time limit is reached; the run ends.
    End,
}

impl EventKind {
    /// All kinds.
    pub const ALL: [Self; 20] = [
        Self::Start,
        Self::Open,
        Self::Slack,
        Self::Impact,
        Self::Taut,
        Self::Settle,
        Self::Close,
        Self::Touch,
        Self::Slip,
        Self::Stick,
        Self::Reverse,
        Self::Side,
        Self::SlideOff,
        Self::Release,
        Self::Cut,
        Self::Arm,
        Self::Disarm,
        Self::Impulse,
        Self::Stop,
        Self::End,
    ];

    /// Its name: `open`, `slide-off`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Open => "open",
            Self::Slack => "slack",
            Self::Impact => "impact",
            Self::Taut => "taut",
            Self::Settle => "settle",
            Self::Close => "close",
            Self::Touch => "touch",
            Self::Slip => "slip",
            Self::Stick => "stick",
            Self::Reverse => "reverse",
            Self::Side => "side",
            Self::SlideOff => "slide-off",
            Self::Release => "release",
            Self::Cut => "cut",
            Self::Arm => "arm",
            Self::Disarm => "disarm",
            Self::Impulse => "impulse",
            Self::Stop => "stop",
            Self::End => "end",
        }
    }
}

impl fmt::Display for EventKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for EventKind {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Note {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The reaction or impulse of a support, or of a contact whose supports' shares are not determined.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reaction {
    /// Index of the contact.
    pub contact: usize,
    /// The support `A`, or the whole contact `A, C, E`.
    pub label: &'static str,
    /// Positive where it pushes.
    pub value: f64,
    /// The friction force or impulse along the tangent, of a contact that has friction.
    pub friction: Option<f64>,
}

/// Reactions by support where the shares are determined, by contact elsewhere; of values as a phase
/// has them, or of all rows of the kernel.
pub(crate) fn reactions(layout: &Layout, values: &[f64]) -> Vec<Reaction> {
    let by_rows = values.len() == layout.rows();
    let place = |k: usize| if by_rows { layout.frictions[k].row } else { layout.contacts.len() + k };
    let mut all = Vec::with_capacity(layout.contacts.len());
    for (i, (contact, &value)) in layout.contacts.iter().zip(values).enumerate() {
        let friction = contact.friction.and_then(|k| values.get(place(k)));
        let one = |label: &'static str, members: f64| Reaction {
            contact: i,
            label,
            value: value / members,
            friction: friction.map(|force| force / members),
        };
        if contact.shared {
            let members = contact.supports.len() as f64;
            all.extend(contact.supports.iter().map(|support| one(support, members)));
        } else {
            all.push(one(contact.label, 1.0));
        }
    }
    all
}

/// The supports of a set of contacts by name, so that mirror images do not stand apart: A, C, E.
pub(crate) fn supports(layout: &Layout, set: ContactSet) -> Vec<&'static str> {
    let mut supports: Vec<_> = set.iter().flat_map(|i| layout.contacts[i].supports.iter().copied()).collect();
    supports.sort_unstable();
    supports
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.supports.is_empty() {
            write!(f, "{} ", self.supports.join(", "))?;
        }
        write!(f, "{} at t = {}", self.kind, significant(self.t, DIGITS))?;
        for (coordinate, value) in self.coordinates.iter().zip(&self.state) {
            let unit = if coordinate.is_angle { 1.0 } else { self.length };
            write!(f, ", {} = {}", coordinate.name, significant(unrounded(*value, unit), DIGITS))?;
        }
        for (name, [value, _]) in &self.dependent {
            write!(f, ", {name} = {}", significant(unrounded(*value, 1.0), DIGITS))?;
        }
        self.note.as_ref().map_or(Ok(()), |note| write!(f, " ({note})"))
    }
}

#[cfg(test)]
mod tests;
