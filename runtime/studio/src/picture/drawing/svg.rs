//! The canvas and its placed words as SVG text.

use super::canvas::{Form, Shape};
use super::labels::PlacedLabel;
use super::plane::{Box2, Px, minus};
use crate::plot::svg::{Anchor, Lettering, Style, Svg};

/// Shapes and labels as SVG, cut to `area`.
pub(super) fn svg(description: &str, area: Box2, shapes: &[Shape], labels: &[PlacedLabel]) -> String {
    let mut svg = Svg::with_round_ends();
    let moved = |points: &[Px]| points.iter().map(|&p| minus(p, area.least)).collect::<Vec<_>>();
    for Shape { form, pen, fill } in shapes {
        let style = Style(*pen, *fill);
        match form {
            Form::Line(points) => svg.line(&moved(points), style),
            Form::Polygon(points) => svg.polygon(&moved(points), style),
            Form::Circle(centre, radius) => svg.circle(minus(*centre, area.least), *radius, style),
        }
    }
    for PlacedLabel { text, size, colour, area: place, .. } in labels {
        // Not centred: viewers differ in where they centre a word of several parts.
        let at = minus([place.least[0], place.centre()[1]], area.least);
        let lettering =
            Lettering { size: *size, colour: *colour, anchor: Anchor::Start, ..Lettering::new(at) };
        svg.marked(lettering, &text.markup(*size));
    }
    svg.finished(description, area.size().map(f64::ceil))
}
