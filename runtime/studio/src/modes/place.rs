//! Where the boxes stand: columns by the number of closed contacts, each in the middle of the
//! height.

use super::Node;
use crate::plot::svg::plane::{Box2, Px};
use liftoff::ModeTransition;

const MARGIN: f64 = 12.0;
const HEIGHT: f64 = 42.0;
/// From box to box in a column; more where arrows have names.
const PITCH: f64 = 62.0;
const WIDE: f64 = 86.0;
/// Between two columns, for arrows and their names.
const GAP: f64 = 120.0;
/// From arrow to arrow at a side of a box, and all that they may take.
const APART: f64 = 9.0;
const SIDE: f64 = 30.0;
/// What a letter takes, at most nearly.
const LETTER: f64 = 7.6;

/// Where all boxes stand, in the order of the nodes.
pub(super) struct Places {
    pub boxes: Vec<Box2>,
    /// Width and height of all of it.
    pub size: [f64; 2],
}

impl Places {
    pub fn arrange(nodes: &[Node], labelled: bool) -> Self {
        let pitch = if labelled { WIDE } else { PITCH };
        let columns = nodes.iter().map(|node| node.column + 1).max().unwrap_or(0);
        let count = |column: usize| nodes.iter().filter(|node| node.column == column).count();
        let tallest = (0..columns).map(count).max().unwrap_or(0) as f64;
        let height = 2.0 * MARGIN + tallest * pitch - (pitch - HEIGHT);
        let mut left = MARGIN;
        let mut boxes = vec![Box2 { least: [0.0; 2], most: [0.0; 2] }; nodes.len()];
        for column in 0..columns {
            let members = || nodes.iter().enumerate().filter(|(_, node)| node.column == column);
            let width = members().map(|(_, node)| width(node)).fold(0.0, f64::max);
            let taken = count(column) as f64 * pitch - (pitch - HEIGHT);
            for (row, (i, _)) in members().enumerate() {
                let y = (height - taken) / 2.0 + row as f64 * pitch;
                boxes[i] = Box2 { least: [left, y], most: [left + width, y + HEIGHT] };
            }
            left += width + GAP;
        }
        Self { boxes, size: [left - GAP + MARGIN, height] }
    }

    /// Where each arrow begins and ends: side by side, in the order of where they lead.
    pub fn arrows(&self, changes: &[ModeTransition]) -> Vec<[Px; 2]> {
        let arrow = |change: &ModeTransition| {
            let beside: Vec<&ModeTransition> =
                changes.iter().filter(|other| other.from == change.from).collect();
            let start = self.port(beside.iter().map(|other| other.to).collect(), change.to);
            let beside: Vec<&ModeTransition> = changes.iter().filter(|other| other.to == change.to).collect();
            let end = self.port(beside.iter().map(|other| other.from).collect(), change.from);
            let [from, to] = [&self.boxes[change.from], &self.boxes[change.to]];
            [[from.most[0], from.centre()[1] + start], [to.least[0], to.centre()[1] + end]]
        };
        changes.iter().map(arrow).collect()
    }

    /// How far from the middle of a side the arrow to one box among others meets it.
    fn port(&self, mut others: Vec<usize>, to: usize) -> f64 {
        others.sort_by(|&a, &b| self.boxes[a].least[1].total_cmp(&self.boxes[b].least[1]));
        let place = others.iter().position(|&other| other == to).unwrap_or(0) as f64;
        let last = (others.len() - 1) as f64;
        (place - last / 2.0) * APART.min(SIDE / last.max(1.0))
    }
}

fn width(node: &Node) -> f64 {
    let letters =
        [&node.title, &node.degrees].map(|text| text.chars().count()).into_iter().max().unwrap_or(0);
    (letters as f64 * LETTER + 20.0).max(76.0)
}
