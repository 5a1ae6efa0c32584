//! Panels of one horizontal axis, one below the other.

use super::annotations::{Annotations, Placed};
use super::axes::{LEFT, MARGIN};
use super::{Chart, Figure};
use crate::plot::svg::{Anchor, Lettering};

/// Height of a row of words, pixels.
const ROW: f64 = 19.0;

impl Figure {
    /// Panels of one horizontal axis, one below the other, over what they share, as SVG text.
    pub fn stacked(&self, panels: &[Chart], annotations: &Annotations) -> String {
        let Some(first) = panels.first() else { return self.charts(panels) };
        let words = annotations.words(&first.x, self.size.0).unwrap_or_default();
        self.draw(|svg, area| {
            let head = above(&words);
            for Placed { text, middle, row } in &words {
                svg.word(Lettering::new([*middle, head - ROW * (*row as f64 + 0.5)]), text);
            }
            let [_, rest] = area.split(1, head);
            let margin = if annotations.notes.is_empty() { 0.0 } else { MARGIN };
            let below = ROW * annotations.notes.len() as f64 + margin;
            let [panel_area, notes] = rest.split(1, rest.size()[1] - below);
            for (strip, chart) in panel_area.strips(panels.len()).zip(panels) {
                chart.draw(svg, strip, Some(annotations));
            }
            for (line, note) in annotations.notes.iter().enumerate() {
                let at = [LEFT, notes.least[1] + ROW * (line as f64 + 0.5)];
                svg.word(Lettering::new(at).anchored(Anchor::Start), note);
            }
        })
    }
}

/// Height of the words above the panels.
fn above(words: &[Placed]) -> f64 {
    words.iter().map(|placed| placed.row + 1).max().map_or(0.0, |rows| ROW * rows as f64 + MARGIN / 2.0)
}
