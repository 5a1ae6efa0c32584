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
    pub const fn new(colour: Colour, width: f64) -> Self {
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
pub(crate) enum Fill {
    /// As the paper.
    Paper,
    /// Pale.
    Pale,
    /// In this colour.
    Colour(Colour),
    /// In this colour with an opacity from 0 to 1.
    Faint(Colour, f64),
    /// Red, green and blue.
    Rgb([u8; 3]),
}

impl Display for Fill {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (rgb, part) = match *self {
            Self::Paper => ([0xFF; 3], 1.0),
            Self::Pale => (Colour::Grey.rgb(), 0.45),
            Self::Colour(colour) => (colour.rgb(), 1.0),
            Self::Faint(colour, part) => (colour.rgb(), part),
            Self::Rgb(rgb) => (rgb, 1.0),
        };
        write!(f, " fill=\"{}\"", colour::hex(rgb))?;
        opacity(f, "fill-opacity", part)
    }
}

fn opacity(f: &mut fmt::Formatter, name: &str, opacity: f64) -> fmt::Result {
    if opacity < 1.0 { write!(f, " {name}=\"{}\"", Number(opacity)) } else { Ok(()) }
}

/// Outline and inside of an area.
#[derive(Clone, Copy)]
pub(crate) struct Style(pub Option<Pen>, pub Option<Fill>);

impl From<Pen> for Style {
    fn from(pen: Pen) -> Self {
        Self(Some(pen), None)
    }
}

impl From<Fill> for Style {
    fn from(fill: Fill) -> Self {
        Self(None, Some(fill))
    }
}

impl Display for Style {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self(pen, fill) = self;
        fill.iter().try_for_each(|fill| fill.fmt(f))?;
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
    pub const fn new(at: Px) -> Self {
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
