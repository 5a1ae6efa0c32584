//! Curves over two axes.

use super::annotations::Annotations;
use super::axes::{Axes, is_finite};
use super::legend::{self, LegendLine};
use super::{Axis, Colour, Dash, Figure, Scale};
use crate::plot::svg::plane::{Box2, Px, add};
use crate::plot::svg::{Fill, Pen, Svg};

/// A line through points.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Its name in the legend; empty: not in the legend.
    pub name: String,
    /// Colour of the line.
    pub colour: Colour,
    /// Dashes of the line; solid unless it is [dashed](Self::dashed).
    pub dash: Dash,
    /// Whether every point is marked.
    pub dotted: bool,
    /// Its points; it is broken where one is not finite.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A solid line.
    pub fn solid(name: &str, colour: Colour, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), colour, dash: Dash::Solid, dotted: false, points }
    }

    /// The same line, dashed.
    #[must_use]
    pub fn dashed(self) -> Self {
        Self { dash: Dash::Dashed, ..self }
    }

    /// The same line with its points marked.
    #[must_use]
    pub fn dotted(self) -> Self {
        Self { dotted: true, ..self }
    }
}

/// A labelled point; the label stands where it is over no line and no other label.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    /// Position in units of the axes.
    pub at: [f64; 2],
    /// What is written beside it.
    pub label: String,
}

/// Where a label may stand, in pixels right of and below its point, best first.
const PLACES: [(i32, i32); 16] = [
    (9, -11),
    (-9, -11),
    (9, 13),
    (-9, 13),
    (0, -15),
    (0, 17),
    (9, -24),
    (-9, -24),
    (9, 26),
    (-9, 26),
    (24, -11),
    (-24, -11),
    (9, -40),
    (-9, -40),
    (9, -60),
    (-9, -60),
];

/// One panel: axes, curves, marks; the legend stands above the axes, never over data.
#[derive(Clone, PartialEq, Debug)]
pub struct Chart {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves in drawing order.
    pub curves: Vec<Curve>,
    /// Labelled points.
    pub marks: Vec<Mark>,
}

impl Figure {
    /// The panels one below the other, as SVG text.
    pub fn charts(&self, panels: &[Chart]) -> String {
        self.draw(|svg, area| {
            area.strips(panels.len()).zip(panels).for_each(|(strip, chart)| chart.draw(svg, strip, None));
        })
    }
}

impl Chart {
    /// Over shaded bands and lines across, if any.
    pub(super) fn draw(&self, svg: &mut Svg, area: Box2, annotations: Option<&Annotations>) {
        let named = self.curves.iter().filter(|curve| !curve.name.is_empty());
        let entry =
            |curve: &Curve| LegendLine { name: curve.name.clone(), colour: curve.colour, dash: curve.dash };
        let entries: Vec<LegendLine> = named.map(entry).collect();
        // Words above stand near the axes; a single panel keeps its place beside others.
        let plot = if entries.is_empty() && annotations.is_some() {
            area
        } else {
            legend::lines(svg, area, &entries)
        };
        let axes = Axes::within(plot, [&self.x, &self.y]);
        axes.grid(svg);
        axes.draw(svg);
        if let Some(annotations) = annotations {
            annotations.draw(svg, &axes);
        }
        let [low, high] = self.y.ends();
        if self.y.scale == Scale::Linear && low < 0.0 && high > 0.0 {
            axes.line(svg, &self.x.range.map(|x| [x, 0.0]), Pen::new(Colour::Black, 1.0));
        }
        self.curves.iter().for_each(|curve| curve.draw(svg, &axes));
        let mut taken = Taken { lines: self.lines(&axes), words: Vec::new() };
        for mark in &self.marks {
            axes.dots(svg, &[mark.at], 4.0, Fill::Colour(Colour::Black));
            let at = |place| axes.span_of_word(mark.at, place, &mark.label);
            let free = |place: &&(i32, i32)| taken.leaves(&axes, at(**place));
            let place = *PLACES.iter().find(free).unwrap_or(&PLACES[0]);
            axes.word(svg, mark.at, place, &mark.label);
            taken.words.push(at(place));
        }
    }

    /// The curves and the line at zero, where something is written beside them.
    fn lines(&self, axes: &Axes) -> Vec<Vec<Px>> {
        if self.marks.is_empty() {
            return Vec::new();
        }
        let curves = self.curves.iter().flat_map(|curve| {
            let places: Vec<Px> = curve.points.iter().map(|&point| axes.map_point(point)).collect();
            places.split(|place| !is_finite(place)).map(<[Px]>::to_vec).collect::<Vec<_>>()
        });
        curves.chain([self.x.range.map(|x| axes.map_point([x, 0.0])).to_vec()]).collect()
    }
}

/// What words must not stand over.
struct Taken {
    lines: Vec<Vec<Px>>,
    words: Vec<Box2>,
}

impl Taken {
    /// Whether a word in a box is within the axes, over no line and over no other word.
    fn leaves(&self, axes: &Axes, word: Box2) -> bool {
        // Over the axes' tops there is room, below the lower one stand its labels.
        let room =
            Box2 { least: add(axes.frame.least, [1.0, -16.0]), most: add(axes.frame.most, [6.0, -1.0]) };
        room.holds(word.least)
            && room.holds(word.most)
            && self.lines.iter().all(|line| word.inside(line).is_empty())
            && !self.words.iter().any(|other| other.overlaps(word))
    }
}

impl Curve {
    pub(super) fn draw(&self, svg: &mut Svg, axes: &Axes) {
        axes.line(svg, &self.points, self.dash.pen(self.colour, 2.0));
        if self.dotted {
            axes.dots(svg, &self.points, 3.0, Fill::Colour(self.colour));
        }
    }
}
