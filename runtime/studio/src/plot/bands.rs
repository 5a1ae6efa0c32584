//! Curves before coloured stripes.

use super::axes::{BELOW, LEFT, MARGIN, axes, lower, right_of};
use super::figure::{Area, DrawingError, Drawn, Figure, px};
use super::{Axis, Colour, Curve, LegendSquare, legend};
use plotters::prelude::*;

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
    pub fn banded(&self, panels: &[(u32, Banded)]) -> Result<String, DrawingError> {
        self.draw(|area| {
            let mut rest = area.clone();
            for (height, panel) in panels {
                let (strip, below) = rest.split_vertically(px(*height));
                panel.draw(&strip)?;
                rest = below;
            }
            Ok(())
        })
    }
}

impl Banded {
    fn draw(&self, area: &Area) -> Drawn {
        let opacity = if self.y.is_some() { BEHIND } else { ALONE };
        let plot = match self.caption.is_empty() && self.legend.is_empty() {
            true => area.clone(),
            false => legend::squares::draw(area, &self.caption, &self.legend, opacity)?,
        };
        let Some(y) = &self.y else { return self.alone(&plot) };
        let mut axes = axes(&plot, [&self.x, y], true)?;
        let [low, high] = y.ends();
        let stripe = |band: &Stripe| {
            let corners = [(band.range[0], low), (band.range[1], high)];
            Rectangle::new(corners, band.colour.rgb().mix(opacity).filled())
        };
        axes.draw_series(self.bands.iter().map(stripe))?;
        self.curves.iter().try_for_each(|curve| curve.draw(&mut axes))?;
        let dot = |p: &[f64; 2]| Circle::new((p[0], p[1]), px(2), Colour::Black.rgb().filled());
        axes.draw_series(self.dots.iter().map(dot))?;
        Ok(())
    }

    /// Bands over an axis that has nothing to its left.
    fn alone(&self, area: &Area) -> Drawn {
        let mut axes = ChartBuilder::on(area)
            .margin(px(MARGIN))
            .margin_left(px(MARGIN + LEFT))
            .margin_right(px(right_of(&self.x)))
            .x_label_area_size(px(BELOW))
            .build_cartesian_2d(self.x.clone(), Axis::linear("", [0.0, 1.0]))?;
        let stripe = |band: &Stripe| {
            Rectangle::new([(band.range[0], 0.0), (band.range[1], 1.0)], band.colour.rgb().filled())
        };
        axes.draw_series(self.bands.iter().map(stripe))?;
        lower(&mut axes, &self.x)
    }
}
