//! Drawing one-sided supports.

use super::builder::Builder;
use super::parts::Manner;
use super::quantity::Quantity;
use super::spec::{Shape, SupportSpec};
use super::vocabulary::occurs;

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
        let free: Vec<_> = points.iter().filter(|p| !self.spec.pins.contains(p)).cloned().collect();
        if free.is_empty() {
            return;
        }
        let point = self.source.choose(&free);
        let taken = self.spec.supports.iter().any(|support| support.name == point);
        let own = !taken && self.source.chance(0.7);
        let name = if own { point.clone() } else { format!("s{}", self.spec.supports.len()) };
        let curved = self.mirrored.is_none() && occurs(self.source, self.vocabulary.curved);
        let shape = if curved { self.curved(&point) } else { self.line(&point) };
        let manner = self.manner(!matches!(shape, Shape::Slot { .. }));
        self.spec.supports.push(SupportSpec { name, point, shape, manner });
    }

    /// Nothing across which the root of a mirror could not move.
    fn line(&mut self, point: &str) -> Shape {
        let kinds: &[usize] = match self.mirrored.filter(|_| point == self.root) {
            Some(0) => &[0, 1, 3],
            Some(_) => &[2, 3],
            None => &[0, 1, 2, 3],
        };
        let (source, parameters) = (&mut *self.source, &mut self.spec.parameters);
        match source.choose(kinds) {
            0 => Shape::Floor(None),
            1 => Shape::Floor(Some(parameters.signed(source, "h"))),
            2 => {
                let at = parameters.signed(source, "h");
                let off = self.spec.figure[point][0].nominal - at.nominal;
                let said = off.abs() < 0.05 || source.chance(0.5);
                let side = if said { source.choose(&[-1.0, 1.0]) } else { off.signum() };
                Shape::Wall { at, side, said }
            }
            _ => {
                let angle = parameters.angle(source);
                let through = source.chance(0.5).then(|| [0, 1].map(|_| parameters.signed(source, "h")));
                Shape::Slope { angle, through }
            }
        }
    }

    /// A circle that the figure's point is outside or inside of, or a slot around it.
    fn curved(&mut self, point: &str) -> Shape {
        let at = self.spec.figure[point].clone();
        let (source, parameters) = (&mut *self.source, &mut self.spec.parameters);
        let off = |source: &mut super::splitmix::Source, x: &Quantity| {
            x.plus(&Quantity::literal(20 + source.below(60) as i32))
        };
        match source.below(3) {
            0 => {
                let centre = [off(source, &at[0]), off(source, &at[1])];
                Shape::Circle { centre, radius: Quantity::literal(15), inside: false }
            }
            1 => {
                let centre = [off(source, &at[0]), off(source, &at[1])];
                let radius = parameters.positive(source, "r").plus(&Quantity::literal(120));
                Shape::Circle { centre, radius, inside: true }
            }
            _ => {
                let (angle, width) = (parameters.angle(source), parameters.positive(source, "w"));
                Shape::Slot { angle, through: at, width }
            }
        }
    }

    /// Rough or not, with restitution or not; nothing of it where there is a mirror.
    pub(super) fn manner(&mut self, may_be_rough: bool) -> Manner {
        if self.mirrored.is_some() {
            return Manner::default();
        }
        let rough = may_be_rough && occurs(self.source, self.vocabulary.rough);
        let restitution = occurs(self.source, self.vocabulary.restitution)
            .then(|| Quantity::literal(self.source.below(101) as i32));
        let poisson = restitution.is_some() && self.source.chance(0.4);
        Manner { rough, restitution, poisson }
    }

    fn corner(&mut self) {
        let bar = self.source.below(self.spec.bars.len());
        let triangle = self.spec.bars[bar].corner.is_some();
        if self.spec.bars[bar].heading.p == 0 || self.undrawn(bar) || triangle {
            return;
        }
        let at = [0, 1].map(|_| self.spec.parameters.signed(self.source, "h"));
        let shape = Shape::Corner { bar, at, under: self.source.chance(0.6) };
        let name = format!("peg{}", self.spec.supports.len());
        let manner = self.manner(true);
        self.spec.supports.push(SupportSpec { name, point: String::new(), shape, manner });
    }

    pub(super) fn undrawn(&self, bar: usize) -> bool {
        self.spec.bars[bar].chain.is_some_and(|chain| !self.spec.chains[chain].drawn)
    }
}
