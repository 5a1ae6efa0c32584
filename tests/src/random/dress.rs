//! Drawing what acts on the bars: gravity, masses, pins, supports, declared coordinates, equal angles.

use super::builder::Builder;
use super::quantity::Quantity;
use super::scheme::{Declared, Gravity, Origin, Scheme, Shape, Support, Tie};
use super::splitmix::Source;

const ANGLES: [&str; 8] = ["phi", "psi", "chi", "beta", "gamma", "delta", "eta", "zeta"];

/// Draws a whole scheme; whether it makes sense as a mechanism is for the oracle to say.
pub fn scheme(draw: &mut Source) -> Scheme {
    let mut builder = Builder::new(draw);
    builder.bars();
    builder.gravity();
    builder.pins();
    builder.masses();
    builder.supports();
    builder.ties();
    builder.coordinates();
    builder.positions();
    if builder.scheme.parameters.fields.is_empty() {
        let mass = builder.scheme.parameters.field(builder.draw, "m");
        builder
            .scheme
            .masses
            .push((builder.scheme.bars[0].to.clone(), mass));
    }
    builder.scheme
}

impl Builder<'_> {
    fn gravity(&mut self) {
        let (draw, parameters) = (&mut *self.draw, &mut self.scheme.parameters);
        self.scheme.gravity = match draw.below(5) {
            0 => Gravity::None,
            1 | 2 => Gravity::Down(parameters.positive(draw, "g")),
            _ => {
                let x = parameters.positive(draw, "g");
                Gravity::Vector([x, Quantity::literal(draw.of(&[-981, -150, 70]))])
            }
        };
    }

    /// Points whose place in the figure is given or follows from what is given.
    fn points(&self) -> Vec<String> {
        let undrawn = |point: &str| {
            let bars = self.scheme.bars.iter().filter(|bar| bar.to == point);
            bars.filter_map(|bar| bar.chain)
                .any(|chain| !self.scheme.chains[chain].drawn)
        };
        self.scheme
            .figure
            .keys()
            .filter(|point| !undrawn(point))
            .cloned()
            .collect()
    }

    fn pins(&mut self) {
        let count = self.draw.of(&[0, 0, 0, 1, 1, 1, 1, 2, 2]);
        for _ in 0..count {
            let points = self.points();
            let point = self.draw.of(&points);
            if !self.scheme.pins.contains(&point) {
                self.scheme.pins.push(point);
            }
        }
    }

    fn masses(&mut self) {
        for _ in 0..self.draw.below(5).saturating_sub(2) {
            let points: Vec<_> = self.scheme.figure.keys().cloned().collect();
            let point = self.draw.of(&points);
            let mass = self.scheme.parameters.positive(self.draw, "m");
            self.scheme.masses.push((point, mass));
        }
        let massless: Vec<_> = self
            .scheme
            .bars
            .iter()
            .filter(|bar| bar.mass.is_zero())
            .collect();
        for point in massless.into_iter().map(|bar| bar.to.clone()) {
            let mass = self.scheme.parameters.positive(self.draw, "m");
            self.scheme.masses.push((point, mass));
        }
    }

    fn supports(&mut self) {
        let several = self.components.values().any(|&component| component > 0);
        for component in 0..if several { 2 } else { 0 } {
            let known: Vec<_> = self.points();
            let of = |point: &&String| self.components[*point] == component;
            let points: Vec<_> = known.iter().filter(of).cloned().collect();
            self.point_support(&points);
        }
        for _ in 0..self.draw.below(4) {
            let points = self.points();
            if self.draw.chance(0.3) {
                self.corner()
            } else {
                self.point_support(&points)
            }
        }
    }

    fn point_support(&mut self, points: &[String]) {
        let free: Vec<_> = points
            .iter()
            .filter(|p| !self.scheme.pins.contains(p))
            .cloned()
            .collect();
        if free.is_empty() {
            return;
        }
        let point = self.draw.of(&free);
        let taken = self
            .scheme
            .supports
            .iter()
            .any(|support| support.name == point);
        let own = !taken && self.draw.chance(0.7);
        let name = if own {
            point.clone()
        } else {
            format!("s{}", self.scheme.supports.len())
        };
        let shape = self.line(&point);
        self.scheme.supports.push(Support { name, point, shape });
    }

    fn line(&mut self, point: &str) -> Shape {
        let (draw, parameters) = (&mut *self.draw, &mut self.scheme.parameters);
        match draw.below(4) {
            0 => Shape::Floor(None),
            1 => Shape::Floor(Some(parameters.signed(draw, "h"))),
            2 => {
                let at = parameters.signed(draw, "h");
                let off = self.scheme.figure[point][0].nominal - at.nominal;
                let said = off.abs() < 0.05 || draw.chance(0.5);
                let side = if said {
                    draw.of(&[-1.0, 1.0])
                } else {
                    off.signum()
                };
                Shape::Wall { at, side, said }
            }
            _ => {
                let angle = parameters.angle(draw);
                let through = draw
                    .chance(0.5)
                    .then(|| [0, 1].map(|_| parameters.signed(draw, "h")));
                Shape::Slope { angle, through }
            }
        }
    }

    fn corner(&mut self) {
        let bar = self.draw.below(self.scheme.bars.len());
        if self.scheme.bars[bar].heading.p == 0 || self.undrawn(bar) {
            return;
        }
        let at = [0, 1].map(|_| self.scheme.parameters.signed(self.draw, "h"));
        let shape = Shape::Corner {
            bar,
            at,
            under: self.draw.chance(0.6),
        };
        let name = format!("peg{}", self.scheme.supports.len());
        self.scheme.supports.push(Support {
            name,
            point: String::new(),
            shape,
        });
    }

    fn undrawn(&self, bar: usize) -> bool {
        self.scheme.bars[bar]
            .chain
            .is_some_and(|chain| !self.scheme.chains[chain].drawn)
    }

    fn ties(&mut self) {
        for (a, b) in self.twins.clone() {
            let (left, right) = (self.scheme.bars[a].heading, self.scheme.bars[b].heading);
            let alike = left == right;
            let mirrored =
                left.slanted() && (left.p.abs(), left.q.abs()) == (right.p.abs(), right.q.abs());
            let declared = self.declared(a) || self.declared(b);
            if self.scheme.bars[b].chain.is_some() || !self.draw.chance(0.6) {
                continue;
            }
            if mirrored && !declared && self.draw.chance(0.6) {
                let line = self.draw.of(&["horizontal", "vertical"]);
                let [first, second] = [a, b].map(|bar| self.angle(bar, Origin::Line(line)));
                self.scheme.ties.push(Tie::Coordinates(first, second));
            } else if alike {
                self.scheme.ties.push(Tie::Bars(a, b));
            }
        }
    }

    fn declared(&self, wanted: usize) -> bool {
        let is =
            |declared: &Declared| matches!(declared, Declared::Angle { bar, .. } if *bar == wanted);
        self.scheme.coordinates.iter().any(is)
    }

    fn angle(&mut self, bar: usize, origin: Origin) -> usize {
        let index = self.scheme.coordinates.len();
        let name = ANGLES[index % ANGLES.len()].to_string();
        self.scheme
            .coordinates
            .push(Declared::Angle { name, bar, origin });
        index
    }

    fn coordinates(&mut self) {
        for bar in 0..self.scheme.bars.len() {
            if self.scheme.coordinates.len() >= ANGLES.len()
                || self.declared(bar)
                || self.undrawn(bar)
            {
                continue;
            }
            if self.draw.chance(0.2) {
                let origin = self.origin(bar);
                self.angle(bar, origin);
            }
        }
    }

    fn origin(&mut self, bar: usize) -> Origin {
        let heading = self.scheme.bars[bar].heading;
        match self.draw.below(4) {
            0 if heading.slanted() || heading.q == 0 => Origin::Line("horizontal"),
            1 if heading.slanted() || heading.p == 0 => Origin::Line("vertical"),
            2 if bar > 0 => Origin::Bar(self.draw.below(bar)),
            _ => Origin::Direction(self.draw.below(4), self.draw.chance(0.3)),
        }
    }

    /// Now and then the position of a point of a component without pins.
    fn positions(&mut self) {
        let pinned: Vec<_> = self
            .scheme
            .pins
            .iter()
            .map(|pin| self.components[pin])
            .collect();
        for (component, [x, y]) in [["u", "w"], ["ux", "wy"]].iter().enumerate() {
            let of = |(_, c): &(&String, &usize)| **c == component;
            let points: Vec<_> = self
                .components
                .iter()
                .filter(of)
                .map(|(p, _)| p.clone())
                .collect();
            if points.is_empty() || pinned.contains(&component) || !self.draw.chance(0.3) {
                continue;
            }
            let point = self.draw.of(&points);
            for (axis, name) in [x, y].into_iter().enumerate() {
                if self.draw.chance(0.7) {
                    let (name, point) = (name.to_string(), point.clone());
                    let negative = self.draw.chance(0.4);
                    self.scheme.coordinates.push(Declared::Position {
                        name,
                        point,
                        axis,
                        negative,
                    });
                }
            }
        }
    }
}
