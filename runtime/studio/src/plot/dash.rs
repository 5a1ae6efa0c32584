//! Lines that are told apart where colours are not.

use crate::plot::svg::{Colour, Pen};

/// Dashes of a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Dash {
    /// None.
    #[default]
    Solid,
    /// As long as the gaps.
    Dashed,
    /// Dots.
    Dotted,
    /// Long with short gaps.
    Long,
    /// Short with long gaps.
    Sparse,
}

impl Dash {
    /// This line as a pen draws it.
    pub(super) fn pen(self, colour: Colour, width: f64) -> Pen {
        let dashes = match self {
            Self::Solid => "",
            Self::Dashed => "7 5",
            Self::Dotted => "2 4",
            Self::Long => "15 5",
            Self::Sparse => "6 11",
        };
        Pen { dashes, ..Pen::new(colour, width) }
    }

    /// The colour and the dashes of the curve of this number: no two of the first thirty are alike,
    /// and in grey print the first five are told apart by their dashes.
    pub fn choose(number: usize) -> (Colour, Self) {
        const DASHES: [Dash; 5] = [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::Long, Dash::Sparse];
        (Colour::CURVES[number % Colour::CURVES.len()], DASHES[number % DASHES.len()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_curves_look_alike() {
        let all: Vec<_> = (0..30).map(Dash::choose).collect();
        assert!(all.iter().enumerate().all(|(i, look)| !all[..i].contains(look)));
    }
}
