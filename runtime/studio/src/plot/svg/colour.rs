//! Colours that are told apart by all readers, in the light and in the dark.

/// Colours of Okabe and Ito, told apart by colour-blind readers too; the page's style sheet maps
/// each to its shade in dark mode by this very value.
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
    /// All of them.
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

    /// Those of curves, in this order.
    pub const CURVES: [Self; 6] =
        [Self::Blue, Self::Vermilion, Self::Green, Self::Purple, Self::Sky, Self::Orange];

    /// Its shade on dark paper, as in the style of pages.
    pub(super) const fn in_the_dark(self) -> &'static str {
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
    pub(super) fn hex(self) -> String {
        hex(self.rgb())
    }

    pub(crate) const fn rgb(self) -> [u8; 3] {
        match self {
            Self::Black => [0x00, 0x00, 0x00],
            Self::Grey => [0xC8, 0xC8, 0xC8],
            Self::Blue => [0x00, 0x72, 0xB2],
            Self::Vermilion => [0xD5, 0x5E, 0x00],
            Self::Green => [0x00, 0x9E, 0x73],
            Self::Purple => [0xCC, 0x79, 0xA7],
            Self::Sky => [0x56, 0xB4, 0xE9],
            Self::Orange => [0xE6, 0x9F, 0x00],
        }
    }
}

/// A colour as SVG has it.
pub(super) fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}
