//! Colours over two axes: cells or dots, in colours of categories or from a scale.

use super::axes::{Axes, BELOW, LEFT, MARGIN, upright};
use super::{Axis, Colour, Figure, LegendSquare, legend};
use crate::plot::svg::plane::Box2;
use crate::plot::svg::{Fill, Svg};

/// Pixels of the colour bar with its labels.
const BAR: f64 = 110.0;
/// Colours that are told apart on a scale.
const STEPS: u8 = 250;
/// The scale viridis of matplotlib at equal distances.
const VIRIDIS: [[u8; 3]; 8] = [
    [68, 1, 84],
    [70, 50, 127],
    [54, 92, 141],
    [39, 127, 143],
    [31, 162, 136],
    [74, 194, 110],
    [160, 219, 57],
    [254, 232, 37],
];

/// A colour of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shade {
    /// That of a category.
    Colour(Colour),
    /// A place on the scale viridis, in 250ths: even to the eye and in grey, told apart by
    /// colour-blind readers too.
    Step(u8),
}

impl Shade {
    /// The place on the scale of a part from 0 to 1.
    pub fn of_part(part: f64) -> Self {
        Self::Step((part.clamp(0.0, 1.0) * f64::from(STEPS)).round() as u8)
    }

    fn fill(self) -> Fill {
        match self {
            Self::Colour(colour) => Fill::Colour(colour),
            Self::Step(step) => Fill::Rgb(viridis(f64::from(step) / f64::from(STEPS))),
        }
    }
}

/// The colour at a part of the scale, evenly between its neighbours.
fn viridis(part: f64) -> [u8; 3] {
    let at = part * (VIRIDIS.len() - 1) as f64;
    let below = (at as usize).min(VIRIDIS.len() - 2);
    let [a, b] = [below, below + 1].map(|i| VIRIDIS[i].map(f64::from));
    [0, 1, 2].map(|i| (a[i] + (at - below as f64) * (b[i] - a[i])).round() as u8)
}

/// A rectangle of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Patch {
    /// From where to where it is wide.
    pub x: [f64; 2],
    /// From where to where it is high.
    pub y: [f64; 2],
    /// Its colour.
    pub shade: Shade,
}

/// A dot of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dot {
    /// Position in units of the axes.
    pub at: [f64; 2],
    /// Its colour.
    pub shade: Shade,
}

/// A map: rectangles and dots over two axes; legend and caption stand above, the colour bar to the
/// right.
#[derive(Clone, PartialEq, Debug)]
pub struct Map {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Rectangles, from left to right and from below upwards.
    pub patches: Vec<Patch>,
    /// Dots.
    pub dots: Vec<Dot>,
    /// What the colours of categories stand for.
    pub legend: Vec<LegendSquare>,
    /// The observation, above the map.
    pub caption: String,
    /// The numbers at the ends of the scale, if it is used.
    pub bar: Option<[f64; 2]>,
}

impl Figure {
    /// The maps one below the other, as SVG text.
    pub fn maps(&self, maps: &[Map]) -> String {
        self.draw(|svg, area| {
            area.strips(maps.len()).zip(maps).for_each(|(strip, map)| map.draw(svg, strip));
        })
    }
}

impl Map {
    fn draw(&self, svg: &mut Svg, area: Box2) {
        let mut plot = legend::squares(svg, area, &self.caption, &self.legend, 1.0);
        if let Some(range) = self.bar {
            let [rest, strip] = plot.split(0, plot.size()[0] - BAR);
            bar(svg, strip, range);
            plot = rest;
        }
        let axes = Axes::within(plot, [&self.x, &self.y]);
        for patch in &self.patches {
            let mut area = axes.rectangle([patch.x, patch.y]);
            // It reaches a pixel under those drawn after it, so that no line is seen between
            // neighbours.
            area.most[0] = (area.most[0] + 1.0).min(axes.frame.most[0]);
            area.least[1] = (area.least[1] - 1.0).max(axes.frame.least[1]);
            svg.rectangle(area, patch.shade.fill());
        }
        axes.draw(svg);
        self.dots.iter().for_each(|dot| axes.dots(svg, &[dot.at], 3.0, dot.shade.fill()));
    }
}

/// The scale with its numbers.
fn bar(svg: &mut Svg, area: Box2, [low, high]: [f64; 2]) {
    let ([left, top], [right, bottom]) = (area.least, area.most);
    let frame = Box2 { least: [left, top + MARGIN], most: [right - MARGIN - LEFT, bottom - MARGIN - BELOW] };
    svg.gradient(frame, &format!("viridis-{:.0}", area.least[1]), &VIRIDIS);
    upright(svg, &Axis::linear("", [low, high]), frame, 1.0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_goes_through_its_colours() {
        let [first, last] = [VIRIDIS[0], VIRIDIS[7]].map(Fill::Rgb);
        assert_eq!([0.0, 1.0, 7.0].map(|part| Shade::of_part(part).fill()), [first, last, last]);
        // Half way between the fourth and the fifth.
        assert_eq!(Shade::of_part(0.5).fill(), Fill::Rgb([35, 145, 140]));
    }
}
