//! Supports, hatched on their solid side, and straight guides.

use super::Draft;
use super::canvas::{Fill, MEASURE, OUTLINE, Pen};
use super::plane::{Px, along, arc, distance, dot, left_of, middle, minus, towards, unit};
use crate::plot::Colour;
use core::f64::consts::TAU;
use liftoff_core::model::geometry::{Fixture, Number, Shape, Solid};

/// Pixels that lines go on beside the model.
const BEYOND: f64 = 34.0;
/// Spacing and length of hatching.
const HATCHING: [f64; 2] = [9.0, 9.0];
/// A line that something is kept on.
const GUIDE: Pen = Pen::new(Colour::Black, 1.0);
/// Half the breadth and the height of a wedge.
const EDGE: Px = [11.0, 22.0];
/// Points by which a circle is drawn.
const PARTS: u32 = 240;

/// A straight edge in pixels; solid to the right of `ahead`.
#[derive(Clone, Copy)]
struct Edge {
    at: Px,
    ahead: Px,
}

impl Edge {
    fn same(self, other: Self) -> bool {
        distance(self.ahead, other.ahead) < 1e-9
            && dot(minus(other.at, self.at), left_of(self.ahead)).abs() < 0.01
    }

    /// How far a point is on the free side.
    fn above(self, point: Px) -> f64 {
        dot(minus(point, self.at), left_of(self.ahead))
    }
}

