//! Superposed positions of a bar system, to one scale both ways.

use super::axes::{Axes, BELOW, LEFT, MARGIN, axes};
use super::dash::{self, Dash};
use super::figure::{Area, DrawingError, Drawn, Figure, px, word};
use super::{Axis, Chart, Colour, LegendLine, legend};
use plotters::prelude::*;

/// A line of the drawing; one from a point to itself is a dot as wide as its pen.
#[derive(Clone, PartialEq, Debug)]
pub struct Stroke {
    /// Its points, world coordinates.
    pub points: Vec<[f64; 2]>,
    /// Colour.
    pub colour: Colour,
    /// Opacity from 0 to 1.
    pub opacity: f64,
    /// Width in pixels.
    pub width: u32,
    /// Dashes of the line.
    pub dash: Dash,
}

impl Stroke {
    fn draw(&self, axes: &Axes) -> Drawn {
        let colour = self.colour.rgb().mix(self.opacity);
        let plot = axes.plotting_area();
        let points: Vec<(i32, i32)> =
            self.points.iter().map(|p| plot.map_coordinate(&(p[0], p[1]))).collect();
        let screen = plot.use_screen_coord();
        match points.as_slice() {
            [a, b] if a == b => Ok(screen.draw(&Circle::new(*a, px(self.width) / 2, colour.filled()))?),
            line => dash::line(&screen, line, self.dash, colour.stroke_width(px(self.width))),
        }
    }

    /// A line without dashes.
    pub fn solid(points: Vec<[f64; 2]>, colour: Colour, opacity: f64, width: u32) -> Self {
        Self { points, colour, opacity, width, dash: Dash::Solid }
    }
}

/// A word of the drawing.
#[derive(Clone, PartialEq, Debug)]
pub struct Label {
    /// The point it belongs to, world coordinates.
    pub at: [f64; 2],
    /// The text.
    pub text: String,
    /// Where it stands, in pixels right of and below the point.
    pub offset: (i32, i32),
}

/// Lines and words over axes of equal scale.
#[derive(Clone, PartialEq, Debug)]
pub struct Superposition {
    /// Horizontal axis, its range at least what must be seen.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines in drawing order.
    pub strokes: Vec<Stroke>,
    /// Dots.
    pub dots: Vec<[f64; 2]>,
    /// Words.
    pub labels: Vec<Label>,
    /// What the colours stand for; empty: no legend.
    pub legend: Vec<LegendLine>,
}

impl Figure {
    /// The superposition as SVG text, its ranges widened until both axes have one scale.
    pub fn superposition(&self, superposition: &Superposition) -> Result<String, DrawingError> {
        self.draw(|area| superposition.draw(area))
    }

    /// The superposition on the leftmost `width` pixels, the chart on the rest, as SVG text.
    pub fn beside(
        &self,
        width: u32,
        superposition: &Superposition,
        chart: &Chart,
    ) -> Result<String, DrawingError> {
        self.draw(|area| {
            let (left, right) = area.split_horizontally(px(width));
            superposition.draw(&left)?;
            chart.draw(&right)
        })
    }
}

impl Superposition {
    fn draw(&self, area: &Area) -> Drawn {
        let plot =
            if self.legend.is_empty() { area.clone() } else { legend::lines::draw(area, &self.legend)? };
        let (width, height) = plot.dim_in_pixel();
        let inner = [width - px(LEFT + 2 * MARGIN), height - px(BELOW + 2 * MARGIN)];
        let (x, y) = equal_scale(&self.x, &self.y, inner.map(f64::from));
        let mut axes = axes(&plot, [&x, &y], false)?;
        self.strokes.iter().try_for_each(|stroke| stroke.draw(&axes))?;
        let dot = |p: &[f64; 2]| Circle::new((p[0], p[1]), px(3), Colour::Black.rgb().filled());
        axes.draw_series(self.dots.iter().map(dot))?;
        for label in &self.labels {
            let place = EmptyElement::at((label.at[0], label.at[1]));
            axes.draw_series([place + word(&label.text, label.offset)])?;
        }
        Ok(())
    }
}

/// Widens one of the ranges about its middle so that a unit is as long on both axes of an area of
/// `inner` pixels.
fn equal_scale(x: &Axis, y: &Axis, inner: [f64; 2]) -> (Axis, Axis) {
    let lengths = [x, y].map(|axis| axis.range[1] - axis.range[0]);
    let unit = (lengths[0] / inner[0]).max(lengths[1] / inner[1]);
    let widened = |axis: &Axis, pixels: f64| {
        let middle = (axis.range[0] + axis.range[1]) / 2.0;
        let half = unit * pixels / 2.0;
        Axis { range: [middle - half, middle + half], ..axis.clone() }
    };
    (widened(x, inner[0]), widened(y, inner[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_axes_get_one_scale_and_lose_nothing() {
        let (x, y) =
            equal_scale(&Axis::linear("x", [-1.0, 1.0]), &Axis::linear("y", [0.0, 3.0]), [400.0, 300.0]);
        assert_eq!(y.range, [0.0, 3.0]);
        assert_eq!(x.range, [-2.0, 2.0]);
    }
}
