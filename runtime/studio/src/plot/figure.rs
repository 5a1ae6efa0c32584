//! A figure of fixed size as one SVG text.

use crate::plot::svg::Svg;
use crate::plot::svg::plane::Box2;

/// A drawing of fixed size.
pub struct Figure {
    /// What it shows, for readers who don't see it.
    pub description: String,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl Figure {
    /// What `draw` draws, as SVG text.
    pub(super) fn draw(&self, draw: impl FnOnce(&mut Svg, Box2)) -> String {
        let size = [self.size.0, self.size.1].map(f64::from);
        let mut svg = Svg::default();
        draw(&mut svg, Box2 { least: [0.0; 2], most: size });
        svg.finished(&self.description, size)
    }
}
