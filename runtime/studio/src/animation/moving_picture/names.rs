//! Names of the points, each where most room is beside its point.

use super::stage::Stage;
use super::track::{number, smooth};
use crate::html::escaped;
use crate::plot::Colour;
use crate::plot::svg::Fill;
use crate::plot::svg::plane::{Px, add, length, minus, towards};
use core::f64::consts::{FRAC_PI_2, TAU};
use liftoff_core::model::geometry::Look;

/// Names of more points than these would hide what they name.
const MOST: usize = 12;
/// Size of letters.
const SIZE: f64 = 17.0;
/// From a point to the middle of its name.
const GAP: f64 = 18.0;
/// How much further from a mass.
const HEAVY: f64 = 4.0;
/// A name stays between two bars as long as there are so many radians.
const ROOM: f64 = 1.6;

/// The names, as they move.
pub(super) fn drawn(stage: &Stage) -> String {
    let layout = stage.frames[0].layout;
    let masses: Vec<usize> = layout.geometry.marked(Look::Mass).collect();
    let names = layout.points.iter().enumerate().filter(|_| layout.points.len() <= MOST);
    let name = |(i, name): (usize, &&str)| {
        let gap = if masses.contains(&i) { GAP + HEAVY } else { GAP };
        let name = name.replace('_', " ");
        // A longer word is further away at the sides.
        let half = 0.3 * SIZE * (name.chars().count() - 1) as f64;
        word(stage, &name, &places(stage, i, [gap + half, gap]))
    };
    names.map(name).collect()
}

fn places(stage: &Stage, point: usize, [beside, above]: [f64; 2]) -> Vec<Px> {
    let mut side = FRAC_PI_2;
    let frames = stage.frames.iter().enumerate();
    let place = |(k, frame): (usize, &crate::registry::Configuration)| {
        side = freest(&neighbours(stage, point, k), side, k == 0);
        let [x, y] = towards(side);
        add(stage.px(frame.points[point]), [beside * x, above * y])
    };
    frames.map(place).collect()
}

/// Where bodies lead to from a point at a frame, as angles.
fn neighbours(stage: &Stage, point: usize, frame: usize) -> Vec<f64> {
    let frame = &stage.frames[frame];
    let at = |i: usize| stage.px(frame.points[i]);
    let mut angles = Vec::new();
    for body in frame.geometry().bodies {
        let Some(k) = body.outline.iter().position(|&other| other == point) else { continue };
        let n = body.outline.len();
        for other in [body.outline[(k + 1) % n], body.outline[(k + n - 1) % n]] {
            let [x, y] = minus(at(other), at(point));
            if length([x, y]) > 0.0 {
                angles.push((-y).atan2(x).rem_euclid(TAU));
            }
        }
    }
    angles.sort_by(f64::total_cmp);
    angles
}

/// The middle between two neighbours: those the name was between, if there is room, else those
/// furthest apart.
fn freest(angles: &[f64], side: f64, anew: bool) -> f64 {
    let next = |i: usize| if i + 1 < angles.len() { angles[i + 1] } else { angles[0] + TAU };
    let gaps = || (0..angles.len()).map(|i| (angles[i], next(i) - angles[i]));
    let around = |&(from, width): &(f64, f64)| (side - from).rem_euclid(TAU) <= width;
    let stays = gaps().find(|gap| !anew && around(gap) && gap.1 > ROOM);
    let widest = gaps().max_by(|a, b| a.1.total_cmp(&b.1));
    stays.or(widest).map_or(side, |(from, width)| from + 0.5 * width)
}

fn word(stage: &Stage, name: &str, places: &[Px]) -> String {
    // Letters stand on their line; their middle is a third of their size above it.
    let [x, y] = [(0, 0.0), (1, SIZE / 3.0)]
        .map(|(k, down)| places.iter().map(|at| number(at[k] + down)).collect::<Vec<String>>());
    format!(
        "<text x=\"{}\" y=\"{}\" font-size=\"{SIZE}\" text-anchor=\"middle\"{}>{}{}{}</text>\n",
        x[0],
        y[0],
        Fill::Colour(Colour::Black),
        escaped(name),
        smooth(&stage.timeline, "x", &x),
        smooth(&stage.timeline, "y", &y),
    )
}

#[cfg(test)]
mod tests {
    use super::freest;
    use core::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_name_stands_where_most_room_is_and_stays_while_there_is_some() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        close(freest(&[0.0, 1.0], 0.5, true), 0.5 + PI);
        close(freest(&[0.0, 1.0], 0.5, false), 0.5 + PI);
        close(freest(&[0.0, 2.0], 0.5, false), 1.0);
        close(freest(&[], FRAC_PI_2, true), FRAC_PI_2);
        close(freest(&[1.0, 1.0], 0.0, true), 1.0 + PI);
    }
}
