//! Curves over two axes.

use super::annotations::Annotations;
use super::axes::{Axes, axes};
use super::dash::{self, Dash};
use super::figure::{Area, DrawingError, Drawn, Figure, px, word};
use super::legend::{self, LegendLine};
use super::{Axis, Colour, Scale};
use plotters::prelude::*;

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
    pub fn charts(&self, panels: &[Chart]) -> Result<String, DrawingError> {
        self.draw(|area| {
            let strips = area.split_evenly((panels.len(), 1));
            strips.iter().zip(panels).try_for_each(|(strip, chart)| chart.draw(strip))
        })
    }
}

impl Chart {
    pub(super) fn draw(&self, area: &Area) -> Drawn {
        self.draw_over(area, None)
    }

    /// Over shaded bands and lines across, if any.
    pub(super) fn draw_over(&self, area: &Area, annotations: Option<&Annotations>) -> Drawn {
        let named = self.curves.iter().filter(|curve| !curve.name.is_empty());
        let entry =
            |curve: &Curve| LegendLine { name: curve.name.clone(), colour: curve.colour, dash: curve.dash };
        let entries: Vec<LegendLine> = named.map(entry).collect();
        // Words above stand near the axes; a single panel keeps its place beside others.
        let plot = if entries.is_empty() && annotations.is_some() {
            area.clone()
        } else {
            legend::lines::draw(area, &entries)?
        };
        let mut axes = axes(&plot, [&self.x, &self.y], true)?;
        if let Some(annotations) = annotations {
            annotations.draw(&mut axes, self.y.ends())?;
        }
        let [low, high] = self.y.ends();
        if self.y.scale == Scale::Linear && low < 0.0 && high > 0.0 {
            let zero = self.x.range.map(|x| (x, 0.0));
            axes.draw_series(LineSeries::new(zero, Colour::Black.rgb().stroke_width(px(1))))?;
        }
        self.curves.iter().try_for_each(|curve| curve.draw(&mut axes))?;
        for mark in &self.marks {
            let dot = Circle::new((0, 0), px(4), Colour::Black.rgb().filled());
            let label = word(&mark.label, mark.offset);
            axes.draw_series([EmptyElement::at((mark.at[0], mark.at[1])) + dot + label])?;
        }
        Ok(())
    }
}

impl Curve {
    pub(super) fn draw(&self, axes: &mut Axes) -> Drawn {
        let style = self.colour.rgb().stroke_width(px(2));
        let plot = axes.plotting_area();
        for run in self.points.split(|point| !point.iter().all(|x| x.is_finite())) {
            let at = |point: &[f64; 2]| plot.map_coordinate(&(point[0], point[1]));
            let points: Vec<(i32, i32)> = run.iter().map(at).collect();
            dash::line(&plot.use_screen_coord(), &points, self.dash, style)?;
        }
        if self.dotted {
            let seen = self.points.iter().filter(|point| point.iter().all(|x| x.is_finite()));
            axes.draw_series(seen.map(|p| Circle::new((p[0], p[1]), px(3), self.colour.rgb().filled())))?;
        }
        Ok(())
    }
}
