//! Curves over two axes.

use super::annotations::Annotations;
use super::axes::Axes;
use super::legend::{self, LegendLine};
use super::{Axis, Colour, Dash, Figure, Scale};
use crate::plot::svg::plane::Box2;
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

/// A labelled point.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    /// Position in units of the axes.
    pub at: [f64; 2],
    /// What is written beside it.
    pub label: String,
    /// Where the label stands, in pixels right of and below the point.
    pub offset: (i32, i32),
}

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
            axes.line(svg, &self.x.range.map(|x| [x, 0.0]), Pen::of(Colour::Black, 1.0));
        }
        self.curves.iter().for_each(|curve| curve.draw(svg, &axes));
        for mark in &self.marks {
            axes.dots(svg, &[mark.at], 4.0, Fill::Colour(Colour::Black));
            axes.word(svg, mark.at, mark.offset, &mark.label);
        }
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
