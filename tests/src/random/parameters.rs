//! Parameters and named constants, drawn as they are needed, so that none goes unused.

use super::quantity::Quantity;
use super::splitmix::Source;

/// What the struct's fields and its named constants are.
#[derive(Clone, Debug, Default)]
pub struct Parameters {
    /// Name and value of each field, in order.
    pub fields: Vec<(String, f64)>,
    /// Name and expression of each constant, in order.
    pub constants: Vec<(String, Quantity)>,
    /// How often a quantity is an expression of parameters instead of a number.
    pub share: f64,
}

impl Parameters {
    /// A positive number of some unity, or an expression of parameters `prefix1`, `prefix2`, ….
    pub fn positive(&mut self, source: &mut Source, prefix: &str) -> Quantity {
        if !source.chance(self.share) {
            return Quantity::literal(30 + source.below(220) as i32);
        }
        let base = self.field(source, prefix);
        match source.below(12) {
            0 => base.scaled(1 + source.below(4) as i32, 1 + source.below(5) as i32),
            1 => base.plus(&Quantity::literal(25)),
            2 => base.squared().plus(&Quantity::literal(100)).under("sqrt", f64::sqrt),
            3 => base.over(&self.field(source, prefix).plus(&Quantity::literal(100))),
            4 => self.constant(base.times(&Quantity::literal(40).under("cos", f64::cos))),
            5 => base.times(&Quantity::literal(70).under("sin", f64::sin)),
            _ => base,
        }
    }

    /// A number of either sign, zero among them.
    pub fn signed(&mut self, source: &mut Source, prefix: &str) -> Quantity {
        match source.below(4) {
            0 => Quantity::literal(0),
            1 => self.positive(source, prefix),
            2 => self.positive(source, prefix).negated(),
            _ => Quantity::literal(source.below(300) as i32 - 150),
        }
    }

    /// An angle between −1.5 and 1.5, or a parameter.
    pub fn angle(&mut self, source: &mut Source) -> Quantity {
        if !source.chance(self.share) {
            return Quantity::literal(source.below(300) as i32 - 150);
        }
        let angle = self.field(source, "alpha");
        let quarter = Quantity::named("pi", std::f64::consts::PI, std::f64::consts::PI).scaled(1, 2);
        match source.below(4) {
            0 => quarter.minus(&angle),
            1 => angle.scaled(2, 1).negated().plus(&quarter),
            2 => angle.scaled(1, 2),
            _ => angle,
        }
    }

    /// A field of this prefix, an old one half of the time.
    pub fn field(&mut self, source: &mut Source, prefix: &str) -> Quantity {
        let old = |(name, _): &&(String, f64)| name.trim_end_matches(char::is_numeric) == prefix;
        let known: Vec<_> = self.fields.iter().filter(old).cloned().collect();
        let (name, value) = if !known.is_empty() && source.chance(0.5) {
            source.choose(&known)
        } else {
            self.fields.push((format!("{prefix}{}", known.len() + 1), source.range(0.5, 2.0)));
            self.fields[self.fields.len() - 1].clone()
        };
        Quantity::named(&name, value, 1.0)
    }

    fn constant(&mut self, expression: Quantity) -> Quantity {
        let name = format!("k{}", self.constants.len() + 1);
        let quantity = Quantity::named(&name, expression.value, expression.nominal);
        self.constants.push((name, expression));
        quantity
    }
}
