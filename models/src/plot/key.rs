//! The key of a drawing, on a strip above its axes, never over data.

use super::Ink;
use super::axes::{LEFT, MARGIN};
use super::sheet::{Area, lettering, offset, px};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const STRIP: u32 = 26;

/// A kind of line and what it stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct Entry {
    /// What it stands for.
    pub name: String,
    /// Its colour.
    pub ink: Ink,
    /// Whether it is dashed.
    pub dashed: bool,
}

impl Entry {
    /// A solid line.
    pub fn solid(name: &str, ink: Ink) -> Self {
        Self { name: name.into(), ink, dashed: false }
    }
}

/// Draws the entries from left to right on a strip at the top of `area`; what is left of it below.
pub(super) fn draw<'a>(area: &Area<'a>, entries: &[Entry]) -> Result<Area<'a>, Box<dyn std::error::Error>> {
    let (strip, rest) = area.split_vertically(px(STRIP));
    let mut left = LEFT + MARGIN;
    for entry in entries {
        let style = entry.ink.rgb().stroke_width(px(2));
        let ends = [left, left + 26].map(|x| offset((x as i32, 16)));
        if entry.dashed {
            strip.draw(&DashedPathElement::new(ends, px(7), px(5), style))?;
        } else {
            strip.draw(&PathElement::new(ends, style))?;
        }
        let name = lettering().pos(Pos::new(HPos::Left, VPos::Center));
        strip.draw(&Text::new(entry.name.clone(), offset((left as i32 + 32, 16)), name))?;
        left += 56 + 8 * entry.name.chars().count() as u32;
    }
    Ok(rest)
}
