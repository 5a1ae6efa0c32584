//! Lengths of bars with their names and values: one dimension for all bars of one length.

use super::Draft;
use super::canvas::{HELP, MEASURE, Spot};
use super::plane::{Px, along, distance, left_of, middle, minus, unit};
use super::script::Script;
use crate::plot::{Colour, significant};
use liftoff_core::model::geometry::{self, Number};

/// Bars shorter than this bear no dimension.
const SHORTEST: f64 = 40.0;
/// More lengths than these would hide the model.
const MOST: usize = 4;
/// Distances of a dimension from its bar.
const OFFSETS: [f64; 3] = [20.0, 34.0, -20.0];

/// Parts of a dimension beside which its words may stand, the best first.
const PARTS: [f64; 3] = [0.5, 0.35, 0.65];

/// A bar and what is written beside it.
struct Length {
    ends: [Px; 2],
    text: Script,
}

impl Draft<'_> {
    pub(super) fn lengths(&mut self) {
        let lengths = self.distinct();
        if lengths.len() > MOST {
            return;
        }
        for bars in lengths {
            let places = bars.iter().flat_map(|bar| {
                let [a, b] = bar.ends;
                let side = self.outwards(a, b);
                OFFSETS.into_iter().enumerate().map(move |(i, offset)| (bar, i, side.map(|x| x * offset)))
            });
            let cost = |(bar, i, step): &(&Length, usize, Px)| {
                let ends = bar.ends.map(|end| along(end, *step, 1.0));
                (self.canvas.crossings(ends), *i)
            };
            if let Some((bar, _, step)) = places.min_by_key(cost) {
                let (ends, text) = (bar.ends, bar.text.clone());
                self.dimension(ends, step, text);
            }
        }
    }

    /// The bars of each length, as far as they are long enough.
    fn distinct(&self) -> Vec<Vec<Length>> {
        let bars = |length: &geometry::Length| {
            let ends = length.between.iter().map(|ends| ends.map(|end| self.map_point(end)));
            let long = ends.filter(|[a, b]| distance(*a, *b) >= SHORTEST);
            long.map(|ends| Length { ends, text: self.value(length.value, length.text) }).collect::<Vec<_>>()
        };
        self.geometry.lengths.iter().map(bars).filter(|bars| !bars.is_empty()).collect()
    }

    /// A length with its value, `l = 1 m`.
    pub(super) fn value(&self, length: Number, formula: &str) -> Script {
        let value = format!("{} m", significant(self.configuration.number(length), 4));
        if formula.is_empty() {
            return Script::upright(&value);
        }
        Script::formula(formula).then(Script::upright(&format!(" = {value}")))
    }

    /// Across a bar, away from the middle of the model.
    fn outwards(&self, a: Px, b: Px) -> Px {
        let across = left_of(unit(minus(b, a)));
        let out = minus(middle(a, b), self.frame.area.centre());
        let side = across[0] * out[0] + across[1] * out[1];
        if side < -1e-6 { across.map(|x| -x) } else { across }
    }

    /// An arrow with heads at both ends beside what it measures, and lines that lead there.
    pub(super) fn dimension(&mut self, ends: [Px; 2], step: Px, text: Script) {
        let shifted = ends.map(|end| along(end, step, 1.0));
        for end in ends {
            self.canvas.line(vec![along(end, step, 0.25), along(end, step, 1.2)], HELP);
        }
        self.canvas.arrow(shifted.to_vec(), MEASURE, true);
        let (whole, side) = (minus(shifted[1], shifted[0]), unit(step));
        let spots = PARTS.iter().map(|part| Spot { at: along(shifted[0], whole, *part), side });
        self.word((text, Colour::Blue), spots.collect(), 3.0);
    }
}
