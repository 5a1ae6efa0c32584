//! Forms and words as SVG text.

use super::canvas::{Fill, Form, Pen, Shape};
use super::labels::PlacedLabel;
use super::plane::{Box2, Px, minus};
use super::script::{LOWERED, Run};
use crate::html::escaped;
use core::fmt::Write;

/// Shapes and labels as SVG, cut to `area`.
pub(super) fn svg(description: &str, area: Box2, shapes: &[Shape], labels: &[PlacedLabel]) -> String {
    let [width, height] = area.size().map(f64::ceil);
    let mut text = format!(
        "<svg role=\"img\" aria-label=\"{label}\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\" \
         stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"sans-serif\">\n",
        label = escaped(description),
    );
    shapes.iter().for_each(|shape| drawn(&mut text, shape, area.least));
    labels.iter().for_each(|label| written(&mut text, label, area.least));
    text + "</svg>\n"
}

fn drawn(text: &mut String, shape: &Shape, corner: Px) {
    let style = format!("{}{}", fill(shape.fill), shape.pen.map_or_else(String::new, stroke));
    let _ = match &shape.form {
        Form::Line(points) => writeln!(text, "<polyline points=\"{}\"{style}/>", list(points, corner)),
        Form::Polygon(points) => writeln!(text, "<polygon points=\"{}\"{style}/>", list(points, corner)),
        Form::Circle(centre, r) => {
            let [x, y] = minus(*centre, corner);
            writeln!(text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r:.1}\"{style}/>")
        }
    };
}

fn list(points: &[Px], corner: Px) -> String {
    let pair = |&point: &Px| minus(point, corner).map(|x| format!("{x:.1}")).join(",");
    let pairs: Vec<String> = points.iter().map(pair).collect();
    pairs.join(" ")
}

fn fill(fill: Option<Fill>) -> String {
    match fill {
        None => " fill=\"none\"".into(),
        Some(Fill::Paper) => " fill=\"#FFFFFF\"".into(),
        Some(Fill::Pale) => " fill=\"#C8C8C8\" fill-opacity=\"0.45\"".into(),
        Some(Fill::Colour(colour)) => format!(" fill=\"{}\"", colour.hex()),
    }
}

fn stroke(pen: Pen) -> String {
    let dashes = if pen.dashed { " stroke-dasharray=\"5 4\"" } else { "" };
    format!(" stroke=\"{}\" stroke-width=\"{}\"{dashes}", pen.colour.hex(), pen.width)
}

/// A word from the left of its box. It is not centred: viewers differ in where they centre a word of several parts.
fn written(text: &mut String, label: &PlacedLabel, corner: Px) {
    let [x, middle] = minus([label.area.least[0], label.area.centre()[1]], corner);
    let (y, size, colour) = (middle + 0.34 * label.size, label.size, label.colour.hex());
    let _ = write!(text, "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" fill=\"{colour}\">");
    let mut lowered = false;
    for run in &label.text.0 {
        text.push_str(&part(run, label.size, &mut lowered));
    }
    text.push_str("</text>\n");
}

fn part(run: &Run, size: f64, lowered: &mut bool) -> String {
    let slant = if run.slanted { " font-style=\"italic\"" } else { "" };
    let step = match (*lowered, run.lowered) {
        (false, true) => format!(" dy=\"{:.1}\"", 0.22 * size),
        (true, false) => format!(" dy=\"{:.1}\"", -0.22 * size),
        _ => String::new(),
    };
    let small = if run.lowered { format!(" font-size=\"{:.1}\"", LOWERED * size) } else { String::new() };
    *lowered = run.lowered;
    format!("<tspan{slant}{small}{step}>{}</tspan>", escaped(&run.text))
}
