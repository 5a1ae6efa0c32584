//! What stands still and what happens, as the page reads it.

use super::rounds::Solid;
use crate::registry::Configuration;
use liftoff::{Event, Reaction};
use liftoff_core::model::geometry::{self, Look};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct SceneryItem {
    name: &'static str,
    at: [f64; 2],
    #[serde(flatten)]
    shape: Shape,
}

#[derive(Serialize)]
#[serde(tag = "shape", rename_all = "lowercase")]
enum Shape {
    Line { angle: f64, solid: bool },
    Circle { radius: f64, solid: Solid },
    Wedge,
    Foot,
    Cross,
}

/// Supports and guides, then the points of the ground.
pub(super) fn scenery(start: &Configuration) -> Vec<SceneryItem> {
    let (geometry, names) = (start.geometry(), start.layout.points);
    let fixture = |fixture: &geometry::Fixture| {
        let shape = match fixture.shape {
            geometry::Shape::Line { angle, solid } => Shape::Line { angle: start.number(angle), solid },
            geometry::Shape::Circle { radius, solid, .. } => {
                Shape::Circle { radius: start.number(radius), solid: solid.into() }
            }
            geometry::Shape::Wedge => Shape::Wedge,
        };
        SceneryItem { name: fixture.name, at: start.position(fixture.at), shape }
    };
    let point = |(point, look): (usize, Look)| {
        let shape = if look == Look::Foot { Shape::Foot } else { Shape::Cross };
        SceneryItem { name: names[point], at: start.points[point], shape }
    };
    geometry.fixtures.iter().map(fixture).chain(geometry.grounded().map(point)).collect()
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
    pub fn from_event(event: &Event) -> Self {
        let impulses = event.impulses.iter();
        let impulse =
            |of: &Reaction| Impulse { contact: of.contact, label: of.label.to_owned(), value: of.value };
        Self {
            t: event.t,
            kind: event.kind.to_string(),
            supports: event.supports.clone(),
            impulses: impulses.map(impulse).collect(),
            note: event.note.as_ref().map(ToString::to_string),
        }
    }
}
