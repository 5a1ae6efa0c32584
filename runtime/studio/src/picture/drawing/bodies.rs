//! Bars and bodies, point masses, points of bars, sections.

use super::Draft;
use super::canvas::{BAR, Fill, OUTLINE, Pen};
use super::plane::{Px, add, along, distance, left_of, middle, minus, unit};
use super::script::Script;
use crate::plot::Colour;

/// Radius of a point mass.
const MASS: f64 = 7.0;
/// Radius of a point of a bar.
const SPOT: f64 = 2.6;
/// Half the length of the stroke that marks a section.
const CUT: f64 = 9.0;

impl Draft<'_> {
    pub(super) fn bodies(&mut self) {
        for body in 0..self.geometry.system.bodies.len() {
            self.body(body);
        }
        self.masses();
        self.sections();
    }

    fn body(&mut self, body: usize) {
        let outline: Vec<usize> = self.geometry.system.bodies[body].outline.clone();
        let points: Vec<Px> = outline.iter().map(|&point| self.at(point)).collect();
        match points.as_slice() {
            [from, to] => self.canvas.line(vec![*from, *to], BAR),
            _ => self.canvas.polygon(points.clone(), Pen::of(Colour::Black, 2.6), Fill::Pale),
        }
        self.name(body, &points);
    }

    /// A name of its own only: that of bar AB is read off its ends.
    fn name(&mut self, body: usize, points: &[Px]) {
        let declared = &self.geometry.system.bodies[body];
        let ends = [declared.from, declared.to].map(|end| self.geometry.system.points[end].name.clone());
        let name = declared.name.clone();
        if name == ends.concat() || is_link(&name) && self.geometry.system.bodies.len() > 6 {
            return;
        }
        let (at, side) = match points {
            [from, to] => (middle(*from, *to), unit(left_of(minus(*to, *from)))),
            _ => (centre(points), [0.0, 1.0]),
        };
        self.placement(Script::upright(&name.replace('_', " ")), at, 5.0, side);
    }

    fn masses(&mut self) {
        let points: Vec<usize> =
            self.geometry.system.particles.iter().map(|particle| particle.point).collect();
        for point in points {
            let at = self.at(point);
            self.canvas.circle(at, MASS, OUTLINE, Some(Fill::Colour(Colour::Black)));
        }
        for point in 0..self.geometry.system.points.len() {
            let is_inside =
                |(body, _): &(usize, _)| !self.geometry.system.bodies[*body].outline.contains(&point);
            if self.geometry.system.points[point].on.iter().any(is_inside) {
                let at = self.at(point);
                self.canvas.circle(at, SPOT, OUTLINE, Some(Fill::Colour(Colour::Black)));
            }
        }
    }

    fn sections(&mut self) {
        for section in self.geometry.system.sections.clone() {
            let [from, to] = self.geometry.ends(section.body).map(|end| self.at(end));
            let share = self.frame.long(self.geometry.number(&section.at)) / distance(from, to);
            let at = along(from, minus(to, from), share);
            let across = left_of(unit(minus(to, from)));
            self.canvas.line(vec![along(at, across, CUT), along(at, across, -CUT)], OUTLINE);
            self.placement(Script::upright(&section.name), at, 10.0, across);
        }
    }
}

/// The name of one of many: `bar7`.
fn is_link(name: &str) -> bool {
    name.ends_with(|letter: char| letter.is_ascii_digit())
}

fn centre(points: &[Px]) -> Px {
    let sum = points.iter().copied().fold([0.0, 0.0], add);
    sum.map(|x| x / points.len().max(1) as f64)
}
