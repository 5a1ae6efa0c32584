//! Expressions that are no Poisson series, and the opaque terms that stand for them in series.

use crate::algebra::{Angle, Quotient, Rational, Series, Symbol};
use crate::elementary::Elementary;
use crate::kinematics::Kinematics;
use crate::system::{Driven, Formula, Function, Operator, Reading, System};

/// An expression of series, angles and time.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A series or a quotient of series.
    Value(Quotient),
    /// An angle, as a number.
    Angle(Angle),
    /// t.
    Time,
    /// A function of an expression.
    Apply(Function, Box<Expression>),
    /// Two expressions joined.
    Join(Operator, Box<Expression>, Box<Expression>),
}

impl Expression {
    /// A series.
    pub fn series(series: Series) -> Self {
        Self::Value(series.into())
    }

    /// The series that it is.
    fn as_series(&self) -> Option<&Series> {
        if let Self::Value(quotient) = self { quotient.as_series() } else { None }
    }

    /// What a declared formula means in the generalised coordinates.
    pub(super) fn from_formula(formula: &Formula, system: &System, kinematics: &Kinematics) -> Self {
        Self::of_slip(formula, system, kinematics, &Series::zero())
    }

    /// The same of a formula that may read a slip velocity.
    pub(super) fn of_slip(
        formula: &Formula,
        system: &System,
        kinematics: &Kinematics,
        slip: &Series,
    ) -> Self {
        let of = |inner: &Formula| Self::of_slip(inner, system, kinematics, slip);
        match formula {
            Formula::Constant(series) => Self::series(series.clone()),
            Formula::Time => Self::Time,
            Formula::Slip => Self::series(slip.clone()),
            Formula::Switch(i) => Self::series(Series::symbol(Symbol::Switch(*i as u16))),
            Formula::Motion { reading, rate } => {
                let (series, constant) = kinematics.derive_reading(system, *reading);
                let turns = match reading {
                    Reading::Direction(body) => kinematics.lost_turns(system, None, *body),
                    _ => 0,
                };
                match (rate, constant == Angle::zero()) {
                    (true, _) => Self::series(series.rate()),
                    (false, true) => Self::series(series).plus_turns(turns),
                    (false, false) => Self::series(series).plus(Self::Angle(constant)).plus_turns(turns),
                }
            }
            Formula::Apply(function, inner) => of(inner).apply(*function),
            Formula::Join(operator, a, b) => of(a).join(*operator, of(b)),
        }
    }

    /// A value of what is driven, less the constant angle that its series leaves out.
    pub(super) fn less_constant(self, driven: &Driven, system: &System, kinematics: &Kinematics) -> Self {
        let (_, constant) = kinematics.driven(system, driven);
        let value = if constant == Angle::zero() { self } else { self.minus(Self::Angle(constant)) };
        match driven {
            Driven::Turn { from, body } => {
                value.plus_turns(-kinematics.lost_turns(system, Some(*from), *body))
            }
            Driven::Reading(Reading::Direction(body)) => {
                value.plus_turns(-kinematics.lost_turns(system, None, *body))
            }
            _ => value,
        }
    }

    /// Full turns more.
    pub fn plus_turns(self, turns: i64) -> Self {
        let half = || Self::Angle(Angle::quarters(2));
        match turns {
            0 => self,
            1.. => self.plus(half()).plus(half()),
            _ => self.minus(half()).minus(half()),
        }
    }

    pub(super) fn apply(self, function: Function) -> Self {
        Self::Apply(function, Box::new(self))
    }

    pub(super) fn join(self, operator: Operator, other: Self) -> Self {
        Self::Join(operator, Box::new(self), Box::new(other))
    }

    pub(super) fn plus(self, other: Self) -> Self {
        self.join(Operator::Add, other)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.join(Operator::Subtract, other)
    }

    pub(super) fn times(self, other: Self) -> Self {
        self.join(Operator::Multiply, other)
    }

    pub(super) fn over(self, other: Self) -> Self {
        self.join(Operator::Divide, other)
    }

    pub(super) fn sqrt(self) -> Self {
        self.apply(Function::Sqrt)
    }

    /// The same with other values, and expressions in place of angles.
    pub fn map(&self, value: &dyn Fn(&Quotient) -> Quotient, angle: &dyn Fn(&Angle) -> Self) -> Self {
        match self {
            Self::Value(quotient) => Self::Value(value(quotient)),
            Self::Angle(turn) => angle(turn),
            Self::Time => Self::Time,
            Self::Apply(function, inner) => inner.map(value, angle).apply(*function),
            Self::Join(operator, a, b) => a.map(value, angle).join(*operator, b.map(value, angle)),
        }
    }

    /// d/dt.
    pub(super) fn rate(&self) -> Self {
        match self {
            Self::Value(quotient) => Self::Value(quotient.rate()),
            Self::Angle(angle) => Self::series(angle.rate()),
            Self::Time => Self::series(Series::one()),
            Self::Apply(function, inner) => inner.slope(*function).times(inner.rate()),
            Self::Join(operator, a, b) => {
                let (da, db) = (a.rate(), b.rate());
                let (a, b) = (a.as_ref().clone(), b.as_ref().clone());
                match operator {
                    Operator::Add => da.plus(db),
                    Operator::Subtract => da.minus(db),
                    Operator::Multiply => da.times(b).plus(a.times(db)),
                    Operator::Divide => da.minus(a.over(b.clone()).times(db)).over(b),
                }
            }
        }
    }

