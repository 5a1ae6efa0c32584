//! Words where nothing else is: each takes the place, of those round its point, that covers the
//! least.

use super::canvas::{Canvas, Placement, Spot};
use super::plane::{Box2, Px, add, dot, minus, towards};
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
    /// How far from the best place, in pixels.
    cost: f64,
}

/// Room round lines and words that stays free, pixels.
const ROOM: f64 = 2.0;
/// Room between two words, wider along the line so that they are not read as one.
const APART: Px = [9.0, 2.0];
/// Directions round a point that are tried.
const SIDES: u32 = 16;
/// Distances that are tried, each a step more; the last is beyond everything.
const RINGS: u32 = 40;
const STEP: f64 = 5.0;

/// What a crossed line costs, in pixels of distance.
const CROSSED: f64 = 40.0;
/// What it costs to stand opposite to the wished side.
const TURNED: f64 = 9.0;
/// What it costs to stand at the next best spot of a line.
const MOVED: f64 = 4.0;
/// How often every word asks those in its place to go elsewhere.
const ROUNDS: usize = 2;

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
    for _ in 0..ROUNDS {
        for k in 0..labels.len() {
            if let Some(better) = made_way(k, canvas, &lines, &labels) {
                labels = better;
            }
        }
    }
    labels
}

/// The words with the `k`th where it would stand alone and those in its way elsewhere, if all
/// together are nearer to their best places.
fn made_way(
    k: usize,
    canvas: &Canvas,
    lines: &[[Px; 2]],
    labels: &[PlacedLabel],
) -> Option<Vec<PlacedLabel>> {
    let wished = best(&canvas.placements[k], lines, &[]);
    if labels[k].cost <= wished.cost {
        return None;
    }
    let place = apart(wished.area);
    let others = (0..labels.len()).filter(|i| *i != k);
    let (evicted, mut order): (Vec<usize>, Vec<usize>) =
        others.partition(|&i| labels[i].area.overlaps(place));
    let mut placed: Vec<PlacedLabel> = order.iter().map(|&i| labels[i].clone()).collect();
    placed.push(wished);
    order.push(k);
    for i in evicted {
        placed.push(best(&canvas.placements[i], lines, &placed));
        order.push(i);
    }
    let total = |labels: &[PlacedLabel]| labels.iter().map(|label| label.cost).sum::<f64>();
    (total(&placed) < total(labels)).then(|| {
        let mut all: Vec<_> = order.into_iter().zip(placed).collect();
        all.sort_by_key(|(i, _)| *i);
        all.into_iter().map(|(_, label)| label).collect()
    })
}

/// The room that a word has for itself.
fn apart(area: Box2) -> Box2 {
    Box2 { least: minus(area.least, APART), most: add(area.most, APART) }
}

fn best(placement: &Placement, lines: &[[Px; 2]], placed: &[PlacedLabel]) -> PlacedLabel {
    let mut found: Option<(f64, Box2)> = None;
    for ((ring, spot), side) in tries(placement) {
        let out = STEP * f64::from(ring) + MOVED * spot as f64;
        if found.is_some_and(|(cost, _)| cost <= out) {
            continue;
        }
        let (spot, direction) = (placement.at[spot], towards(TAU * f64::from(side) / f64::from(SIDES)));
        let area = placement.beside(spot, direction, STEP * f64::from(ring));
        let (free, alone) = (area.wider(ROOM), apart(area));
        if placed.iter().any(|label| label.area.overlaps(alone)) {
            continue;
        }
        let crossed = lines.iter().filter(|[a, b]| free.clip(*a, *b).is_some()).count();
        let cost = out + CROSSED * crossed as f64 + TURNED * (1.0 - dot(direction, spot.side));
        if found.is_none_or(|(least, _)| cost < least) {
            found = Some((cost, area));
        }
    }
    let (cost, area) = found.unwrap_or_else(|| (f64::INFINITY, below(placement, placed)));
    PlacedLabel { text: placement.text.clone(), size: placement.size, colour: placement.colour, area, cost }
}

/// Rings, spots and sides, near ones first.
fn tries(placement: &Placement) -> impl Iterator<Item = ((u32, usize), u32)> {
    let spots = placement.at.len();
    let near = (0..RINGS).flat_map(move |ring| (0..spots).map(move |spot| (ring, spot)));
    near.flat_map(|place| (0..SIDES).map(move |side| (place, side)))
}

/// Where nothing is: under all words.
fn below(placement: &Placement, placed: &[PlacedLabel]) -> Box2 {
    let spot = placement.at.first().copied().unwrap_or(Spot { at: [0.0; 2], side: [0.0, 1.0] });
    let lowest = placed.iter().map(|label| label.area.most[1]).fold(spot.at[1], f64::max);
    placement.beside(spot, [0.0, 1.0], lowest - spot.at[1] + ROOM)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(text: &str, at: &[Px]) -> Placement {
        let at = at.iter().map(|&at| Spot { at, side: [0.0, -1.0] }).collect();
        Placement { text: Script::upright(text), size: 15.0, colour: Colour::Black, at, clearance: 3.0 }
    }

    /// A word that came first and has two places leaves the one that is the only one of the next.
    #[test]
    fn a_word_makes_way_where_it_has_another_place() {
        let placements = vec![word("anywhere", &[[0.0, 0.0], [200.0, 0.0]]), word("here", &[[0.0, 0.0]])];
        let labels = placed(&Canvas { placements, ..Canvas::default() });
        let centres = labels.iter().map(|label| label.area.centre()[0]).collect::<Vec<_>>();
        assert_eq!(centres, [200.0, 0.0]);
    }

    /// Two words in one row are so far from each other that they are not read as one.
    #[test]
    fn words_in_a_row_stand_apart() {
        let labels = placed(&Canvas {
            placements: vec![word("one", &[[0.0, 0.0]]), word("two", &[[30.0, 0.0]])],
            ..Canvas::default()
        });
        let [one, two] = [labels[0].area, labels[1].area];
        assert!(!one.overlaps(apart(two)), "{one:?} {two:?}");
    }
}
