//! The forms of a model as the page reads them: points by their indices, what stands still by its
//! place.

use super::place::{Direction, Spot};
use super::rounds::Round;
use crate::registry::Configuration;
use liftoff_core::model::geometry::{self, Look};
use liftoff_core::model::{ContactKind, Layout};
use serde::Serialize;

/// What moves, and where contacts act.
#[derive(Serialize)]
pub(super) struct Geometry {
    pub bodies: Vec<Body>,
    rounds: Vec<Round>,
    /// Points that have a mass of their own.
    masses: Vec<usize>,
    pub springs: Vec<Spring>,
    threads: Vec<Thread>,
    /// Blocks on bars; on a line that stands still the point alone is seen.
    blocks: Vec<Block>,
    /// In order of the layout's contacts.
    pub contacts: Vec<Contact>,
}

#[derive(Serialize)]
pub(super) struct Body {
    name: &'static str,
    /// Its points: two ends, or the corners of a polygon.
    outline: &'static [usize],
}

#[derive(Serialize)]
pub(super) struct Spring {
    name: &'static str,
    ends: [usize; 2],
    coil: bool,
}

#[derive(Serialize)]
struct Thread {
    name: &'static str,
    path: &'static [usize],
    /// The contact that is closed while it is taut.
    contact: Option<usize>,
}

#[derive(Serialize)]
struct Block {
    point: usize,
    along: Direction,
}

#[derive(Serialize)]
pub(super) struct Contact {
    label: &'static str,
    /// How many members bear equal shares; none if only the total is known.
    shares: Option<usize>,
    /// Whether it pulls.
    pulls: bool,
    pub pushes: Vec<Push>,
}

/// Where a contact acts, and which way.
#[derive(Serialize)]
pub(super) struct Push {
    support: &'static str,
    at: Spot,
    /// How far the rim is that touches, against the reaction.
    rim: f64,
    along: Direction,
    /// Quarter turns from there to the reaction.
    turns: u8,
    /// The quarter turn from there to a positive tangential reaction.
    pub slip: i8,
}

impl Geometry {
    /// Of a model as it starts.
    pub fn new(start: &Configuration) -> Self {
        let (layout, forms) = (start.layout, start.geometry());
        let bodies = layout.bars.iter().zip(forms.bodies);
        let springs = forms.springs.iter();
        let moving = |block: &&geometry::Block| !matches!(block.along, geometry::Direction::Fixed(_));
        let blocks = forms.blocks.iter().filter(moving);
        Self {
            bodies: bodies.map(|(bar, body)| Body { name: bar.name, outline: body.outline }).collect(),
            rounds: forms.rounds.iter().map(|round| Round::new(round, start)).collect(),
            masses: forms.marked(Look::Mass).collect(),
            springs: springs
                .map(|spring| Spring { name: spring.name, ends: spring.ends, coil: spring.coil })
                .collect(),
            threads: forms.threads.iter().map(|thread| Thread::new(thread, layout)).collect(),
            blocks: blocks
                .map(|block| Block { point: block.point, along: Direction::new(block.along, start) })
                .collect(),
            contacts: layout.contacts.iter().map(|contact| Contact::new(contact, start)).collect(),
        }
    }
}

impl Thread {
    fn new(thread: &geometry::Thread, layout: &Layout) -> Self {
        let contact = layout.contacts.iter().position(|contact| contact.supports.contains(&thread.name));
        Self { name: thread.name, path: thread.path, contact }
    }
}

impl Contact {
    fn new(contact: &liftoff_core::model::Contact, start: &Configuration) -> Self {
        let pushes = start.geometry().pushes;
        let of = |support: &'static str| pushes.iter().filter(move |push| push.support == support);
        let pushes = contact.supports.iter().flat_map(|support| of(support));
        Self {
            label: contact.label,
            shares: contact.shared.then_some(contact.supports.len()),
            pulls: contact.kind == ContactKind::Thread,
            pushes: pushes.map(|push| Push::new(push, start)).collect(),
        }
    }
}

impl Push {
    fn new(push: &geometry::Push, start: &Configuration) -> Self {
        let (at, along) = (Spot::new(push.at, start), Direction::new(push.along, start));
        let rim = push.rim.map_or(0.0, |rim| start.number(rim));
        Self { support: push.support, at, rim, along, turns: push.turns, slip: push.slip }
    }
}
