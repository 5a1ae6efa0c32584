//! Coordinates that are angles: an arc from what they are measured from, with its sense.

use super::Draft;
use super::canvas::{HELP, MEASURE};
use super::plane::{Px, along, arc, distance, towards};
use super::script::Script;
use core::f64::consts::{PI, TAU};
use liftoff_codegen::system::{CoordinateKind, OneSided, Reference};

/// Radius of the first arc about a point, and how much more each further one has.
const RADIUS: f64 = 34.0;
const FURTHER: f64 = 15.0;
/// Arcs shorter than this have no arrow.
const SHORT: f64 = 10.0;

/// An angle at a point between two rays.
struct Opening {
    body: usize,
    /// The direction that it is measured from.
    from: f64,
    sweep: f64,
}

impl Draft<'_> {
    pub(super) fn angles(&mut self) {
        let mut taken: Vec<Px> = Vec::new();
        for (i, coordinate) in self.geometry.coordinates.clone().iter().enumerate() {
            if let CoordinateKind::Angle { body, reference, sign } = &coordinate.reading {
                let from = match reference {
                    Reference::Ground(angle) => self.geometry.angle(angle),
                    Reference::Body(other) => self.geometry.direction(*other),
                };
                let value = self.geometry.configuration.state[i];
                let sweep = f64::from(*sign) * wrapped(value);
                let opening = Opening { body: *body, from, sweep };
                let on_ground = matches!(reference, Reference::Ground(_));
                self.opening(&coordinate.name, &opening, on_ground, &mut taken);
            }
        }
    }

    fn opening(&mut self, name: &str, opening: &Opening, on_ground: bool, taken: &mut Vec<Px>) {
        let [from, to] = self.geometry.ends(opening.body);
        let is_bar = self.geometry.system.bodies[opening.body].outline.len() == 2;
        let turned = on_ground && is_bar && self.rank(to) > self.rank(from);
        let (vertex, base) = if turned { (to, opening.from + PI) } else { (from, opening.from) };
        let (at, bar) = (self.at(vertex), distance(self.at(from), self.at(to)));
        let others = taken.iter().filter(|other| distance(**other, at) < 1.0).count();
        taken.push(at);
        let wide = if opening.sweep.abs() < 0.35 { 1.6 } else { 1.0 };
        let radius = ((RADIUS + FURTHER * others as f64) * wide).min(0.75 * bar);
        self.canvas.line(vec![at, along(at, towards(base), radius + 14.0)], HELP.dashed());
        let points = arc(at, radius, base, opening.sweep);
        let middle = base + opening.sweep / 2.0;
        if radius * opening.sweep.abs() > SHORT {
            self.canvas.arrow(points, MEASURE, false);
        } else {
            self.canvas.line(points, MEASURE);
        }
        let out = towards(middle);
        self.measured(Script::quantity(name), along(at, out, radius), 3.0, out);
    }

    /// How good a point is to show an angle at.
    fn rank(&self, point: usize) -> u8 {
        let stands = |contact: &OneSided| matches!(contact, OneSided::Line { point: on, .. } if *on == point);
        if self.geometry.is_pinned(point) {
            2
        } else {
            u8::from(self.geometry.system.supports.iter().any(|support| stands(&support.contact)))
        }
    }
}

/// The angle within a turn either way.
fn wrapped(angle: f64) -> f64 {
    if angle.abs() <= TAU { angle } else { angle % TAU }
}
