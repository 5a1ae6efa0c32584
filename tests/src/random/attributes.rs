//! Drawing what acts on the bars: gravity, masses, pins, declared coordinates, equal angles.

use super::builder::Builder;
use super::quantity::Quantity;
use super::spec::{Declared, Gravity, Origin, Spec, Tie};
use super::splitmix::Source;
use super::vocabulary::Vocabulary;

const ANGLES: [&str; 8] = ["phi", "psi", "chi", "beta", "gamma", "delta", "eta", "zeta"];

/// Draws a whole spec; whether it makes sense as a mechanism is for the oracle to say.
pub fn spec(source: &mut Source, vocabulary: Vocabulary) -> Spec {
    let mut builder = Builder::new(source, vocabulary);
    builder.bars();
    builder.halve();
    builder.gravity();
    builder.pins();
    builder.masses();
    builder.supports();
    builder.ties();
    builder.coordinates();
    builder.positions();
    builder.parts();
    if builder.spec.parameters.fields.is_empty() {
        let mass = builder.spec.parameters.field(builder.source, "m");
        builder.spec.masses.push((builder.spec.bars[0].to.clone(), mass));
    }
    if let Some(axis) = builder.mirrored {
        builder.reflect(axis);
    }
    builder.spec
}

impl Builder<'_> {
    /// Along the mirror line, where there is one.
    fn gravity(&mut self) {
        let (source, parameters) = (&mut *self.source, &mut self.spec.parameters);
        self.spec.gravity = match (source.below(5), self.mirrored) {
            (0, _) => Gravity::None,
            (_, Some(1)) => Gravity::Vector([parameters.positive(source, "g"), Quantity::literal(0)]),
            (1 | 2, None) | (_, Some(_)) => Gravity::Down(parameters.positive(source, "g")),
            _ => {
                let x = parameters.positive(source, "g");
                Gravity::Vector([x, Quantity::literal(source.choose(&[-981, -150, 70]))])
            }
        };
    }

    /// Points whose place in the figure is given or follows from what is given.
    pub(super) fn points(&self) -> Vec<String> {
        let undrawn = |point: &str| {
            let bars = self.spec.bars.iter().filter(|bar| bar.to == point);
            bars.filter_map(|bar| bar.chain).any(|chain| !self.spec.chains[chain].drawn)
        };
        self.spec.figure.keys().filter(|point| !undrawn(point)).cloned().collect()
    }

    fn pins(&mut self) {
        let count = self.source.choose(&[0, 0, 0, 1, 1, 1, 1, 2, 2]);
        for _ in 0..count {
            let points = self.points();
            let point = self.source.choose(&points);
            if !self.spec.pins.contains(&point) {
                self.spec.pins.push(point);
            }
        }
    }

    fn masses(&mut self) {
        for _ in 0..self.source.below(5).saturating_sub(2) {
            let points: Vec<_> = self.spec.figure.keys().cloned().collect();
            let point = self.source.choose(&points);
            let mass = self.spec.parameters.positive(self.source, "m");
            self.spec.masses.push((point, mass));
        }
        let massless: Vec<_> = self.spec.bars.iter().filter(|bar| bar.mass.is_zero()).collect();
        for point in massless.into_iter().map(|bar| bar.to.clone()) {
            let mass = self.spec.parameters.positive(self.source, "m");
            self.spec.masses.push((point, mass));
        }
    }

    fn ties(&mut self) {
        for (a, b) in self.twins.clone() {
            let (left, right) = (self.spec.bars[a].heading, self.spec.bars[b].heading);
            let alike = left == right;
            let mirrored = left.slanted() && (left.p.abs(), left.q.abs()) == (right.p.abs(), right.q.abs());
            let declared = self.declared(a) || self.declared(b);
            if self.spec.bars[b].chain.is_some() || !self.source.chance(0.6) {
                continue;
            }
            if mirrored && !declared && self.source.chance(0.6) {
                let line = self.source.choose(&["horizontal", "vertical"]);
                let [first, second] = [a, b].map(|bar| self.angle(bar, Origin::Line(line)));
                self.spec.ties.push(Tie::Coordinates(first, second));
            } else if alike {
                self.spec.ties.push(Tie::Bars(a, b));
            }
        }
    }

    fn declared(&self, wanted: usize) -> bool {
        let is = |declared: &Declared| matches!(declared, Declared::Angle { bar, .. } if *bar == wanted);
        self.spec.coordinates.iter().any(is)
    }

    fn angle(&mut self, bar: usize, origin: Origin) -> usize {
        let index = self.spec.coordinates.len();
        let name = ANGLES[index % ANGLES.len()].to_string();
        self.spec.coordinates.push(Declared::Angle { name, bar, origin });
        index
    }

    fn coordinates(&mut self) {
        for bar in 0..self.spec.bars.len() {
            if self.spec.coordinates.len() >= ANGLES.len() || self.declared(bar) || self.undrawn(bar) {
                continue;
            }
            if self.source.chance(0.2) {
                let origin = self.origin(bar);
                self.angle(bar, origin);
            }
        }
    }

    fn origin(&mut self, bar: usize) -> Origin {
        let heading = self.spec.bars[bar].heading;
        match self.source.below(4) {
            0 if heading.slanted() || heading.q == 0 => Origin::Line("horizontal"),
            1 if heading.slanted() || heading.p == 0 => Origin::Line("vertical"),
            2 if bar > 0 => Origin::Bar(self.source.below(bar)),
            _ => Origin::Direction(self.source.below(4), self.source.chance(0.3)),
        }
    }

    /// Now and then the position of a point of a component without pins.
    fn positions(&mut self) {
        let pinned: Vec<_> = self.spec.pins.iter().map(|pin| self.components[pin]).collect();
        for (component, [x, y]) in [["u", "w"], ["ux", "wy"]].iter().enumerate() {
            let of = |(_, c): &(&String, &usize)| **c == component;
            let points: Vec<_> = self.components.iter().filter(of).map(|(p, _)| p.clone()).collect();
            if points.is_empty() || pinned.contains(&component) || !self.source.chance(0.3) {
                continue;
            }
            let point = self.source.choose(&points);
            for (axis, name) in [x, y].into_iter().enumerate() {
                if self.source.chance(0.7) && self.mirrored != Some(axis) {
                    let (name, point) = (name.to_string(), point.clone());
                    let negative = self.source.chance(0.4);
                    self.spec.coordinates.push(Declared::Position { name, point, axis, negative });
                }
            }
        }
    }
}