impl Draft<'_> {
    pub(super) fn supports(&mut self) {
        for [from, to] in self.edges() {
            self.canvas.line(vec![from, to], OUTLINE);
            self.canvas.hatch(&[from, to], HATCHING[0], HATCHING[1]);
        }
        for fixture in self.geometry.fixtures {
            if let Shape::Circle { radius, solid, .. } = fixture.shape {
                self.round(fixture.at, radius, solid);
            }
        }
        for fixture in self.geometry.fixtures {
            match fixture.shape {
                Shape::Circle { radius, text, .. } => {
                    self.radius(self.configuration.position(fixture.at), radius, text);
                }
                Shape::Wedge => self.wedge(fixture),
                Shape::Line { .. } => {}
            }
        }
    }

    /// Ends of the straight edges that are seen, each once; where two meet in a corner neither goes
    /// beyond.
    fn edges(&self) -> Vec<[Px; 2]> {
        let lines = self.lines(true).map(|(at, angle)| Edge { at, ahead: towards(angle) });
        let mut edges: Vec<Edge> = Vec::new();
        for edge in lines {
            if !edges.iter().any(|other| edge.same(*other)) {
                edges.push(edge);
            }
        }
        let points: Vec<Px> = self.configuration.points.iter().map(|&point| self.frame.px(point)).collect();
        let bounds = |other: &&Edge| points.iter().all(|&point| other.above(point) > -0.5);
        let bounding: Vec<Edge> = edges.iter().filter(bounds).copied().collect();
        edges.iter().filter_map(|&edge| self.seen(edge, &bounding)).collect()
    }

    fn seen(&self, edge: Edge, bounding: &[Edge]) -> Option<[Px; 2]> {
        let ends = self.across(edge.at, edge.ahead)?;
        let mut part = [0.0_f64, 1.0_f64];
        for other in bounding {
            let [a, b] = ends.map(|end| other.above(end));
            if a < -0.01 && b > 0.01 {
                part[0] = part[0].max(a / (a - b));
            } else if b < -0.01 && a > 0.01 {
                part[1] = part[1].min(a / (a - b));
            }
        }
        let step = minus(ends[1], ends[0]);
        (part[0] < part[1]).then(|| part.map(|k| along(ends[0], step, k)))
    }

    /// The part of a line that is seen.
    fn across(&self, at: Px, ahead: Px) -> Option<[Px; 2]> {
        let area = self.frame.area.wider(BEYOND);
        let reach = distance(area.least, area.most) + distance(at, area.centre());
        let [a, b] = [along(at, ahead, -reach), along(at, ahead, reach)];
        let part = area.clip(a, b)?;
        Some(part.map(|k| along(a, minus(b, a), k)))
    }

    /// A circle, or what is seen of it.
    fn round(&mut self, at: [Number; 2], radius: Number, solid: Solid) {
        let centre = self.frame.px(self.configuration.position(at));
        let radius = self.frame.long(self.configuration.number(radius));
        let area = self.frame.area.wider(BEYOND);
        let step = TAU / f64::from(PARTS) * if solid == Solid::Within { -1.0 } else { 1.0 };
        let mut parts: Vec<Vec<Px>> = vec![Vec::new()];
        for i in 0..PARTS {
            let piece = arc(centre, radius, step * f64::from(i), step);
            let [from, to] = [piece[0], piece[piece.len() - 1]];
            if area.clip(from, to).is_none() {
                parts.push(Vec::new());
            } else if let Some(part) = parts.last_mut() {
                if part.is_empty() {
                    part.push(from);
                }
                part.push(to);
            }
        }
        for part in parts.into_iter().filter(|part| part.len() > 1) {
            if solid == Solid::Nowhere {
                self.canvas.line(part, GUIDE);
                continue;
            }
            self.canvas.hatch(&part, HATCHING[0], HATCHING[1] - 2.0);
            self.canvas.line(part, OUTLINE);
        }
    }

    /// The radius with its value, if it is seen.
    pub(super) fn radius(&mut self, at: [f64; 2], radius: Number, formula: &str) {
        let (centre, out) = (self.frame.px(at), towards(-0.6));
        let tip = along(centre, out, self.frame.long(self.configuration.number(radius)));
        if self.frame.area.wider(BEYOND).clip(centre, tip) == Some([0.0, 1.0]) {
            self.canvas.circle(centre, 1.5, MEASURE, Some(Fill::Colour(Colour::Blue)));
            self.canvas.arrow(vec![centre, tip], MEASURE, false);
            let text = self.value(radius, formula);
            self.measured(text, middle(centre, tip), 3.0, left_of(out));
        }
    }

    /// A wedge under what it pushes, upright or level.
    fn wedge(&mut self, fixture: &Fixture) {
        let Some(push) = self.geometry.push(fixture.name) else { return };
        let solid = towards(self.configuration.normal(push));
        let (at, solid) = (self.frame.px(self.configuration.position(fixture.at)), solid.map(|x| -x));
        let down = if solid[1].abs() > 0.2 { [0.0, solid[1].signum()] } else { unit([solid[0], 0.0]) };
        let (base, side) = (along(at, down, EDGE[1]), left_of(down));
        let corners = vec![at, along(base, side, EDGE[0]), along(base, side, -EDGE[0])];
        self.canvas.polygon(corners, OUTLINE, Fill::Pale);
        let ends = [along(base, side, 1.7 * EDGE[0]), along(base, side, -1.7 * EDGE[0])];
        self.canvas.line(ends.to_vec(), OUTLINE);
        self.canvas.hatch(&[ends[1], ends[0]], 6.0, 6.0);
    }

    /// Lines that points are kept on.
    pub(super) fn guides(&mut self) {
        let ends = self.lines(false).filter_map(|(at, angle)| self.across(at, towards(angle)));
        for ends in ends.collect::<Vec<_>>() {
            self.canvas.line(ends.to_vec(), GUIDE);
        }
    }

    /// A place and the angle of each straight line that is solid or not.
    fn lines(&self, edges: bool) -> impl Iterator<Item = (Px, f64)> + '_ {
        self.geometry.fixtures.iter().filter_map(move |fixture| match fixture.shape {
            Shape::Line { angle, solid } if solid == edges => Some((
                self.frame.px(self.configuration.position(fixture.at)),
                self.configuration.number(angle),
            )),
            _ => None,
        })
    }
}
