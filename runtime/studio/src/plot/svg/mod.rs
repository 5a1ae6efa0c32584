//! SVG text: lines, areas, circles and words in pixels, x to the right and y down.

mod colour;
pub(crate) mod plane;
mod style;
mod theme;

use crate::html::escaped;
use core::fmt::{self, Display, Write};
use plane::{Box2, Px};

pub use colour::Colour;
pub(crate) use style::{Anchor, Fill, Lettering, Pen, Style};
pub use theme::with_theme;

/// A drawing in the making.
#[derive(Default)]
pub(crate) struct Svg {
    text: String,
    round_ends: bool,
}

impl Svg {
    /// A drawing whose lines end round; they end square by default.
    pub fn with_round_ends() -> Self {
        Self { round_ends: true, ..Self::default() }
    }

    /// A line through points.
    pub fn line(&mut self, points: &[Px], style: impl Into<Style>) {
        self.element(format_args!("polyline points=\"{}\"{}", List(points), style.into()));
    }

    /// Straight lines in one pen.
    pub fn segments(&mut self, ends: impl IntoIterator<Item = [Px; 2]>, pen: Pen) {
        let piece = |[a, b]: [Px; 2]| format!("M{}L{}", List(&[a]), List(&[b]));
        let all: String = ends.into_iter().map(piece).collect();
        self.element(format_args!("path d=\"{all}\"{pen}"));
    }

    pub fn polygon(&mut self, corners: &[Px], style: impl Into<Style>) {
        self.element(format_args!("polygon points=\"{}\"{}", List(corners), style.into()));
    }

    pub fn rectangle(&mut self, area: Box2, style: impl Into<Style>) {
        self.element(format_args!("rect{}{}", Sides(area), style.into()));
    }

    pub fn rounded_rectangle(&mut self, area: Box2, radius: f64, style: impl Into<Style>) {
        self.element(format_args!("rect{} rx=\"{}\"{}", Sides(area), Number(radius), style.into()));
    }

    pub fn circle(&mut self, centre: Px, radius: f64, style: impl Into<Style>) {
        let [x, y] = centre.map(Number);
        let r = Number(radius);
        self.element(format_args!("circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{}", style.into()));
    }

    /// An area whose colour changes evenly from below upwards.
    pub fn gradient(&mut self, area: Box2, name: &str, colours: &[[u8; 3]]) {
        let stop = |(i, colour): (usize, &[u8; 3])| {
            let part = Number(100.0 * i as f64 / (colours.len() - 1).max(1) as f64);
            format!("<stop offset=\"{part}%\" stop-color=\"{}\"/>", colour::hex(*colour))
        };
        let stops: String = colours.iter().enumerate().map(stop).collect();
        let along = "x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\"";
        let _ = writeln!(self.text, "<linearGradient id=\"{name}\" {along}>{stops}</linearGradient>");
        self.element(format_args!("rect{} fill=\"url(#{name})\"", Sides(area)));
    }

    /// A word, if there is one and a place for it.
    pub fn word(&mut self, lettering: Lettering, text: &str) {
        if !text.is_empty() && lettering.at.iter().all(|x| x.is_finite()) {
            self.marked(lettering, &escaped(text));
        }
    }

    /// A word whose parts are set by elements of their own.
    pub fn marked(&mut self, lettering: Lettering, text: &str) {
        let _ = writeln!(self.text, "<text{lettering}>{text}</text>");
    }

    fn element(&mut self, element: fmt::Arguments) {
        let _ = writeln!(self.text, "<{element}/>");
    }

    /// All of it with a description for readers who don't see it, on a sheet so wide and high.
    pub fn finished(self, description: &str, [width, height]: [f64; 2]) -> String {
        format!(
            "<svg role=\"img\" aria-label=\"{label}\" width=\"{width:.0}\" height=\"{height:.0}\" \
             viewBox=\"0 0 {width:.0} {height:.0}\" xmlns=\"http://www.w3.org/2000/svg\" fill=\"none\" \
             stroke-linejoin=\"round\"{ends} font-family=\"sans-serif\">\n{drawn}</svg>\n",
            ends = if self.round_ends { " stroke-linecap=\"round\"" } else { "" },
            label = escaped(description),
            drawn = self.text,
        )
    }
}

/// A number to a hundredth, without zeros that say nothing.
struct Number(f64);

impl Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", (100.0 * self.0).round() / 100.0 + 0.0)
    }
}

/// A rectangle as SVG has it.
struct Sides(Box2);

impl Display for Sides {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let ([x, y], [width, height]) = (self.0.least.map(Number), self.0.size().map(Number));
        write!(f, " x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
    }
}

/// Points as SVG has them.
struct List<'a>(&'a [Px]);

impl Display for List<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, point) in self.0.iter().enumerate() {
            let [x, y] = point.map(Number);
            write!(f, "{}{x},{y}", if i == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_decimals_at_most() {
        let numbers = [1.0, -0.001, 12.345, -7.5, 1e6].map(|value| Number(value).to_string());
        assert_eq!(numbers, ["1", "0", "12.35", "-7.5", "1000000"]);
    }

    #[test]
    fn words_are_escaped() {
        let mut svg = Svg::default();
        svg.word(Lettering::new([0.0, 0.0]), "a < b & c");
        assert!(svg.finished("\"", [8.0, 8.0]).contains(">a &lt; b &amp; c</text>"));
    }
}
