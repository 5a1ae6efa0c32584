//! What acts beside gravity, and where internal forces are asked for.

use crate::elementary::Elementary;
use proc_macro2::Span;

use crate::algebra::Series;

/// A condition that springs and loads act on, or that their values are chosen by.
#[derive(Clone, Debug)]
pub struct Switch {
    /// What it switches: `spring AB, force P`.
    pub label: String,
    /// As conditions of runs are written.
    pub condition: String,
}

/// A spring, a damper or both between two points.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Its name.
    pub name: String,
    /// Its ends.
    pub ends: [usize; 2],
    /// Stiffness, force per length; like the length and the damping an expression of time.
    pub stiffness: Option<Formula>,
    /// Natural length.
    pub length: Formula,
    /// Damping, force per speed.
    pub damping: Option<Formula>,
    /// The switch that it acts by.
    pub switch: Option<usize>,
    /// Where it is declared.
    pub span: Span,
}

/// A torsion spring, a damper or both: torque −k (Δ − a) − c Δ̇ on `body`, Δ = direction(body) −
/// direction(from).
#[derive(Clone, Debug)]
pub struct Torsion {
    /// Its name, `AB` or `AB, CD`.
    pub name: String,
    /// The body.
    pub body: usize,
    /// What its direction is measured from, and what bears the opposite torque; the ground if
    /// absent.
    pub from: Option<usize>,
    /// Stiffness, torque per rad; like the angle and the damping an expression of time.
    pub stiffness: Option<Formula>,
    /// a: the angle without torque.
    pub angle: Formula,
    /// Damping, torque per rad per time.
    pub damping: Option<Formula>,
    /// The switch that it acts by.
    pub switch: Option<usize>,
    /// Where it is declared.
    pub span: Span,
}

/// An applied force or couple.
#[derive(Clone, Debug)]
pub struct Load {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: LoadKind,
    /// The switch that it acts by.
    pub switch: Option<usize>,
    /// Where it is declared.
    pub span: Span,
}

/// Kinds of [`Load`].
#[derive(Clone, Debug)]
pub enum LoadKind {
    /// A force at a point.
    Force {
        /// The point.
        point: usize,
        /// The body along and across which its components are; the ground if absent.
        frame: Option<usize>,
        /// Its components.
        value: [Formula; 2],
    },
    /// A couple on a body, counter-clockwise.
    Couple {
        /// The body.
        body: usize,
        /// The body that bears the opposite.
        from: Option<usize>,
        /// Its value.
        value: Formula,
    },
}

impl LoadKind {
    /// Its components, or its value.
    pub fn values(&self) -> &[Formula] {
        match self {
            Self::Force { value, .. } => value,
            Self::Couple { value, .. } => core::slice::from_ref(value),
        }
    }
}

/// A section of a uniform bar.
#[derive(Clone, Debug)]
pub struct Section {
    /// Its name.
    pub name: String,
    /// The bar.
    pub body: usize,
    /// Its distance from the bar's first point.
    pub at: Series,
    /// Where it is declared.
    pub span: Span,
}

/// An expression of time and motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// What parameters determine.
    Constant(Series),
    /// t.
    Time,
    /// The slip velocity v of a contact, in its friction.
    Slip,
    /// 1 while the condition of a switch holds, else 0.
    Switch(usize),
    /// A coordinate or position, or its rate.
    Motion {
        /// What is read.
        reading: Reading,
        /// Whether its rate is meant.
        rate: bool,
    },
    /// A function of an expression.
    Apply(Function, Box<Formula>),
    /// Two expressions joined.
    Join(Operator, Box<Formula>, Box<Formula>),
}

impl Formula {
    /// What it is, if parameters determine it.
    pub fn as_series(&self) -> Option<&Series> {
        if let Self::Constant(series) = self { Some(series) } else { None }
    }

    /// Whether it or a part of it is such.
    fn any(&self, is: &dyn Fn(&Self) -> bool) -> bool {
        is(self)
            || match self {
                Self::Apply(_, argument) => argument.any(is),
                Self::Join(_, left, right) => left.any(is) || right.any(is),
                Self::Constant(_) | Self::Time | Self::Motion { .. } | Self::Slip | Self::Switch(_) => false,
            }
    }

    /// Whether it has a table.
    pub fn has_table(&self) -> bool {
        self.any(&|part| matches!(part, Self::Apply(Function::Elementary(Elementary::Table(_)), _)))
    }

    /// Whether it jumps where a condition begins or ceases to hold.
    pub(super) fn jumps(&self) -> bool {
        self.any(&|part| matches!(part, Self::Switch(_)))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.as_series().is_some_and(Series::is_zero)
    }

    /// Its opposite.
    pub(super) fn negated(self) -> Self {
        Self::Apply(Function::Negate, Box::new(self))
    }

    /// Whether a coordinate, a position or a rate occurs.
    pub(super) fn reads_motion(&self) -> bool {
        self.any(&|part| matches!(part, Self::Motion { .. } | Self::Slip | Self::Switch(_)))
    }
}

/// What an expression reads off the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// A declared coordinate, by its index.
    Coordinate(usize),
    /// The direction of a body, counter-clockwise from the right.
    Direction(usize),
    /// The position of a point along an axis, 0 for x, 1 for y.
    Position(usize, usize),
}

/// Functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// −x.
    Negate,
    /// √x.
    Sqrt,
    /// sin x.
    Sin,
    /// cos x.
    Cos,
    /// tan x.
    Tan,
    /// xⁿ.
    Power(i32),
    /// eˣ, log x, tanh x, atan x.
    Elementary(Elementary),
}

/// Operations on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Add,
    /// a − b.
    Subtract,
    /// a · b.
    Multiply,
    /// a / b.
    Divide,
}
