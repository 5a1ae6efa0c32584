//! The SI unit of an expression.

use super::parse::Parser;
use super::resolve::Vocabulary;
use super::tree::{Expression, Function, Operator};
use crate::model::{Layout, QuantityKind};

/// A coherent unit of the SI. An angle is a number; the power of the radian only tells rad, and the
/// unit of a torque (energy for an angle) from that of an energy.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SiUnit {
    /// Power of the kilogram.
    pub kilogram: i8,
    /// Power of the metre.
    pub metre: i8,
    /// Power of the second.
    pub second: i8,
    /// Power of the radian.
    pub radian: i8,
}

const NUMBER: SiUnit = SiUnit::new(0, 0, 0, 0);
/// That of an angle.
pub const RADIAN: SiUnit = SiUnit::new(0, 0, 0, 1);
/// That of a length.
pub const METRE: SiUnit = SiUnit::new(0, 1, 0, 0);
/// That of a time.
pub const SECOND: SiUnit = SiUnit::new(0, 0, 1, 0);
/// That of a force.
pub const NEWTON: SiUnit = SiUnit::new(1, 1, -2, 0);
/// That of an energy.
pub const JOULE: SiUnit = SiUnit::new(1, 2, -2, 0);
const NEWTON_METRE: SiUnit = SiUnit::new(1, 2, -2, -1);
const MOMENTUM: SiUnit = SiUnit::new(1, 1, -1, 0);
const ANGULAR_MOMENTUM: SiUnit = SiUnit::new(1, 2, -1, 0);

/// Degrees of a radian.
const DEGREES: f64 = 180.0 / core::f64::consts::PI;

/// Units with their symbols.
const UNITS: [(SiUnit, &str); 17] = [
    (NUMBER, ""),
    (RADIAN, "rad"),
    (METRE, "m"),
    (SECOND, "s"),
    (SiUnit::new(1, 0, 0, 0), "kg"),
    (SiUnit::new(0, 1, -1, 0), "m/s"),
    (SiUnit::new(0, 1, -2, 0), "m/s²"),
    (SiUnit::new(0, 0, -1, 1), "rad/s"),
    (SiUnit::new(0, 0, -2, 1), "rad/s²"),
    (NEWTON, "N"),
    (JOULE, "J"),
    (NEWTON_METRE, "N m"),
    (MOMENTUM, "kg m/s"),
    (ANGULAR_MOMENTUM, "kg m²/s"),
    (SiUnit::new(1, 2, -3, 0), "W"),
    (SiUnit::new(1, 0, -2, 0), "N/m"),
    (SiUnit::new(1, 2, 0, 0), "kg m²"),
];

impl SiUnit {
    /// These powers.
    pub const fn new(kilogram: i8, metre: i8, second: i8, radian: i8) -> Self {
        Self { kilogram, metre, second, radian }
    }

    /// The product with another, taken to a power.
    pub fn times(self, other: Self, power: i8) -> Self {
        let with = |a: i8, b: i8| a.saturating_add(b.saturating_mul(power));
        Self {
            kilogram: with(self.kilogram, other.kilogram),
            metre: with(self.metre, other.metre),
            second: with(self.second, other.second),
            radian: with(self.radian, other.radian),
        }
    }

    /// Whether values of both can be added.
    pub fn agrees(self, other: Self) -> bool {
        Self { radian: 0, ..self } == Self { radian: 0, ..other }
    }

    /// `N`, `kg m³`; empty for a number.
    pub fn symbol(self) -> String {
        let near = |known: &&(SiUnit, &str)| known.0.agrees(self);
        let exact = UNITS.iter().find(|(known, _)| *known == self);
        match exact.or_else(|| UNITS.iter().find(near)) {
            Some((_, unit)) => (*unit).to_owned(),
            None => self.product(),
        }
    }

    fn product(self) -> String {
        let parts = [("kg", self.kilogram), ("m", self.metre), ("s", self.second)];
        let part = |(unit, power): &(&str, i8)| match power {
            1 => (*unit).to_owned(),
            power => format!("{unit}{}", super::superscript((*power).into())),
        };
        let powers: Vec<String> = parts.iter().filter(|(_, power)| *power != 0).map(part).collect();
        powers.join(" ")
    }
}

/// The unit of an expression, empty for a number; none where it is not known. `parameters` in the
/// layout's order.
pub fn unit(text: &str, layout: &'static Layout, parameters: &[Option<SiUnit>]) -> Option<String> {
    let mut parser = Parser::new(text, Vocabulary::new(layout)).ok()?;
    let expression = parser.sum().ok()?;
    let Measured { unit, factor } = expression.measured(layout, parameters)?;
    let in_degrees = (factor.abs() / DEGREES - 1.0).abs() < 1e-6 && unit == RADIAN;
    Some(if in_degrees { "°".to_owned() } else { unit.symbol() })
}

