//! The legend of a drawing, on a strip above its axes, never over data.

use crate::plot::Colour;
use crate::plot::axes::{LEFT, MARGIN};
use crate::plot::dash::{self, Dash};
use crate::plot::figure::{Area, lettering, offset, px};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Height of a line of the legend.
const LINE: u32 = 26;
/// Length of a piece of the line, enough for its dashes to be seen.
const LONG: u32 = 36;

/// A kind of line and what it stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct LegendLine {
    /// What the line stands for.
    pub name: String,
    /// Colour of the curve.
    pub colour: Colour,
    /// Dashes of the curve.
    pub dash: Dash,
}

impl LegendLine {
    /// A solid line.
    pub fn solid(name: &str, colour: Colour) -> Self {
        Self { name: name.into(), colour, dash: Dash::Solid }
    }
}

/// Draws the entries from left to right on strips at the top of `area`, as many as they need; what is left of it below.
pub(in crate::plot) fn draw<'a>(
    area: &Area<'a>,
    entries: &[LegendLine],
) -> Result<Area<'a>, Box<dyn std::error::Error>> {
    let places = places(entries, area.dim_in_pixel().0 / px(1));
    let lines = places.last().map_or(1, |(_, line)| line + 1);
    let (strip, rest) = area.split_vertically(px(LINE * lines));
    for (entry, (left, line)) in entries.iter().zip(places) {
        let style = entry.colour.rgb().stroke_width(px(2));
        let middle = (LINE * line) as i32 + 16;
        let ends = [left, left + LONG].map(|x| offset((x as i32, middle)));
        dash::line(&strip, &ends, entry.dash, style)?;
        let name = lettering().pos(Pos::new(HPos::Left, VPos::Center));
        strip.draw(&Text::new(entry.name.clone(), offset(((left + LONG) as i32 + 6, middle)), name))?;
    }
    Ok(rest)
}

/// The left end of each entry and its line, in `width` pixels.
fn places(entries: &[LegendLine], width: u32) -> Vec<(u32, u32)> {
    let (mut left, mut line) = (LEFT + MARGIN, 0);
    let mut places = Vec::new();
    for entry in entries {
        let length = LONG + 30 + 8 * entry.name.chars().count() as u32;
        if left + length > width && left > LEFT + MARGIN {
            (left, line) = (LEFT + MARGIN, line + 1);
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
    fn a_long_key_is_broken_into_lines() {
        let entries = ["one", "another", "a third"].map(|name| LegendLine::solid(name, Colour::Blue));
        let first = LEFT + MARGIN;
        assert_eq!(places(&entries, 900), [(first, 0), (first + 90, 0), (first + 212, 0)]);
        assert_eq!(places(&entries, 300), [(first, 0), (first + 90, 0), (first, 1)]);
        assert_eq!(places(&entries, 10), [(first, 0), (first, 1), (first, 2)]);
    }
}
