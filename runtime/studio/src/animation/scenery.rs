//! What stands still and what happens, as the page reads it.

use liftoff::model::{Scenery, Shape};
use liftoff::{Event, Reaction};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct SceneryItem {
    name: &'static str,
    at: [f64; 2],
    shape: &'static str,
    /// The line's direction in rad, the circle's radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<f64>,
    /// Whether a circle's inside is free.
    inside: bool,
}

impl SceneryItem {
    pub fn of(scenery: &Scenery) -> Self {
        let (shape, number, inside) = match scenery.shape {
            Shape::Line { angle } => ("line", Some(angle), false),
            Shape::Guide { angle } => ("guide", Some(angle), false),
            Shape::Circle { radius, inside } => ("circle", Some(radius), inside),
            Shape::Corner => ("corner", None, false),
            Shape::Pin => ("pin", None, false),
            Shape::Point => ("point", None, false),
        };
        Self { name: scenery.name, at: scenery.at, shape, number, inside }
    }
}

#[derive(Serialize)]
pub(super) struct EventItem {
    t: f64,
    kind: String,
    supports: Vec<&'static str>,
    impulses: Vec<Impulse>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

#[derive(Serialize)]
struct Impulse {
    contact: usize,
    /// The support, or the whole contact where shares are not determined.
    label: String,
    value: f64,
}

impl EventItem {
    pub fn of(event: &Event) -> Self {
        let impulses = event.impulses.iter();
        let impulse =
            |of: &Reaction| Impulse { contact: of.contact, label: of.label.clone(), value: of.value };
        Self {
            t: event.t,
            kind: event.kind.to_string(),
            supports: event.supports.clone(),
            impulses: impulses.map(impulse).collect(),
            note: event.note.as_ref().map(ToString::to_string),
        }
    }
}
