//! Hinges, welds, pins and fixed points, sliders, and the names of points.

use super::Draft;
use super::canvas::{Fill, OUTLINE};
use super::plane::{Px, add, along, left_of, minus, towards, unit};
use super::script::Script;
use crate::plot::Colour;
use liftoff_core::model::geometry::{Body, Look, Mark};

/// Radius of a hinge.
const HINGE: f64 = 4.2;
/// Size of the triangle under a pin.
const FOOT: Px = [9.0, 15.0];
/// Half length and half breadth of a sliding block.
const BLOCK: Px = [11.0, 6.5];

impl Draft<'_> {
    pub(super) fn joints(&mut self) {
        self.blocks();
        for mark in self.geometry.marks {
            self.joint(mark);
        }
        let points = self.configuration.layout.points;
        for (point, name) in points.iter().enumerate() {
            if !name.contains('_') || points.len() < 8 {
                let (at, away) = (self.map_point(point), self.away(point));
                self.placement(Script::quantity(name).standing(), at, 6.0, away);
            }
        }
    }

    fn joint(&mut self, mark: &Mark) {
        let at = self.map_point(mark.point);
        match mark.look {
            Look::Foot => self.foot(at, if self.away(mark.point)[1] < -0.2 { -1.0 } else { 1.0 }),
            Look::Ring => self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Paper)),
            Look::Disc => self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Colour(Colour::Black))),
            Look::Ground => self.ground(at),
            Look::Peg | Look::Mass => {}
        }
    }

    /// The bodies that a point belongs to.
    fn bodies_at(&self, point: usize) -> impl Iterator<Item = &'static Body> {
        let bodies = self.geometry.bodies.iter();
        bodies.filter(move |body| body.outline.contains(&point) || body.inner.contains(&point))
    }

    /// Away from the bodies at a point.
    fn away(&self, point: usize) -> Px {
        let at = self.map_point(point);
        let ends = self.bodies_at(point).flat_map(|body| &body.outline[..2]);
        let others = ends.filter(|&&other| other != point);
        let sum = others.map(|&other| unit(minus(at, self.map_point(other)))).fold([0.0, 0.0], add);
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
    fn ground(&mut self, at: Px) {
        let ends = [add(at, [-15.0, -HINGE]), add(at, [15.0, -HINGE])];
        self.canvas.line(ends.to_vec(), OUTLINE);
        self.canvas.hatch(&[ends[1], ends[0]], 6.0, 6.0);
    }

    /// A block on each guide.
    fn blocks(&mut self) {
        for block in self.geometry.blocks {
            let ahead = towards(self.configuration.direction(block.along));
            let (at, across) = (self.map_point(block.point), left_of(ahead));
            let corner = |x: f64, y: f64| along(along(at, ahead, x * BLOCK[0]), across, y * BLOCK[1]);
            let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| corner(x, y));
            self.canvas.polygon(corners.to_vec(), OUTLINE, Fill::Paper);
            if self.bodies_at(block.point).count() == 1 {
                self.canvas.circle(at, HINGE, OUTLINE, Some(Fill::Paper));
            }
        }
    }
}
