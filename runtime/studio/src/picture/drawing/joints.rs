//! Hinges, welds, pins and fixed points, sliders, and the names of points.

use super::Draft;
use super::canvas::{Fill, OUTLINE};
use super::plane::{Px, add, along, left_of, minus, towards, unit};
use super::script::Script;
use crate::plot::Colour;
use liftoff_codegen::system::Guide;

/// Radius of a hinge.
const HINGE: f64 = 4.2;
/// Size of the triangle under a pin.
const FOOT: Px = [9.0, 15.0];
/// Half length and half breadth of a sliding block.
const BLOCK: Px = [11.0, 6.5];

impl Draft<'_> {
    pub(super) fn joints(&mut self) {
        self.blocks();
        for point in 0..self.geometry.system.points.len() {
            self.joint(point);
        }
    }

    fn joint(&mut self, point: usize) {
        let (at, away) = (self.at(point), self.away(point));
        let declared = &self.geometry.system.points[point];
        let (name, bodies, fixed) = (declared.name.clone(), declared.on.len(), declared.ground.is_some());
        let pinned = self.geometry.is_pinned(point);
        if pinned {
            self.foot(at, if away[1] < -0.2 { -1.0 } else { 1.0 });
        }
        if pinned || fixed {
            self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Paper));
        } else if bodies > 1 && self.geometry.is_welded(point) {
            self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Colour(Colour::Black)));
        } else if bodies > 1 {
            self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Paper));
        }
        if fixed && !self.is_peg(point) {
            self.anchor(at);
        }
        if !name.contains('_') || self.geometry.system.points.len() < 8 {
            self.placement(Script::quantity(&name).standing(), at, 6.0, away);
        }
    }

    /// Away from the bodies at a point.
    fn away(&self, point: usize) -> Px {
        let at = self.at(point);
        let bodies = self.geometry.system.points[point].on.iter();
        let others = bodies.flat_map(|(body, _)| self.geometry.ends(*body)).filter(|&other| other != point);
        let sum = others.map(|other| unit(minus(at, self.at(other)))).fold([0.0, 0.0], add);
        if sum[0].hypot(sum[1]) < 0.1 { [0.0, -1.0] } else { unit(sum) }
    }

    /// A triangle on hatched ground; above the point where `side` is −1.
    fn foot(&mut self, at: Px, side: f64) {
        let base = |x: f64| add(at, [x * FOOT[0], side * FOOT[1]]);
        self.canvas.polygon(vec![at, base(1.0), base(-1.0)], OUTLINE, Fill::Paper);
        let ends = [base(-1.9), base(1.9)];
        self.canvas.line(ends.to_vec(), OUTLINE);
        let solid = if side > 0.0 { ends } else { [ends[1], ends[0]] };
        self.canvas.hatch(&solid, 6.0, 6.0);
    }

    /// What a fixed point is fixed to.
    fn anchor(&mut self, at: Px) {
        let ends = [add(at, [-15.0, -HINGE]), add(at, [15.0, -HINGE])];
        self.canvas.line(ends.to_vec(), OUTLINE);
        self.canvas.hatch(&[ends[1], ends[0]], 6.0, 6.0);
    }

    /// A block on each guide.
    fn blocks(&mut self) {
        for slider in self.geometry.system.sliders.clone() {
            let ahead = towards(match &slider.guide {
                Guide::Line { direction, .. } => self.geometry.angle(direction),
                Guide::Axis(body) => self.geometry.direction(*body),
            });
            let (at, across) = (self.at(slider.point), left_of(ahead));
            let corner = |x: f64, y: f64| along(along(at, ahead, x * BLOCK[0]), across, y * BLOCK[1]);
            let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| corner(x, y));
            self.canvas.polygon(corners.to_vec(), OUTLINE, Fill::Paper);
            if self.geometry.system.points[slider.point].on.len() == 1 {
                self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Paper));
            }
        }
    }
}
