//! A legend of coloured squares, above the axes.

use crate::plot::Colour;
use crate::plot::axes::{LEFT, MARGIN};
use crate::plot::figure::{Area, lettering, offset, px};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Height of a line of the legend.
const LINE: u32 = 26;
/// Side of a square.
const SIDE: i32 = 14;

/// A colour and what it stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct LegendSquare {
    /// What the colour stands for.
    pub name: String,
    /// Colour of the square.
    pub colour: Colour,
}

/// Writes the caption and the squares from left to right at the top of `area`, on as many lines as they need; what is left
/// of it below.
pub(in crate::plot) fn draw<'a>(
    area: &Area<'a>,
    caption: &str,
    squares: &[LegendSquare],
    opacity: f64,
) -> Result<Area<'a>, Box<dyn std::error::Error>> {
    let width = area.dim_in_pixel().0 / px(1);
    let places = places(caption, squares, width);
    let lines = places.last().map_or(1, |(_, line)| line + 1);
    let (strip, rest) = area.split_vertically(px(LINE * lines));
    let lettering = lettering().pos(Pos::new(HPos::Left, VPos::Center));
    let words = |text: &str, left: i32, middle: i32| {
        Text::new(text.to_owned(), offset((left, middle)), lettering.clone())
    };
    strip.draw(&words(caption, (LEFT + MARGIN) as i32, 16))?;
    for (square, (left, line)) in squares.iter().zip(places) {
        let (left, middle) = (left as i32, (LINE * line) as i32 + 16);
        let corners = [(left, middle - SIDE / 2), (left + SIDE, middle + SIDE / 2)].map(offset);
        strip.draw(&Rectangle::new(corners, square.colour.rgb().mix(opacity).filled()))?;
        strip.draw(&words(&square.name, left + SIDE + 6, middle))?;
    }
    Ok(rest)
}

/// The left end of each square and its line, in `width` pixels.
fn places(caption: &str, squares: &[LegendSquare], width: u32) -> Vec<(u32, u32)> {
    let wide = |text: &str| 8 * text.chars().count() as u32;
    let first = LEFT + MARGIN;
    let (mut left, mut line) = (first + if caption.is_empty() { 0 } else { wide(caption) + 24 }, 0);
    let mut places = Vec::new();
    for square in squares {
        let length = SIDE as u32 + 26 + wide(&square.name);
        if left + length > width && left > first {
            (left, line) = (first, line + 1);
        }
        places.push((left, line));
        left += length;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn swatches_follow_the_caption_and_are_broken_into_lines() {
        let squares = ["A, E", "C"].map(|name| LegendSquare { name: name.into(), colour: Colour::Blue });
        let first = LEFT + MARGIN;
        assert_eq!(places("first open", &squares, 900), [(first + 104, 0), (first + 176, 0)]);
        assert_eq!(places("first open", &squares, 230), [(first, 1), (first + 72, 1)]);
        assert_eq!(places("", &squares, 10), [(first, 0), (first, 1)]);
    }
}
