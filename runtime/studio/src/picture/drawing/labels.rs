//! Words where nothing else is: each takes the place, of those round its point, that covers the least.

use super::canvas::{Canvas, Placement};
use super::plane::{Box2, Px, dot, towards};
use super::script::Script;
use crate::plot::Colour;
use core::f64::consts::TAU;

/// A word in its place.
#[derive(Clone, Debug)]
pub(super) struct PlacedLabel {
    pub text: Script,
    pub size: f64,
    pub colour: Colour,
    pub area: Box2,
}

/// Room round lines and words that stays free, pixels.
const ROOM: f64 = 2.0;
/// Directions round a point that are tried.
const SIDES: u32 = 16;
/// Distances that are tried, each a step more; the last is beyond everything.
const RINGS: u32 = 40;
const STEP: f64 = 5.0;

/// What a crossed line costs, in pixels of distance.
const CROSSED: f64 = 40.0;
/// What it costs to stand opposite to the wished side.
const TURNED: f64 = 9.0;

/// All words of the canvas, none over another.
pub(super) fn placed(canvas: &Canvas) -> Vec<PlacedLabel> {
    let lines: Vec<[Px; 2]> = canvas
        .shapes
        .iter()
        .flat_map(|shape| shape.outline().windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>())
        .collect();
    let mut labels: Vec<PlacedLabel> = Vec::new();
    for placement in &canvas.placements {
        labels.push(best(placement, &lines, &labels));
    }
    labels
}

fn best(placement: &Placement, lines: &[[Px; 2]], placed: &[PlacedLabel]) -> PlacedLabel {
    let mut found: Option<(f64, Box2)> = None;
    for ring in 0..RINGS {
        let out = STEP * f64::from(ring);
        if found.is_some_and(|(cost, _)| cost <= out) {
            break;
        }
        for side in 0..SIDES {
            let direction = towards(TAU * f64::from(side) / f64::from(SIDES));
            let area = placement.beside(direction, out);
            if placed.iter().any(|label| label.area.overlaps(area.wider(ROOM))) {
                continue;
            }
            let free = area.wider(ROOM);
            let crossed = lines.iter().filter(|[a, b]| free.clip(*a, *b).is_some()).count();
            let cost = out + CROSSED * crossed as f64 + TURNED * (1.0 - dot(direction, placement.side));
            if found.is_none_or(|(least, _)| cost < least) {
                found = Some((cost, area));
            }
        }
    }
    let below = || {
        let lowest = placed.iter().map(|label| label.area.most[1]).fold(placement.at[1], f64::max);
        placement.beside([0.0, 1.0], lowest - placement.at[1] + ROOM)
    };
    let area = found.map_or_else(below, |(_, area)| area);
    PlacedLabel { text: placement.text.clone(), size: placement.size, colour: placement.colour, area }
}
