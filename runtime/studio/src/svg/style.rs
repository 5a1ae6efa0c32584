//! How lines, areas and words look.

use super::plane::Px;
use super::{Colour, Number, colour};
use core::fmt::{self, Display};

/// How a line is drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Pen {
    pub colour: Colour,
    /// Pixels.
    pub width: f64,
    /// From 0 to 1.
    pub opacity: f64,
    /// Lengths of dashes and gaps, pixels; empty: none.
    pub dashes: &'static str,
}

impl Pen {
    pub const fn of(colour: Colour, width: f64) -> Self {
        Self { colour, width, opacity: 1.0, dashes: "" }
    }

    pub const fn dashed(self) -> Self {
        Self { dashes: "5 4", ..self }
    }
}

impl Display for Pen {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, " stroke=\"{}\" stroke-width=\"{}\"", self.colour.hex(), Number(self.width))?;
        if !self.dashes.is_empty() {
            write!(f, " stroke-dasharray=\"{}\"", self.dashes)?;
        }
        opacity(f, "stroke-opacity", self.opacity)
    }
}

/// How an area is filled.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Paint {
    pub rgb: [u8; 3],
    /// From 0 to 1.
    pub opacity: f64,
}

impl Paint {
    /// As the paper.
    pub const PAPER: Self = Self { rgb: [0xFF; 3], opacity: 1.0 };

    pub const fn of(colour: Colour, opacity: f64) -> Self {
        Self { rgb: colour.rgb(), opacity }
    }
}

impl Display for Paint {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, " fill=\"{}\"", colour::hex(self.rgb))?;
        opacity(f, "fill-opacity", self.opacity)
    }
}

fn opacity(f: &mut fmt::Formatter, name: &str, opacity: f64) -> fmt::Result {
    if opacity < 1.0 { write!(f, " {name}=\"{}\"", Number(opacity)) } else { Ok(()) }
}

/// Outline and inside of an area.
#[derive(Clone, Copy)]
pub(crate) struct Style(pub Option<Pen>, pub Option<Paint>);

impl From<Pen> for Style {
    fn from(pen: Pen) -> Self {
        Self(Some(pen), None)
    }
}

impl From<Paint> for Style {
    fn from(paint: Paint) -> Self {
        Self(None, Some(paint))
    }
}

impl From<Colour> for Style {
    fn from(colour: Colour) -> Self {
        Paint::of(colour, 1.0).into()
    }
}

impl Display for Style {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self(pen, paint) = self;
        paint.iter().try_for_each(|paint| paint.fmt(f))?;
        pen.iter().try_for_each(|pen| pen.fmt(f))
    }
}

/// Which part of a word stands at its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// Where a word stands, half its height above and below the place, and how it looks.
#[derive(Clone, Copy)]
pub(crate) struct Lettering {
    pub at: Px,
    pub anchor: Anchor,
    /// Of the letters, pixels.
    pub size: f64,
    pub colour: Colour,
    pub bold: bool,
    /// Whether it is read from below upwards.
    pub upwards: bool,
}

impl Lettering {
    /// Black letters of charts about a place.
    pub const fn at(at: Px) -> Self {
        Self { at, anchor: Anchor::Middle, size: 11.3, colour: Colour::Black, bold: false, upwards: false }
    }

    pub const fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }
}

impl Display for Lettering {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        // Capitals and digits are about 0.7 of the letters' size high.
        let drop = 0.34 * self.size;
        let [x, y] = self.at;
        let place = if self.upwards { [x + drop, y] } else { [x, y + drop] };
        let ([x, y], size) = (place.map(Number), Number(self.size));
        write!(f, " x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{}\"", self.colour.hex())?;
        match self.anchor {
            Anchor::Start => Ok(()),
            Anchor::Middle => f.write_str(" text-anchor=\"middle\""),
            Anchor::End => f.write_str(" text-anchor=\"end\""),
        }?;
        if self.bold {
            f.write_str(" font-weight=\"600\"")?;
        }
        if self.upwards { write!(f, " transform=\"rotate(270 {x} {y})\"") } else { Ok(()) }
    }
}
