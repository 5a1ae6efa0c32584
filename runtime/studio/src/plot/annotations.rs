//! What several panels over one axis share: shaded bands, lines across, words above, lines of text
//! below.

use super::axes::{Axes, across};
use super::legend::wide;
use super::{Axis, Colour};
use crate::plot::svg::plane::Box2;
use crate::plot::svg::{Fill, Pen, Svg};

/// Free pixels between words of a row.
const BETWEEN: f64 = 10.0;
/// Rows of words above the panels at most.
const ROWS: usize = 3;

/// What panels over one horizontal axis share.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Annotations {
    /// Parts of the axis; every other one is shaded.
    pub bands: Vec<Band>,
    /// Where lines cross all panels, each with its word.
    pub heads: Vec<Head>,
    /// Lines of text below.
    pub notes: Vec<String>,
}

/// A part of an axis.
#[derive(Clone, PartialEq, Debug)]
pub struct Band {
    /// First and last abscissa.
    pub range: [f64; 2],
    /// What is written above it if it is wide enough.
    pub name: String,
}

/// A line across all panels.
#[derive(Clone, PartialEq, Debug)]
pub struct Head {
    /// Abscissa.
    pub at: f64,
    /// What is written above it; empty: nothing.
    pub text: String,
}

/// A word above the panels.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Placed {
    pub text: String,
    /// Its middle, pixels.
    pub middle: f64,
    /// Counted from the lowest.
    pub row: usize,
}

impl Annotations {
    /// Draws bands and lines.
    pub(super) fn draw(&self, svg: &mut Svg, axes: &Axes) {
        for band in self.bands.iter().skip(1).step_by(2) {
            svg.rectangle(axes.stripe(band.range), Fill::Faint(Colour::Grey, 0.4));
        }
        let pen = Pen { opacity: 0.4, ..Pen::new(Colour::Black, 1.0) };
        for head in &self.heads {
            let Box2 { least, most } = axes.stripe([head.at; 2]);
            svg.line(&[least, most], pen);
        }
    }

    /// The words over the panels of a figure, none over another: names of bands in the lowest row,
    /// those of lines above; none where they do not fit.
    pub(super) fn words(&self, x: &Axis, width: u32) -> Option<Vec<Placed>> {
        let mut words: Vec<Placed> = Vec::new();
        for band in self.bands.iter().filter(|band| !band.name.is_empty()) {
            let [from, to] = band.range.map(|end| across(x, width, end));
            if wide(&band.name) <= (to - from).abs() {
                words.push(Placed { text: band.name.clone(), middle: f64::midpoint(from, to), row: 0 });
            }
        }
        let lowest = usize::from(!words.is_empty());
        for head in self.heads.iter().filter(|head| !head.text.is_empty()) {
            let half = wide(&head.text) / 2.0;
            let middle = across(x, width, head.at).clamp(half + 2.0, f64::from(width) - half - 2.0);
            let rows = lowest..lowest + ROWS;
            let free =
                |row: &usize| words.iter().all(|other| other.row != *row || other.is_clear_of(middle, half));
            let row = rows.into_iter().find(free)?;
            words.push(Placed { text: head.text.clone(), middle, row });
        }
        Some(words)
    }

    /// Whether all words of lines find room over panels with this axis.
    pub fn fits(&self, x: &Axis, width: u32) -> bool {
        self.words(x, width).is_some()
    }
}

impl Placed {
    fn is_clear_of(&self, middle: f64, half: f64) -> bool {
        (self.middle - middle).abs() >= wide(&self.text) / 2.0 + half + BETWEEN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn annotations(heads: &[(f64, &str)]) -> Annotations {
        let band = |from, to, name: &str| Band { range: [from, to], name: name.into() };
        let head = |(at, text): &(f64, &str)| Head { at: *at, text: (*text).into() };
        Annotations {
            bands: vec![band(0.0, 6.0, "A, B"), band(6.0, 6.01, "A"), band(6.01, 10.0, "free")],
            heads: heads.iter().map(head).collect(),
            notes: Vec::new(),
        }
    }

    #[test]
    fn words_are_staggered_until_none_is_over_another() {
        let axis = Axis::linear("t", [0.0, 10.0]);
        let words =
            annotations(&[(6.0, "A open"), (6.01, "B open"), (9.0, "end")]).words(&axis, 600).unwrap();
        let texts: Vec<_> = words.iter().map(|word| (word.text.as_str(), word.row)).collect();
        assert_eq!(texts, [("A, B", 0), ("free", 0), ("A open", 1), ("B open", 2), ("end", 1)]);
        for (i, a) in words.iter().enumerate() {
            let clear = |b: &&Placed| a.row != b.row || a.is_clear_of(b.middle, wide(&b.text) / 2.0);
            assert!(words[..i].iter().all(|b| clear(&b)));
            assert!(a.middle - wide(&a.text) / 2.0 >= 0.0 && a.middle + wide(&a.text) / 2.0 <= 600.0);
        }
    }

    #[test]
    fn too_many_words_do_not_fit() {
        let axis = Axis::linear("t", [0.0, 10.0]);
        let many: Vec<(f64, &str)> = (0..5).map(|i| (5.0 + 0.01 * f64::from(i), "impact")).collect();
        assert!(!annotations(&many).fits(&axis, 600) && annotations(&many[..3]).fits(&axis, 600));
    }
}
