//! Coordinates that are angles: an arc from what they are measured from, with its sense.

use super::Draft;
use super::canvas::{HELP, MEASURE, Spot};
use super::plane::{Px, along, arc, distance, towards};
use super::script::Script;
use crate::plot::Colour;
use core::f64::consts::{PI, TAU};
use liftoff_core::model::geometry::Reading;

/// Radius of the first arc about a point, and how much more each further one has.
const RADIUS: f64 = 34.0;
const FURTHER: f64 = 15.0;
/// Arcs shorter than this have no arrow.
const SHORT: f64 = 10.0;

/// Parts of an arc beside which its name may stand, the best first.
const PARTS: [f64; 5] = [0.5, 0.35, 0.65, 0.2, 0.8];

/// An angle at a point between two rays.
struct Opening {
    vertex: usize,
    /// Another point of the ray that turns.
    tip: usize,
    /// The direction of the other ray.
    base: f64,
    sweep: f64,
}

impl Draft<'_> {
    pub(super) fn angles(&mut self) {
        let mut taken: Vec<Px> = Vec::new();
        for (i, reading) in self.geometry.readings.iter().enumerate() {
            if let Reading::Angle { vertex, tip, from, against, sign } = *reading {
                let from = self.configuration.direction(from);
                let base = if against { from + PI } else { from };
                let sweep = f64::from(sign) * wrapped(self.configuration.state[i]);
                let name = self.configuration.layout.coordinates[i].name;
                self.opening(name, &Opening { vertex, tip, base, sweep }, &mut taken);
            }
        }
    }

    fn opening(&mut self, name: &str, opening: &Opening, taken: &mut Vec<Px>) {
        let (base, at) = (opening.base, self.map_point(opening.vertex));
        let bar = distance(at, self.map_point(opening.tip));
        let others = taken.iter().filter(|other| distance(**other, at) < 1.0).count();
        taken.push(at);
        let wide = if opening.sweep.abs() < 0.35 { 1.6 } else { 1.0 };
        let radius = ((RADIUS + FURTHER * others as f64) * wide).min(0.75 * bar);
        self.canvas.line(vec![at, along(at, towards(base), radius + 14.0)], HELP.dashed());
        let points = arc(at, radius, base, opening.sweep);
        if radius * opening.sweep.abs() > SHORT {
            self.canvas.arrow(points, MEASURE, false);
        } else {
            self.canvas.line(points, MEASURE);
        }
        let spot = |part: &f64| {
            let side = towards(base + part * opening.sweep);
            Spot { at: along(at, side, radius), side }
        };
        self.word((Script::quantity(name), Colour::Blue), PARTS.iter().map(spot).collect(), 3.0);
    }
}

/// The angle within a turn either way.
fn wrapped(angle: f64) -> f64 {
    if angle.abs() <= TAU { angle } else { angle % TAU }
}
