//! What an expression is measured in.

use super::parse::Parser;
use super::resolve::Vocabulary;
use super::tree::{Expression, Function, Operator};
use crate::model::Layout;

/// Powers of mass, length, time and angle. An angle is a number; its power only tells rad, and a torque (energy for an
/// angle) from an energy.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Dimension {
    /// Of mass.
    pub mass: i8,
    /// Of length.
    pub length: i8,
    /// Of time.
    pub time: i8,
    /// Of angle.
    pub angle: i8,
}

const NUMBER: Dimension = Dimension::new(0, 0, 0, 0);
const ANGLE: Dimension = Dimension::new(0, 0, 0, 1);
/// That of a length.
pub const LENGTH: Dimension = Dimension::new(0, 1, 0, 0);
const TIME: Dimension = Dimension::new(0, 0, 1, 0);
const FORCE: Dimension = Dimension::new(1, 1, -2, 0);
const ENERGY: Dimension = Dimension::new(1, 2, -2, 0);
const TORQUE: Dimension = Dimension::new(1, 2, -2, -1);
const MOMENTUM: Dimension = Dimension::new(1, 1, -1, 0);
const ANGULAR_MOMENTUM: Dimension = Dimension::new(1, 2, -1, 0);

/// Degrees of a radian.
const DEGREES: f64 = 180.0 / core::f64::consts::PI;

/// A unit with the dimension that it is for.
const UNITS: [(Dimension, &str); 17] = [
    (NUMBER, ""),
    (ANGLE, "rad"),
    (LENGTH, "m"),
    (TIME, "s"),
    (Dimension::new(1, 0, 0, 0), "kg"),
    (Dimension::new(0, 1, -1, 0), "m/s"),
    (Dimension::new(0, 1, -2, 0), "m/s²"),
    (Dimension::new(0, 0, -1, 1), "rad/s"),
    (Dimension::new(0, 0, -2, 1), "rad/s²"),
    (FORCE, "N"),
    (ENERGY, "J"),
    (TORQUE, "N m"),
    (MOMENTUM, "kg m/s"),
    (ANGULAR_MOMENTUM, "kg m²/s"),
    (Dimension::new(1, 2, -3, 0), "W"),
    (Dimension::new(1, 0, -2, 0), "N/m"),
    (Dimension::new(1, 2, 0, 0), "kg m²"),
];

impl Dimension {
    /// These powers.
    pub const fn new(mass: i8, length: i8, time: i8, angle: i8) -> Self {
        Self { mass, length, time, angle }
    }

    /// The product with another, taken to a power.
    pub fn times(self, other: Self, power: i8) -> Self {
        let with = |a: i8, b: i8| a.saturating_add(b.saturating_mul(power));
        Self {
            mass: with(self.mass, other.mass),
            length: with(self.length, other.length),
            time: with(self.time, other.time),
            angle: with(self.angle, other.angle),
        }
    }

    /// Whether values of both can be added.
    fn agrees(self, other: Self) -> bool {
        Self { angle: 0, ..self } == Self { angle: 0, ..other }
    }

    /// Its unit of the SI; empty for a number.
    pub fn unit(self) -> String {
        let near = |known: &&(Dimension, &str)| known.0.agrees(self);
        let exact = UNITS.iter().find(|(known, _)| *known == self);
        match exact.or_else(|| UNITS.iter().find(near)) {
            Some((_, unit)) => (*unit).to_owned(),
            None => self.product(),
        }
    }

    fn product(self) -> String {
        let parts = [("kg", self.mass), ("m", self.length), ("s", self.time)];
        let part = |(unit, power): &(&str, i8)| match power {
            1 => (*unit).to_owned(),
            power => format!("{unit}{}", super::superscript((*power).into())),
        };
        let powers: Vec<String> = parts.iter().filter(|(_, power)| *power != 0).map(part).collect();
        powers.join(" ")
    }
}

/// The unit of an expression, empty for a number; none where it is not known. `parameters` in the layout's order.
pub fn unit(text: &str, layout: &'static Layout, parameters: &[Option<Dimension>]) -> Option<String> {
    let mut parser = Parser::new(text, Vocabulary::of(layout)).ok()?;
    let expression = parser.sum().ok()?;
    let Measured { dimension, factor } = expression.measured(layout, parameters)?;
    let in_degrees = (factor.abs() / DEGREES - 1.0).abs() < 1e-6 && dimension == ANGLE;
    Some(if in_degrees { "°".to_owned() } else { dimension.unit() })
}

