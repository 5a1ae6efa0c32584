//! Drawing one-sided supports.

use super::builder::Builder;
use super::scheme::{Shape, Support};

impl Builder<'_> {
    pub(super) fn supports(&mut self) {
        let several = self.components.values().any(|&component| component > 0);
        for component in 0..if several { 2 } else { 0 } {
            let known: Vec<_> = self.points();
            let of = |point: &&String| self.components[*point] == component;
            let points: Vec<_> = known.iter().filter(of).cloned().collect();
            self.point_support(&points);
        }
        for _ in 0..self.source.below(4) {
            let points = self.points();
            if self.source.chance(0.3) { self.corner() } else { self.point_support(&points) }
        }
    }

    fn point_support(&mut self, points: &[String]) {
        let free: Vec<_> = points.iter().filter(|p| !self.scheme.pins.contains(p)).cloned().collect();
        if free.is_empty() {
            return;
        }
        let point = self.source.of(&free);
        let taken = self.scheme.supports.iter().any(|support| support.name == point);
        let own = !taken && self.source.chance(0.7);
        let name = if own { point.clone() } else { format!("s{}", self.scheme.supports.len()) };
        let shape = self.line(&point);
        self.scheme.supports.push(Support { name, point, shape });
    }

    /// Nothing across which the root of a mirror could not move.
    fn line(&mut self, point: &str) -> Shape {
        let kinds: &[usize] = match self.mirrored.filter(|_| point == self.root) {
            Some(0) => &[0, 1, 3],
            Some(_) => &[2, 3],
            None => &[0, 1, 2, 3],
        };
        let (source, parameters) = (&mut *self.source, &mut self.scheme.parameters);
        match source.of(kinds) {
            0 => Shape::Floor(None),
            1 => Shape::Floor(Some(parameters.signed(source, "h"))),
            2 => {
                let at = parameters.signed(source, "h");
                let off = self.scheme.figure[point][0].nominal - at.nominal;
                let said = off.abs() < 0.05 || source.chance(0.5);
                let side = if said { source.of(&[-1.0, 1.0]) } else { off.signum() };
                Shape::Wall { at, side, said }
            }
            _ => {
                let angle = parameters.angle(source);
                let through = source.chance(0.5).then(|| [0, 1].map(|_| parameters.signed(source, "h")));
                Shape::Slope { angle, through }
            }
        }
    }

    fn corner(&mut self) {
        let bar = self.source.below(self.scheme.bars.len());
        if self.scheme.bars[bar].heading.p == 0 || self.undrawn(bar) {
            return;
        }
        let at = [0, 1].map(|_| self.scheme.parameters.signed(self.source, "h"));
        let shape = Shape::Corner { bar, at, under: self.source.chance(0.6) };
        let name = format!("peg{}", self.scheme.supports.len());
        self.scheme.supports.push(Support { name, point: String::new(), shape });
    }

    pub(super) fn undrawn(&self, bar: usize) -> bool {
        self.scheme.bars[bar].chain.is_some_and(|chain| !self.scheme.chains[chain].drawn)
    }
}
