//! Superposed positions of a bar system, to one scale both ways.

use super::axes::Axes;
use super::{Axis, Chart, Colour, Dash, Figure, LegendLine, legend};
use crate::plot::svg::plane::Box2;
use crate::plot::svg::{Fill, Pen, Svg};

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
    fn draw(&self, svg: &mut Svg, axes: &Axes) {
        let pen = Pen { opacity: self.opacity, ..self.dash.pen(self.colour, f64::from(self.width)) };
        match self.points.as_slice() {
            [a, b] if a == b => {
                axes.dots(svg, &[*a], pen.width / 2.0, Fill::Faint(self.colour, self.opacity))
            }
            line => axes.line(svg, line, pen),
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
    pub fn superposition(&self, superposition: &Superposition) -> String {
        self.draw(|svg, area| superposition.draw(svg, area))
    }

    /// The superposition on the leftmost `width` pixels, the chart on the rest, as SVG text.
    pub fn beside(&self, width: u32, superposition: &Superposition, chart: &Chart) -> String {
        self.draw(|svg, area| {
            let [left, right] = area.split(0, f64::from(width));
            superposition.draw(svg, left);
            chart.draw(svg, right, None);
        })
    }
}

impl Superposition {
    fn draw(&self, svg: &mut Svg, area: Box2) {
        let plot = if self.legend.is_empty() { area } else { legend::lines(svg, area, &self.legend) };
        let inner = Axes::within(plot, [&self.x, &self.y]).frame.size();
        let (x, y) = equal_scale(&self.x, &self.y, inner);
        let axes = Axes::within(plot, [&x, &y]);
        self.strokes.iter().for_each(|stroke| stroke.draw(svg, &axes));
        axes.draw(svg);
        axes.dots(svg, &self.dots, 3.0, Fill::Colour(Colour::Black));
        for label in &self.labels {
            axes.word(svg, label.at, label.offset, &label.text);
        }
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
