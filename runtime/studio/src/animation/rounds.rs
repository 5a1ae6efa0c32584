//! Circles about points, in the form for the page's script.

use super::place::Direction;
use crate::registry::Configuration;
use liftoff_core::model::geometry;
use serde::Serialize;

/// A circle about a point.
#[derive(Serialize)]
pub(super) struct Round {
    centre: usize,
    radius: f64,
    solid: Solid,
    /// A direction fixed in the circle's body.
    along: Option<Direction>,
}

/// The solid side of a circle.
#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Solid {
    Within,
    Around,
    Nowhere,
}

impl Round {
    pub fn new(round: &geometry::Round, start: &Configuration) -> Self {
        Self {
            centre: round.centre,
            radius: start.number(round.radius),
            solid: round.solid.into(),
            along: round.along.map(|along| Direction::new(along, start)),
        }
    }
}

impl From<geometry::Solid> for Solid {
    fn from(solid: geometry::Solid) -> Self {
        match solid {
            geometry::Solid::Within => Self::Within,
            geometry::Solid::Around => Self::Around,
            geometry::Solid::Nowhere => Self::Nowhere,
        }
    }
}
