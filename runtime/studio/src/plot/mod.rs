//! Drawings as SVG: curves over axes, and superposed positions of a bar system.
//!
//! Everything here takes plain points; nothing knows mechanics.

mod annotations;
mod axes;
mod axis;
mod bands;
mod chart;
mod dash;
mod figure;
mod format;
mod legend;
mod map;
mod superposition;
mod theme;

pub use annotations::{Annotations, Band, Head};
pub use axis::{Axis, Scale};
pub use bands::{Banded, Stripe};
pub use chart::{Chart, Curve, Mark};
pub use dash::Dash;
pub use figure::{DrawingError, Figure};
pub(crate) use format::significant;
pub use legend::{LegendLine, LegendSquare};
pub use map::{Dot, Map, Patch, Shade};
pub use superposition::{Label, Stroke, Superposition};
pub use theme::with_theme;

use plotters::style::RGBColor;

/// Colours of Okabe and Ito, told apart by colour-blind readers too; the page's style sheet maps each
/// to its shade in dark mode by this very value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Colour {
    /// Text, axes, outlines.
    Black,
    /// Grid lines and scenery.
    Grey,
    /// First curve.
    Blue,
    /// Second curve.
    Vermilion,
    /// Third curve.
    Green,
    /// Fourth curve.
    Purple,
    /// Fifth curve.
    Sky,
    /// Sixth curve.
    Orange,
}

impl Colour {
    /// All of them; curves take theirs from the third on.
    pub const ALL: [Self; 8] = [
        Self::Black,
        Self::Grey,
        Self::Blue,
        Self::Vermilion,
        Self::Green,
        Self::Purple,
        Self::Sky,
        Self::Orange,
    ];

    /// Its shade on dark paper, as in the style of pages.
    const fn in_the_dark(self) -> &'static str {
        match self {
            Self::Black => "#e8e8e6",
            Self::Grey => "#4a4f56",
            Self::Blue => "#56b4e9",
            Self::Vermilion => "#ff8b3d",
            Self::Green => "#2fc79a",
            Self::Purple => "#e09ac2",
            Self::Sky => "#9ad7f7",
            Self::Orange => "#ffc44d",
        }
    }

    /// As SVG has it, `#0072B2`.
    pub(crate) fn hex(self) -> String {
        let RGBColor(red, green, blue) = self.rgb();
        format!("#{red:02X}{green:02X}{blue:02X}")
    }

    const fn rgb(self) -> RGBColor {
        match self {
            Self::Black => RGBColor(0x00, 0x00, 0x00),
            Self::Grey => RGBColor(0xC8, 0xC8, 0xC8),
            Self::Blue => RGBColor(0x00, 0x72, 0xB2),
            Self::Vermilion => RGBColor(0xD5, 0x5E, 0x00),
            Self::Green => RGBColor(0x00, 0x9E, 0x73),
            Self::Purple => RGBColor(0xCC, 0x79, 0xA7),
            Self::Sky => RGBColor(0x56, 0xB4, 0xE9),
            Self::Orange => RGBColor(0xE6, 0x9F, 0x00),
        }
    }
}
