//! Where the boxes stand: columns by the number of closed contacts, each in the middle of the height.

use super::Node;

const MARGIN: f64 = 12.0;
const HEIGHT: f64 = 42.0;
/// From box to box in a column.
const PITCH: f64 = 62.0;
/// Between two columns, for arrows and their names.
const GAP: f64 = 84.0;
/// What a letter takes, at most nearly.
const LETTER: f64 = 7.6;

/// A box in pixels.
pub(super) struct Box {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
}

impl Box {
    pub fn left(&self) -> [f64; 2] {
        [self.x, self.y + self.height / 2.0]
    }

    pub fn right(&self) -> [f64; 2] {
        [self.x + self.width, self.y + self.height / 2.0]
    }
}

/// Where all boxes stand.
pub(super) struct Places {
    pub boxes: Vec<Box>,
    /// Width and height of all of it.
    pub size: [f64; 2],
}

impl Places {
    pub fn of(nodes: &[Node]) -> Self {
        let columns = nodes.iter().map(|node| node.column + 1).max().unwrap_or(0);
        let count = |column: usize| nodes.iter().filter(|node| node.column == column).count();
        let tallest = (0..columns).map(count).max().unwrap_or(0) as f64;
        let height = 2.0 * MARGIN + tallest * PITCH - (PITCH - HEIGHT);
        let mut left = MARGIN;
        let mut boxes = Vec::new();
        for column in 0..columns {
            let members = || nodes.iter().filter(|node| node.column == column);
            let width = members().map(width).fold(0.0, f64::max);
            let taken = count(column) as f64 * PITCH - (PITCH - HEIGHT);
            for (i, _) in members().enumerate() {
                let y = (height - taken) / 2.0 + i as f64 * PITCH;
                boxes.push(Box { x: left, y, width, height: HEIGHT });
            }
            left += width + GAP;
        }
        Self { boxes, size: [left - GAP + MARGIN, height] }
    }
}

fn width(node: &Node) -> f64 {
    let letters = [&node.title, &node.degrees].map(|text| text.chars().count()).into_iter().max().unwrap_or(0);
    (letters as f64 * LETTER + 20.0).max(76.0)
}

/// A point of the curve between two boxes.
pub(super) fn along(from: [f64; 2], to: [f64; 2], bend: f64, t: f64) -> [f64; 2] {
    let controls = [from, [from[0] + bend, from[1]], [to[0] - bend, to[1]], to];
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    [0, 1].map(|axis| weights.iter().zip(controls).map(|(w, p)| w * p[axis]).sum())
}
