//! Legends on a strip above the axes, never over data: of lines and of coloured squares.

use super::axes::{LEFT, MARGIN};
use super::{Colour, Dash};
use crate::plot::svg::plane::Box2;
use crate::plot::svg::{Anchor, Fill, Lettering, Svg};

/// Height of a line of the legend, and from its top to its middle.
const LINE: f64 = 26.0;
const MIDDLE: f64 = 16.0;
/// Length of a piece of a curve, enough for its dashes to be seen.
const LONG: f64 = 36.0;
/// Side of a square.
const SIDE: f64 = 14.0;

/// A kind of line and what it stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct LegendLine {
    /// What the line stands for.
    pub name: String,
    /// Colour of the curve.
    pub colour: Colour,
    /// Dashes of the curve.
    pub dash: Dash,
}

impl LegendLine {
    /// A solid line.
    pub fn solid(name: &str, colour: Colour) -> Self {
        Self { name: name.into(), colour, dash: Dash::Solid }
    }
}

/// A colour and what it stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct LegendSquare {
    /// What the colour stands for.
    pub name: String,
    /// Colour of the square.
    pub colour: Colour,
}

/// Draws the entries from left to right at the top of `area`, on as many lines as they need; what
/// is left of it below.
pub(super) fn lines(svg: &mut Svg, area: Box2, entries: &[LegendLine]) -> Box2 {
    let lengths = entries.iter().map(|entry| LONG + 30.0 + wide(&entry.name));
    let (places, rest) = places(area, 0.0, lengths);
    for (entry, [left, middle]) in entries.iter().zip(places) {
        svg.line(&[[left, middle], [left + LONG, middle]], entry.dash.pen(entry.colour, 2.0));
        word(svg, &entry.name, [left + LONG + 6.0, middle]);
    }
    rest
}

/// The same for a caption and squares.
pub(super) fn squares(
    svg: &mut Svg,
    area: Box2,
    caption: &str,
    squares: &[LegendSquare],
    opacity: f64,
) -> Box2 {
    let indent = if caption.is_empty() { 0.0 } else { wide(caption) + 24.0 };
    let (places, rest) = places(area, indent, squares.iter().map(|square| SIDE + 26.0 + wide(&square.name)));
    word(svg, caption, [area.least[0] + LEFT + MARGIN, area.least[1] + MIDDLE]);
    for (square, [left, middle]) in squares.iter().zip(places) {
        let least = [left, middle - SIDE / 2.0];
        let swatch = Box2 { least, most: least.map(|x| x + SIDE) };
        svg.rectangle(swatch, Fill::Faint(square.colour, opacity));
        word(svg, &square.name, [left + SIDE + 6.0, middle]);
    }
    rest
}

fn word(svg: &mut Svg, text: &str, at: [f64; 2]) {
    svg.word(Lettering::new(at).anchored(Anchor::Start), text);
}

/// Pixels that a word takes at most.
pub(super) fn wide(text: &str) -> f64 {
    8.0 * text.chars().count() as f64
}

/// The left end and the middle of each entry, the first one indented; and what is left of the area
/// below.
fn places(area: Box2, indent: f64, lengths: impl Iterator<Item = f64>) -> (Vec<[f64; 2]>, Box2) {
    let first = area.least[0] + LEFT + MARGIN;
    let (mut left, mut top) = (first + indent, area.least[1]);
    let mut places = Vec::new();
    for length in lengths {
        if left + length > area.most[0] && left > first {
            (left, top) = (first, top + LINE);
        }
        places.push([left, top + MIDDLE]);
        left += length;
    }
    (places, Box2 { least: [area.least[0], top + LINE], ..area })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_legend_is_broken_into_lines() {
        let broken = |width, indent| {
            let area = Box2 { least: [0.0, 10.0], most: [width, 100.0] };
            let (places, rest) = places(area, indent, [90.0, 122.0, 122.0].into_iter());
            let place = |[left, middle]: [f64; 2]| (left - LEFT - MARGIN, (middle - 26.0) / LINE);
            (places.into_iter().map(place).collect::<Vec<_>>(), rest.least[1])
        };
        assert_eq!(broken(900.0, 0.0), (vec![(0.0, 0.0), (90.0, 0.0), (212.0, 0.0)], 36.0));
        assert_eq!(broken(300.0, 0.0), (vec![(0.0, 0.0), (90.0, 0.0), (0.0, 1.0)], 62.0));
        assert_eq!(broken(300.0, 140.0), (vec![(0.0, 1.0), (90.0, 1.0), (0.0, 2.0)], 88.0));
    }
}
