//! A figure of fixed size, drawn by plotters into one SVG text.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Something that could not be drawn.
#[derive(thiserror::Error, Debug)]
#[error("cannot draw {figure}: {reason}")]
pub struct DrawingError {
    /// Description of the figure, as in [`Figure::description`].
    pub figure: String,
    /// Message of the backend.
    pub reason: String,
}

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Drawn units to a pixel: plotters rounds coordinates to whole units, and whole pixels would show as steps.
const FINE: u32 = 4;

/// A length of `pixels` in drawn units.
pub(super) const fn px(pixels: u32) -> u32 {
    pixels * FINE
}

/// An offset of `pixels` in drawn units.
pub(super) const fn offset(pixels: (i32, i32)) -> (i32, i32) {
    (pixels.0 * FINE as i32, pixels.1 * FINE as i32)
}

/// Type of the drawing's words.
pub(super) fn lettering<'a>() -> TextStyle<'a> {
    let black = super::Colour::Black.rgb();
    ("sans-serif", px(14)).into_font().color(&black)
}

/// A word that stands so many pixels right of and below its place: to the side it is moved to, else centred.
pub(super) fn word<'a>(text: &str, moved: (i32, i32)) -> Text<'a, (i32, i32), String> {
    let side = match moved.0.signum() {
        -1 => HPos::Right,
        0 => HPos::Center,
        _ => HPos::Left,
    };
    let style = lettering().pos(Pos::new(side, VPos::Center));
    Text::new(text.to_owned(), offset(moved), style)
}

/// A drawing of fixed size.
pub struct Figure {
    /// What it shows, for readers who don't see it.
    pub description: String,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl Figure {
    /// What `draw` draws, as SVG text.
    pub(super) fn draw(&self, draw: impl FnOnce(&Area) -> Drawn) -> Result<String, DrawingError> {
        let mut svg = String::new();
        let (width, height) = self.size;
        let root = SVGBackend::with_string(&mut svg, (px(width), px(height))).into_drawing_area();
        let shown = draw(&root).and_then(|()| root.present().map_err(Into::into));
        shown.map_err(|e| DrawingError { figure: self.description.clone(), reason: e.to_string() })?;
        drop(root);
        Ok(self.headed(&svg))
    }

    /// The drawing with its size in pixels and its description in the head.
    fn headed(&self, svg: &str) -> String {
        let (width, height) = self.size;
        let drawn = format!("<svg width=\"{}\" height=\"{}\" ", px(width), px(height));
        let label = escaped(&self.description);
        let head = format!("<svg role=\"img\" aria-label=\"{label}\" width=\"{width}\" height=\"{height}\" ");
        svg.replacen(&drawn, &head, 1)
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
