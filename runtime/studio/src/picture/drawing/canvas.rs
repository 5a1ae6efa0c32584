//! What is drawn: forms with pens, and words that look for their place.

use super::plane::{Box2, Px, add, along, arc, distance, head, left_of, minus, unit};
use super::script::Script;
use crate::plot::svg::Colour;
pub(super) use crate::plot::svg::{Fill, Pen};
use core::f64::consts::TAU;

/// Lines and words in drawing order.
#[derive(Default)]
pub(super) struct Canvas {
    pub shapes: Vec<Shape>,
    pub placements: Vec<Placement>,
}

/// A form with its pen.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub form: Form,
    pub pen: Option<Pen>,
    pub fill: Option<Fill>,
}

#[derive(Clone, Debug)]
pub(super) enum Form {
    Line(Vec<Px>),
    Polygon(Vec<Px>),
    Circle(Px, f64),
}

/// A word and where it may stand.
pub(super) struct Placement {
    pub text: Script,
    pub size: f64,
    pub colour: Colour,
    /// Where it belongs, the best place first: a point, or some along a line.
    pub at: Vec<Spot>,
    /// How far from it its box begins.
    pub clearance: f64,
}

/// A point that a word may stand beside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub at: Px,
    /// The side it stands on if it can.
    pub side: Px,
}

impl Placement {
    /// The box of the word whose nearest part is `out` further from a spot than it need be.
    pub fn beside(&self, spot: Spot, direction: Px, out: f64) -> Box2 {
        let half = [self.text.width(self.size) / 2.0, self.size * 0.55];
        let centre = along(spot.at, direction, self.clearance + out);
        let centre = add(centre, [direction[0] * half[0], direction[1] * half[1]]);
        Box2 { least: minus(centre, half), most: add(centre, half) }
    }
}

/// A bar.
pub(super) const BAR: Pen = Pen::new(Colour::Black, 4.0);
/// Outlines of joints and supports.
pub(super) const OUTLINE: Pen = Pen::new(Colour::Black, 1.6);
/// Hatching.
pub(super) const HATCH: Pen = Pen::new(Colour::Black, 0.8);
/// Dimensions and arrows of coordinates.
pub(super) const MEASURE: Pen = Pen::new(Colour::Blue, 1.2);
/// Lines that only help to see what is measured.
pub(super) const HELP: Pen = Pen::new(Colour::Blue, 0.8);

impl Canvas {
    pub fn line(&mut self, points: Vec<Px>, pen: Pen) {
        self.shapes.push(Shape { form: Form::Line(points), pen: Some(pen), fill: None });
    }

    pub fn polygon(&mut self, points: Vec<Px>, pen: Pen, fill: Fill) {
        self.shapes.push(Shape { form: Form::Polygon(points), pen: Some(pen), fill: Some(fill) });
    }

    pub fn circle(&mut self, centre: Px, radius: f64, pen: Pen, fill: Option<Fill>) {
        self.shapes.push(Shape { form: Form::Circle(centre, radius), pen: Some(pen), fill });
    }

    /// A line with a head at its end; with one at its start too if `both`.
    pub fn arrow(&mut self, points: Vec<Px>, pen: Pen, both: bool) {
        let ends = (points.first().zip(points.get(1)), points.last().zip(points.iter().rev().nth(1)));
        if let (Some((&first, &second)), Some((&last, &before))) = ends {
            self.head(last, minus(last, before), pen.colour);
            if both {
                self.head(first, minus(first, second), pen.colour);
            }
        }
        self.line(points, pen);
    }

    fn head(&mut self, tip: Px, direction: Px, colour: Colour) {
        let form = Form::Polygon(head(tip, direction).to_vec());
        self.shapes.push(Shape { form, pen: None, fill: Some(Fill::Colour(colour)) });
    }

    /// Short strokes to the right of the line as one goes along it.
    pub fn hatch(&mut self, points: &[Px], spacing: f64, reach: f64) {
        let mut rest = spacing / 2.0;
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let (ahead, all) = (unit(minus(b, a)), distance(a, b));
            let across = left_of(ahead);
            while rest < all {
                let foot = along(a, ahead, rest);
                let end = along(along(foot, across, -reach), ahead, -reach);
                self.line(vec![foot, end], HATCH);
                rest += spacing;
            }
            rest -= all;
        }
    }

    /// How many lines an arrow between these ends would meet.
    pub fn crossings(&self, [a, b]: [Px; 2]) -> usize {
        let parts = 12_u32;
        let at = |i: u32| along(a, minus(b, a), f64::from(i) / f64::from(parts));
        let room = |i: u32| Some(Box2::round([at(i), at(i + 1)])?.wider(4.0));
        let areas: Vec<Box2> = (0..parts).filter_map(room).collect();
        let meets = |line: &[Px]| areas.iter().any(|area| area.clip(line[0], line[1]).is_some());
        let outlines = self.shapes.iter().map(Shape::outline);
        outlines.map(|line| line.windows(2).filter(|pair| meets(pair)).count()).sum()
    }

    /// The smallest box round all that is drawn so far, and about round the words.
    pub fn extent(&self) -> Option<Box2> {
        let drawn = Box2::round(self.shapes.iter().flat_map(Shape::outline))?;
        Some(
            self.placements
                .iter()
                .filter_map(|placement| Some((placement, *placement.at.first()?)))
                .map(|(placement, spot)| placement.beside(spot, spot.side, 0.0))
                .fold(drawn, Box2::with),
        )
    }
}

impl Shape {
    /// Its outline as a polyline.
    pub fn outline(&self) -> Vec<Px> {
        match &self.form {
            Form::Line(points) => points.clone(),
            Form::Polygon(points) => points.iter().chain(points.first()).copied().collect(),
            Form::Circle(centre, radius) => arc(*centre, *radius, 0.0, TAU),
        }
    }
}