/// The same as powers of base units, whatever constant factor stands before it.
pub fn si_unit(text: &str, layout: &'static Layout, parameters: &[Option<SiUnit>]) -> Option<SiUnit> {
    let expression = Parser::new(text, Vocabulary::new(layout)).ok()?.sum().ok()?;
    Some(expression.measured(layout, parameters)?.unit)
}

/// A unit and the constant factor before it.
#[derive(Clone, Copy)]
struct Measured {
    unit: SiUnit,
    factor: f64,
}

impl Expression {
    fn measured(&self, layout: &'static Layout, parameters: &[Option<SiUnit>]) -> Option<Measured> {
        let of = |x: &Self| x.measured(layout, parameters);
        let unit = match self {
            Self::Number(x) => return Some(Measured { unit: NUMBER, factor: *x }),
            Self::Parameter(i) => (*parameters.get(*i)?)?,
            Self::Time => SECOND,
            Self::Coordinate { index, order } => {
                let base = if layout.coordinates[*index].is_angle { RADIAN } else { METRE };
                base.times(SECOND, -i8::try_from(*order).ok()?)
            }
            Self::Coefficient(_) => NUMBER,
            Self::Slip(_) => METRE.times(SECOND, -1),
            Self::Point { order, .. } => METRE.times(SECOND, -i8::try_from(*order).ok()?),
            Self::Reaction { contact, .. } if layout.is_turned(*contact) => NEWTON_METRE,
            Self::Reaction { .. } | Self::Friction { .. } => NEWTON,
            Self::Quantity(entry) => of_quantity(layout.quantities[*entry].kind),
            Self::Gap(contact) if layout.is_turned(*contact) => RADIAN,
            Self::Gap(_) => METRE,
            Self::Kinetic | Self::Potential | Self::Energy | Self::Dissipated => JOULE,
            Self::Apply(function, x) => return of(x)?.under(*function),
            Self::Join(Operator::Where | Operator::Unless, _, b) => return of(b),
            Self::Join(operator, a, b) => return of(a)?.joined(*operator, of(b)?, b),
        };
        Some(Measured { unit, factor: 1.0 })
    }
}

impl Measured {
    fn under(self, function: Function) -> Option<Self> {
        let SiUnit { kilogram, metre, second, .. } = self.unit;
        match function {
            Function::Negate | Function::Abs => Some(self),
            Function::Sign => Some(Self { unit: NUMBER, factor: 1.0 }),
            Function::Atan => NUMBER.agrees(self.unit).then_some(Self { unit: RADIAN, factor: 1.0 }),
            Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Exp
            | Function::Log
            | Function::Tanh => {
                let number = Self { unit: NUMBER, factor: 1.0 };
                NUMBER.agrees(self.unit).then_some(number)
            }
            Function::Sqrt => {
                let whole = [kilogram, metre, second].iter().all(|power| power % 2 == 0);
                let unit = SiUnit::new(kilogram / 2, metre / 2, second / 2, 0);
                whole.then_some(Self { unit, factor: self.factor.sqrt() })
            }
        }
    }

    /// A bare number added is taken to have the unit of what it is added to.
    fn joined(self, operator: Operator, other: Self, right: &Expression) -> Option<Self> {
        let (a, b) = (self.unit, other.unit);
        match operator {
            Operator::Add | Operator::Subtract if a == b => Some(Self { factor: 1.0, ..self }),
            Operator::Add | Operator::Subtract if b == NUMBER || a.agrees(b) && a != NUMBER => {
                Some(Self { factor: 1.0, ..self })
            }
            Operator::Add | Operator::Subtract => (a == NUMBER).then_some(Self { factor: 1.0, ..other }),
            Operator::Where | Operator::Unless => Some(Self { factor: 1.0, ..other }),
            Operator::Atan2 => {
                let alike = a.agrees(b) || a == NUMBER || b == NUMBER;
                alike.then_some(Self { unit: RADIAN, factor: 1.0 })
            }
            Operator::Multiply => Some(Self { unit: a.times(b, 1), factor: self.factor * other.factor }),
            Operator::Divide => Some(Self { unit: a.times(b, -1), factor: self.factor / other.factor }),
            Operator::Power => {
                let power = right.constant(&[])?;
                let whole = power.fract() == 0.0 && power.abs() < 10.0;
                let unit = NUMBER.times(a, power as i8);
                (whole || a == NUMBER).then_some(Self { unit, factor: self.factor.powf(power) })
            }
        }
    }
}

fn of_quantity(kind: QuantityKind) -> SiUnit {
    match kind {
        QuantityKind::JointForce
        | QuantityKind::DriveForce
        | QuantityKind::SpringForce
        | QuantityKind::SectionForce => NEWTON,
        QuantityKind::DrivenDistance => METRE,
        QuantityKind::JointCouple
        | QuantityKind::DriveTorque
        | QuantityKind::SpringTorque
        | QuantityKind::BendingMoment => NEWTON_METRE,
        QuantityKind::Momentum => MOMENTUM,
        QuantityKind::AngularMomentum => ANGULAR_MOMENTUM,
    }
}