    /// The derivative of a function at this expression.
    fn slope(&self, function: Function) -> Self {
        let number = |p, q| Self::series(Series::constant(Rational::new(p, q)));
        let own = || self.clone();
        match function {
            Function::Negate => number(-1, 1),
            Function::Sqrt => number(1, 2).over(own().sqrt()),
            Function::Sin => own().apply(Function::Cos),
            Function::Cos => own().apply(Function::Sin).apply(Function::Negate),
            Function::Tan => number(1, 1).over(own().apply(Function::Cos).apply(Function::Power(2))),
            Function::Power(n) => number(n.into(), 1).times(own().apply(Function::Power(n - 1))),
            Function::Elementary(Elementary::Exp) => own().apply(function),
            Function::Elementary(Elementary::Log) => number(1, 1).over(own()),
            Function::Elementary(Elementary::Tanh) => {
                number(1, 1).minus(own().apply(function).apply(Function::Power(2)))
            }
            Function::Elementary(Elementary::Table(table)) => match table.slope() {
                Some(slope) => own().apply(Function::Elementary(Elementary::Table(slope))),
                None => number(0, 1),
            },
            Function::Elementary(Elementary::Atan) => {
                number(1, 1).over(number(1, 1).plus(own().apply(Function::Power(2))))
            }
        }
    }

    /// Whether time occurs.
    pub fn has_time(&self) -> bool {
        match self {
            Self::Value(_) | Self::Angle(_) => false,
            Self::Time => true,
            Self::Apply(_, inner) => inner.has_time(),
            Self::Join(_, a, b) => a.has_time() || b.has_time(),
        }
    }
}

/// An opaque term: a name, its value and as many of its time derivatives as are used.
#[derive(Clone, Debug)]
pub struct OpaqueTerm {
    /// Its name in texts.
    pub name: String,
    /// Its value, then its time derivatives.
    pub orders: Vec<Expression>,
}

impl OpaqueTerm {
    fn motion(name: String, value: Expression) -> Self {
        let rate = value.rate();
        let acceleration = rate.rate();
        Self { name, orders: vec![value, rate, acceleration] }
    }
}

/// The opaque terms met so far; those of the drives come first.
#[derive(Clone, Debug, Default)]
pub(super) struct OpaqueTerms(pub Vec<OpaqueTerm>);

impl OpaqueTerms {
    /// The prescribed motions with their first two derivatives: what is driven is `f(t)` less its
    /// constant angle, of a distance that is always driven `f²/2d₀`.
    pub fn of_drives(system: &System, kinematics: &Kinematics) -> Self {
        let opaque_terms = system.drives.iter().enumerate().map(|(i, drive)| {
            let value = Expression::from_formula(&drive.value, system, kinematics);
            let value = match &drive.driven {
                Driven::Distance { inverse, .. } if !drive.switched => {
                    let half = Expression::series(inverse.scale(Rational::HALF));
                    half.times(value.clone().times(value))
                }
                _ => value,
            };
            let value = value.less_constant(&drive.driven, system, kinematics);
            OpaqueTerm::motion(format!("f{}", i + 1), value)
        });
        Self(opaque_terms.collect())
    }

    /// What the i-th drive prescribes; a series stands for itself.
    pub fn prescribed(&self, i: usize) -> Series {
        let constant = self.0[i].orders[0].as_series().cloned();
        constant.unwrap_or_else(|| Series::symbol(Symbol::opaque(i)))
    }

    /// The symbol of a function of time with its first two derivatives.
    pub fn motion(&mut self, name: String, value: Expression) -> Series {
        self.0.push(OpaqueTerm::motion(name, value));
        Series::symbol(Symbol::opaque(self.0.len() - 1))
    }

    /// The symbol of a velocity, of which the rate is known too.
    pub fn velocity(&mut self, name: &str, expression: Expression) -> Series {
        let slope = expression.rate();
        let series = self.symbol(name, expression);
        if let Some(Symbol::Opaque { index, .. }) = series.symbols().into_iter().next()
            && let Some(term) = self.0.get_mut(usize::from(index))
            && term.orders.len() == 1
        {
            term.orders.push(slope);
        }
        series
    }

    /// The symbol of an expression; a series stands for itself.
    pub fn symbol(&mut self, name: &str, expression: Expression) -> Series {
        if let Some(series) = expression.as_series() {
            return series.clone();
        }
        let known = self.0.iter().position(|opaque_term| opaque_term.orders == [expression.clone()]);
        let index = known.unwrap_or_else(|| {
            self.0.push(OpaqueTerm { name: name.to_owned(), orders: vec![expression] });
            self.0.len() - 1
        });
        Series::symbol(Symbol::opaque(index))
    }
}
