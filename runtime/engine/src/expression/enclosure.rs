//! Bounds of an expression and of its slope over a piece of a step, from those of what it reads: a
//! proof that it is not zero there, or that it is zero once at most.

use super::condition::Condition;
use super::environment::{Environment, Variable};
use super::interval::Interval;
use super::tree::{Function, Operator};
use core::cell::RefCell;

/// All values and all slopes over a piece of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Enclosure {
    pub(crate) value: Interval,
    pub(crate) slope: Interval,
}

impl Enclosure {
    const fn constant(x: f64) -> Self {
        Self { value: Interval::exactly(x), slope: Interval::ZERO }
    }

    /// f(x) and f′(x) x′.
    fn chain(self, value: Interval, derivative: Interval) -> Self {
        Self { value, slope: derivative.times(self.slope) }
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        Self { value: self.value.minus(other.value), slope: self.slope.minus(other.slope) }
    }

    fn times(self, other: Self) -> Self {
        let slope = self.slope.times(other.value).plus(self.value.times(other.slope));
        Self { value: self.value.times(other.value), slope }
    }

    fn reciprocal(self) -> Self {
        let value = self.value.reciprocal();
        self.chain(value, value.powi(2).negated())
    }

    fn apply(self, function: Function) -> Self {
        let x = self.value;
        match function {
            Function::Negate => Self { value: x.negated(), slope: self.slope.negated() },
            Function::Sqrt => {
                let root = x.sqrt();
                self.chain(root, root.plus(root).reciprocal())
            }
            Function::Sin => self.chain(x.sin(), x.cos()),
            Function::Cos => self.chain(x.cos(), x.sin().negated()),
            Function::Tan => {
                let [sin, cos] = [Function::Sin, Function::Cos].map(|function| self.apply(function));
                sin.times(cos.reciprocal())
            }
            Function::Exp => self.chain(x.exp(), x.exp()),
            Function::Log => self.chain(x.ln(), x.reciprocal()),
            Function::Tanh => {
                let value = x.tanh();
                self.chain(value, Interval::exactly(1.0).minus(value.powi(2)))
            }
            Function::Atan => {
                let below = Interval::exactly(1.0).plus(x.powi(2));
                self.chain(x.atan(), below.reciprocal())
            }
            Function::Sign if !x.contains(0.0) => Self::constant(x.low.signum()),
            Function::Sign => Self { value: Interval::around(0.0, 1.0), slope: Interval::WHOLE },
            Function::Abs if x.low >= 0.0 => self,
            Function::Abs if x.high <= 0.0 => self.apply(Function::Negate),
            Function::Abs => Self { value: x.abs(), slope: self.slope.union(self.slope.negated()) },
        }
    }

    /// The direction of (x, y), y being this.
    fn direction(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        let turned = self.slope.times(x.value).minus(self.value.times(x.slope));
        let square = self.value.powi(2).plus(x.value.powi(2));
        let cut = x.value.low <= 0.0 && self.value.contains(0.0);
        let slope = if cut { Interval::WHOLE } else { turned.times(square.reciprocal()) };
        Self { value, slope }
    }

    /// This where a margin is above 0, else 0.
    fn given(self, margin: Interval) -> Self {
        let zero = Self::constant(0.0);
        match margin {
            Interval { low, .. } if low > 0.0 => self,
            Interval { high, .. } if high <= 0.0 => zero,
            _ => Self { value: self.value.union(zero.value), slope: Interval::WHOLE },
        }
    }

    fn power(self, exponent: Self) -> Self {
        let Interval { low: n, high } = exponent.value;
        if n != high {
            return Self { value: Interval::WHOLE, slope: Interval::WHOLE };
        }
        let power = |n: f64| match n {
            _ if n.fract() == 0.0 && n.abs() < f64::from(i32::MAX) => self.value.powi(n as i32),
            _ => self.value.powf(n),
        };
        self.chain(power(n), power(n - 1.0).times(Interval::exactly(n)))
    }
}

/// What a condition reads.
pub(crate) type VariableBounds<'a> = &'a dyn Fn(Variable) -> Option<Enclosure>;

impl Condition {
    /// Bounds of left side less right side; none if something that it reads has none.
    pub(crate) fn enclosure(&self, parameters: &[f64], bounds: VariableBounds) -> Option<Enclosure> {
        let [left, right] = self.values(&Piece { parameters, bounds }).ok()?;
        Some(left.minus(right))
    }

    /// What of the motion it reads.
    pub(crate) fn reads(&self) -> Vec<Variable> {
        let reads = Reads::default();
        let Ok(_) = self.values(&reads);
        reads.0.into_inner()
    }
}

struct Piece<'a> {
    parameters: &'a [f64],
    bounds: VariableBounds<'a>,
}

/// Something has no bounds.
struct Unbounded;

impl Environment for Piece<'_> {
    type Value = Enclosure;
    type Error = Unbounded;

    fn number(&self, x: f64) -> Enclosure {
        Enclosure::constant(x)
    }

    fn get_value(&self, variable: Variable) -> Result<Enclosure, Unbounded> {
        match variable {
            Variable::Parameter(i) => Ok(Enclosure::constant(self.parameters[i])),
            moving => (self.bounds)(moving).ok_or(Unbounded),
        }
    }

    fn apply(&self, function: Function, x: Enclosure) -> Result<Enclosure, Unbounded> {
        Ok(x.apply(function))
    }

    fn join(&self, operator: Operator, a: Enclosure, b: Enclosure) -> Result<Enclosure, Unbounded> {
        Ok(match operator {
            Operator::Add => a.minus(b.apply(Function::Negate)),
            Operator::Subtract => a.minus(b),
            Operator::Multiply => a.times(b),
            Operator::Divide => a.times(b.reciprocal()),
            Operator::Power => a.power(b),
            Operator::Atan2 => a.direction(b),
            Operator::Where => b.given(a.value),
            Operator::Unless if a.value.contains(0.0) => b.given(Interval::WHOLE),
            Operator::Unless => b.given(a.value.negated()),
        })
    }
}

/// Takes note of what is read.
#[derive(Default)]
struct Reads(RefCell<Vec<Variable>>);

impl Environment for Reads {
    type Value = ();
    type Error = core::convert::Infallible;

    fn number(&self, _: f64) {}

    fn get_value(&self, variable: Variable) -> Result<(), Self::Error> {
        let mut reads = self.0.borrow_mut();
        if !matches!(variable, Variable::Parameter(_)) && !reads.contains(&variable) {
            reads.push(variable);
        }
        Ok(())
    }

    fn apply(&self, _: Function, (): ()) -> Result<(), Self::Error> {
        Ok(())
    }

    fn join(&self, _: Operator, (): (), (): ()) -> Result<(), Self::Error> {
        Ok(())
    }
}