/// A dimension and the constant factor before it.
#[derive(Clone, Copy)]
struct Measured {
    dimension: Dimension,
    factor: f64,
}

impl Expression {
    fn measured(&self, layout: &'static Layout, parameters: &[Option<Dimension>]) -> Option<Measured> {
        let of = |x: &Self| x.measured(layout, parameters);
        let dimension = match self {
            Self::Number(x) => return Some(Measured { dimension: NUMBER, factor: *x }),
            Self::Parameter(i) => (*parameters.get(*i)?)?,
            Self::Time => TIME,
            Self::Coordinate { index, order } => {
                let base = if layout.coordinates[*index].is_angle { ANGLE } else { LENGTH };
                base.times(TIME, -i8::try_from(*order).ok()?)
            }
            Self::Point { order, .. } => LENGTH.times(TIME, -i8::try_from(*order).ok()?),
            Self::Reaction { .. } | Self::Friction { .. } => FORCE,
            Self::Quantity { entry, .. } => quantity(layout, layout.quantities[*entry])?,
            Self::Gap(_) => LENGTH,
            Self::Kinetic | Self::Potential | Self::Energy => ENERGY,
            Self::Apply(function, x) => return of(x)?.under(*function),
            Self::Join(operator, a, b) => return of(a)?.joined(*operator, of(b)?, b),
        };
        Some(Measured { dimension, factor: 1.0 })
    }
}

impl Measured {
    fn under(self, function: Function) -> Option<Self> {
        let Dimension { mass, length, time, .. } = self.dimension;
        match function {
            Function::Negate | Function::Abs => Some(self),
            Function::Sin | Function::Cos | Function::Tan => {
                let number = Self { dimension: NUMBER, factor: 1.0 };
                NUMBER.agrees(self.dimension).then_some(number)
            }
            Function::Sqrt => {
                let whole = [mass, length, time].iter().all(|power| power % 2 == 0);
                let dimension = Dimension::new(mass / 2, length / 2, time / 2, 0);
                whole.then_some(Self { dimension, factor: self.factor.sqrt() })
            }
        }
    }

    /// A bare number added is taken to have the unit of what it is added to.
    fn joined(self, operator: Operator, other: Self, right: &Expression) -> Option<Self> {
        let (a, b) = (self.dimension, other.dimension);
        match operator {
            Operator::Add | Operator::Subtract if a == b => Some(Self { factor: 1.0, ..self }),
            Operator::Add | Operator::Subtract if b == NUMBER || a.agrees(b) && a != NUMBER => {
                Some(Self { factor: 1.0, ..self })
            }
            Operator::Add | Operator::Subtract => (a == NUMBER).then_some(Self { factor: 1.0, ..other }),
            Operator::Multiply => Some(Self { dimension: a.times(b, 1), factor: self.factor * other.factor }),
            Operator::Divide => Some(Self { dimension: a.times(b, -1), factor: self.factor / other.factor }),
            Operator::Power => {
                let power = right.constant(&[])?;
                let whole = power.fract() == 0.0 && power.abs() < 10.0;
                let dimension = NUMBER.times(a, power as i8);
                (whole || a == NUMBER).then_some(Self { dimension, factor: self.factor.powf(power) })
            }
        }
    }
}

/// Of what a model names: a drive's force is a couple where it drives an angle.
fn quantity(layout: &Layout, name: &str) -> Option<Dimension> {
    let (head, argument) = name.split_once('(').unwrap_or((name, ""));
    let argument = argument.trim_end_matches(')');
    let is_angle = |name: &str| layout.coordinates.iter().any(|c| c.name == name && c.is_angle);
    Some(match head {
        "fx" | "fy" | "force" | "normal" | "shear" | "slider" => FORCE,
        "drive" if is_angle(argument) || argument.starts_with("angle") => TORQUE,
        "drive" => FORCE,
        "torque" | "moment" | "couple" => TORQUE,
        "px" | "py" => MOMENTUM,
        "Lz" => ANGULAR_MOMENTUM,
        _ => return None,
    })
}
