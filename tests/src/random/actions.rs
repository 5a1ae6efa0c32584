//! Drawing springs, loads and sections.

use super::builder::Builder;
use super::expression::Expression;
use super::parts::{CoupleSpec, Force, Section, SpringSpec, TorsionSpec};
use super::quantity::Quantity;
use super::vocabulary::occurs;

impl Builder<'_> {
    pub(super) fn actions(&mut self) {
        let vocabulary = self.vocabulary;
        for _ in 0..2 {
            if occurs(self.source, vocabulary.springs) {
                self.spring();
            }
            if occurs(self.source, vocabulary.forces) {
                self.force();
            }
        }
        if occurs(self.source, vocabulary.torsions) {
            self.torsion();
        }
        if occurs(self.source, vocabulary.couples) {
            self.couple();
        }
        if occurs(self.source, vocabulary.sections) {
            self.section();
        }
    }

    /// Stiffness, damping or both.
    fn resistance(&mut self) -> [Option<Quantity>; 2] {
        let kind = self.source.below(3);
        let stiffness = (kind != 1).then(|| self.spec.parameters.positive(self.source, "s"));
        let damping = (kind != 0).then(|| self.spec.parameters.positive(self.source, "c"));
        [stiffness, damping]
    }

    fn spring(&mut self) {
        let grounds = self.spec.parts.grounds.clone();
        let first = self.moving();
        let second = match grounds.is_empty() || self.source.chance(0.5) {
            true => self.moving(),
            false => self.source.choose(&grounds),
        };
        let ends = [first, second];
        if self.rigid(&ends) {
            return;
        }
        let [stiffness, damping] = self.resistance();
        let long = stiffness.is_some() && self.source.chance(0.7);
        let length = long.then(|| self.spec.parameters.positive(self.source, "l"));
        let name = format!("coil{}", self.spec.parts.springs.len());
        self.spec.parts.springs.push(SpringSpec { name, ends, stiffness, length, damping });
    }

    fn torsion(&mut self) {
        let Some(first) = self.free_bar() else { return };
        let second = self.free_bar().filter(|&second| second != first && self.source.chance(0.7));
        let [stiffness, damping] = self.resistance();
        let angle =
            (stiffness.is_some() && self.source.chance(0.6)).then(|| self.spec.parameters.angle(self.source));
        self.spec.parts.torsions.push(TorsionSpec { first, second, stiffness, angle, damping });
    }

    fn force(&mut self) {
        let point = self.moving();
        let value = [0, 1].map(|_| self.expression(2));
        let frame = self.source.chance(0.3).then(|| self.source.below(self.spec.bars.len()));
        let taken = self.spec.parts.forces.iter().any(|force| force.name == point);
        let own = !taken && self.source.chance(0.5);
        let name = if own { point.clone() } else { format!("push{}", self.spec.parts.forces.len()) };
        self.spec.parts.forces.push(Force { name, point, value, frame });
    }

    fn couple(&mut self) {
        let on = self.source.below(self.spec.bars.len());
        let from = self.source.below(self.spec.bars.len());
        let from = (from != on && self.source.chance(0.5)).then_some(from);
        let value = self.expression(2);
        let own = from.is_none() && self.source.chance(0.5);
        let name = if own { self.spec.bars[on].name.clone() } else { "motor".into() };
        self.spec.parts.couples.push(CoupleSpec { name, on, from, value });
    }

    /// A section of a uniform bar whose joints bear no couples.
    fn section(&mut self) {
        let parts = &self.spec.parts;
        let turned = |bar: usize| {
            let torsions = parts.torsions.iter().flat_map(|torsion| [Some(torsion.first), torsion.second]);
            let couples = parts.couples.iter().flat_map(|couple| [Some(couple.on), couple.from]);
            let driven = !parts.drives.is_empty();
            driven || torsions.chain(couples).any(|other| other == Some(bar))
        };
        let bars = self.spec.bars.iter().enumerate().filter(|(index, bar)| {
            let uniform = bar.inertia.is_none() && bar.centre.is_none() && bar.corner.is_none();
            let spots = self.spec.spots.iter().any(|spot| spot.bar == *index && spot.across.is_some());
            uniform && !spots && bar.chain.is_none() && !self.is_held(*index) && !turned(*index)
        });
        let bars: Vec<_> = bars.map(|(index, _)| index).collect();
        // Between bodies that are tied by their angles a couple passes beside the bars.
        let tied = !(self.spec.ties.is_empty() && self.spec.parts.welds.is_empty());
        if bars.is_empty() || tied {
            return;
        }
        let bar = self.source.choose(&bars);
        // Sevenths: nothing else is drawn there, so that no force acts at the section itself.
        let sevenths = 1 + self.source.below(6) as i32;
        let length = &self.spec.bars[bar].length;
        let number = Quantity::literal((length.value * f64::from(100 * sevenths) / 7.0) as i32);
        // A number lies elsewhere on the bar for other parameters.
        let at = if sevenths % 2 == 0 && !number.is_zero() { number } else { length.scaled(sevenths, 7) };
        self.spec.parts.sections.push(Section { name: "cut".into(), bar, at });
    }

    fn expression(&mut self, depth: usize) -> Expression {
        use Expression::{
            Atan, Cos, Difference, Exp, Log, Max, Min, Number, Product, Quotient, Sin, Sqrt, Square, Sum,
            Tan, Tanh,
        };
        if depth == 0 || self.source.chance(0.25) {
            return self.leaf();
        }
        let one = || Box::new(Expression::literal(100));
        let a = Box::new(self.expression(depth - 1));
        match self.source.below(14) {
            0 => Sum(a, Box::new(self.expression(depth - 1))),
            1 => Difference(a, Box::new(self.expression(depth - 1))),
            2 | 3 => Product(a, Box::new(self.expression(depth - 1))),
            4 => {
                let b = Box::new(Square(Box::new(self.expression(depth - 1))));
                Quotient(a, Box::new(Sum(one(), b)))
            }
            5 => Sqrt(Box::new(Sum(one(), Box::new(Square(a))))),
            6 => Sin(a),
            9 => Exp(Box::new(Sin(a))),
            10 => Log(Box::new(Sum(one(), Box::new(Square(a))))),
            11 if depth == 1 => Atan(a),
            11 => Tanh(a),
            12 => Min(a, Box::new(self.expression(depth - 1))),
            13 => Max(a, Box::new(self.expression(depth - 1))),
            7 => Number(self.spec.parameters.positive(self.source, "f")).times(Cos(a)),
            _ => Tan(Box::new(Product(Box::new(Expression::literal(40)), Box::new(Sin(a))))),
        }
    }

    fn leaf(&mut self) -> Expression {
        let coordinates = self.spec.coordinates.len();
        match self.source.below(5) {
            0 => Expression::Time,
            1 if coordinates > 0 => {
                Expression::Coordinate(self.source.below(coordinates), self.source.chance(0.5))
            }
            2 | 3 => {
                let point = self.moving();
                Expression::Position(point, self.source.below(2), self.source.chance(0.5))
            }
            _ => Expression::Number(self.spec.parameters.signed(self.source, "f")),
        }
    }
}
