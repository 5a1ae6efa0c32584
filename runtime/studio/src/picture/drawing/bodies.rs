//! Bars and bodies, point masses, points of bars, sections.

use super::Draft;
use super::canvas::{BAR, Fill, OUTLINE, Pen, Spot};
use super::plane::{Px, add, along, distance, left_of, minus, towards, unit};
use super::script::Script;
use crate::plot::Colour;
use liftoff_core::model::Bar;
use liftoff_core::model::geometry::{Look, Round, Solid};

/// Radius of a point mass.
const MASS: f64 = 7.0;
/// Radius of a point of a bar.
const SPOT: f64 = 2.6;
/// Parts of a bar beside which its name may stand, the best first.
const PARTS: [f64; 5] = [0.5, 0.38, 0.62, 0.26, 0.74];
/// Half the length of the stroke that marks a section.
const CUT: f64 = 9.0;

impl Draft<'_> {
    pub(super) fn bodies(&mut self) {
        for round in self.geometry.rounds {
            self.rim(round);
        }
        for body in self.geometry.bodies {
            self.body(body.outline);
        }
        self.masses();
        self.sections();
    }

    /// A circle about a point, and a stroke from its centre that turns with it.
    fn rim(&mut self, round: &Round) {
        let (centre, radius) =
            (self.map_point(round.centre), self.frame.long(self.configuration.number(round.radius)));
        let fill = (round.solid == Solid::Within).then_some(Fill::Pale);
        self.canvas.circle(centre, radius, OUTLINE, fill);
        if let Some(turns) = round.along {
            let across = left_of(towards(self.configuration.direction(turns)));
            self.canvas.line(vec![centre, along(centre, across, radius)], OUTLINE);
        }
    }

    /// Radii of circles about points, each once; none that a bar is as long as.
    pub(super) fn radii(&mut self) {
        let mut told: Vec<_> = self.geometry.lengths.iter().map(|length| length.value).collect();
        for round in self.geometry.rounds {
            if !told.contains(&round.radius) {
                self.radius(self.configuration.points[round.centre], round.radius, round.text);
                told.push(round.radius);
            }
        }
    }

    fn body(&mut self, outline: &[usize]) {
        let points: Vec<Px> = outline.iter().map(|&point| self.map_point(point)).collect();
        match points.as_slice() {
            [from, to] => self.canvas.line(vec![*from, *to], BAR),
            _ => self.canvas.polygon(points.clone(), Pen::new(Colour::Black, 2.6), Fill::Pale),
        }
    }

    /// Names that stand anywhere beside their bars, after all that has its place.
    pub(super) fn names_of_bodies(&mut self) {
        let bars = self.configuration.layout.bars;
        for (bar, body) in bars.iter().zip(self.geometry.bodies) {
            let points: Vec<Px> = body.outline.iter().map(|&point| self.map_point(point)).collect();
            self.name(bar, &points);
        }
    }

    /// A name of its own only: that of bar AB is read off its ends.
    fn name(&mut self, bar: &Bar, points: &[Px]) {
        let layout = self.configuration.layout;
        let ends = [bar.from, bar.to].map(|end| layout.points[end]);
        if bar.name == ends.concat() || is_link(bar.name) && layout.bars.len() > 6 {
            return;
        }
        let at = match points {
            [from, to] => {
                let (step, side) = (minus(*to, *from), unit(left_of(minus(*to, *from))));
                PARTS.iter().map(|part| Spot { at: along(*from, step, *part), side }).collect()
            }
            _ => vec![Spot { at: centre(points), side: [0.0, 1.0] }],
        };
        self.word((Script::upright(&bar.name.replace('_', " ")), Colour::Black), at, 5.0);
    }

    fn masses(&mut self) {
        for point in self.geometry.marked(Look::Mass) {
            self.canvas.circle(self.map_point(point), MASS, OUTLINE, Some(Fill::Colour(Colour::Black)));
        }
        let bodies = self.geometry.bodies;
        let is_inner = |point: &usize| bodies.iter().any(|body| body.inner.contains(point));
        for point in (0..self.configuration.points.len()).filter(is_inner) {
            self.canvas.circle(self.map_point(point), SPOT, OUTLINE, Some(Fill::Colour(Colour::Black)));
        }
    }

    fn sections(&mut self) {
        for section in self.geometry.sections {
            let [from, to] = section.ends.map(|end| self.map_point(end));
            let share = self.frame.long(self.configuration.number(section.at)) / distance(from, to);
            let at = along(from, minus(to, from), share);
            let across = left_of(unit(minus(to, from)));
            self.canvas.line(vec![along(at, across, CUT), along(at, across, -CUT)], OUTLINE);
            self.placement(Script::upright(section.name), at, 10.0, across);
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
