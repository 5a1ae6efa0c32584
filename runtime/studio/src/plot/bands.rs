//! Curves before coloured stripes.

use super::axes::Axes;
use super::{Axis, Colour, Curve, Figure, LegendSquare, legend};
use crate::plot::svg::plane::Box2;
use crate::plot::svg::{Fill, Svg};

/// How much of a band's colour is seen behind curves, and by itself.
const BEHIND: f64 = 0.3;
const ALONE: f64 = 1.0;

/// A part of the horizontal axis in one colour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stripe {
    /// From where to where.
    pub range: [f64; 2],
    /// Colour of the category.
    pub colour: Colour,
}

/// A panel: bands over all its height, before them curves and dots.
#[derive(Clone, PartialEq, Debug)]
pub struct Banded {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis; none: bands alone.
    pub y: Option<Axis>,
    /// Bands.
    pub bands: Vec<Stripe>,
    /// Curves in drawing order.
    pub curves: Vec<Curve>,
    /// Dots.
    pub dots: Vec<[f64; 2]>,
    /// What the bands' colours stand for.
    pub legend: Vec<LegendSquare>,
    /// Title of the legend, before it.
    pub caption: String,
}

impl Figure {
    /// The panels one below the other, each so many pixels high, as SVG text.
    pub fn banded(&self, panels: &[(u32, Banded)]) -> String {
        self.draw(|svg, mut rest| {
            for (height, panel) in panels {
                let [strip, below] = rest.split(1, f64::from(*height));
                panel.draw(svg, strip);
                rest = below;
            }
        })
    }
}

impl Banded {
    fn draw(&self, svg: &mut Svg, area: Box2) {
        let opacity = if self.y.is_some() { BEHIND } else { ALONE };
        let plot = match self.caption.is_empty() && self.legend.is_empty() {
            true => area,
            false => legend::squares(svg, area, &self.caption, &self.legend, opacity),
        };
        let unnamed = Axis::linear("", [0.0, 1.0]);
        let axes = Axes::within(plot, [&self.x, self.y.as_ref().unwrap_or(&unnamed)]);
        if self.y.is_some() {
            axes.grid(svg);
        }
        for band in &self.bands {
            svg.rectangle(axes.stripe(band.range), Fill::Faint(band.colour, opacity));
        }
        if self.y.is_some() {
            axes.draw(svg)
        } else {
            axes.lower(svg)
        }
        self.curves.iter().for_each(|curve| curve.draw(svg, &axes));
        axes.dots(svg, &self.dots, 2.0, Fill::Colour(Colour::Black));
    }
}
