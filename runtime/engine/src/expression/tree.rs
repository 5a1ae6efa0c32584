//! Expressions with their names resolved.

/// A number that depends on the motion.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Expression {
    Number(f64),
    Parameter(usize),
    Time,
    /// A coordinate's `order`-th derivative, 0 to 2.
    Coordinate {
        index: usize,
        order: usize,
    },
    /// A point's position, velocity or acceleration along an axis.
    Point {
        index: usize,
        axis: usize,
        order: usize,
    },
    /// A contact's reaction, divided by `share`.
    Reaction {
        contact: usize,
        share: f64,
    },
    /// The friction force of a contact that has friction or is rough, divided by `share`.
    Friction {
        contact: usize,
        share: f64,
    },
    /// The slip velocity of an entry of the layout's frictions.
    Slip(usize),
    /// The coefficient of friction of such an entry.
    Coefficient(usize),
    /// An entry of the layout's quantities.
    Quantity(usize),
    Gap(usize),
    Kinetic,
    Potential,
    Energy,
    Dissipated,
    Apply(Function, Box<Expression>),
    Join(Operator, Box<Expression>, Box<Expression>),
}

/// Functions of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// |x|.
    Abs,
    /// eˣ.
    Exp,
    /// The natural logarithm.
    Log,
    /// tanh x.
    Tanh,
    /// atan x.
    Atan,
    /// x/|x|; 0 at 0.
    Sign,
}

impl Function {
    /// What is taken of several numbers.
    pub(super) const OF_SEVERAL: [&'static str; 5] = ["min", "max", "clamp", "atan2", "if"];

    /// All names of functions of numbers.
    pub(super) fn names() -> impl Iterator<Item = &'static str> {
        Self::NAMED.iter().map(|(name, _)| *name).chain(Self::OF_SEVERAL)
    }

    pub(super) const NAMED: [(&'static str, Self); 10] = [
        ("sqrt", Self::Sqrt),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("abs", Self::Abs),
        ("exp", Self::Exp),
        ("log", Self::Log),
        ("tanh", Self::Tanh),
        ("atan", Self::Atan),
        ("sign", Self::Sign),
    ];

    pub(super) fn apply(self, x: f64) -> f64 {
        match self {
            Self::Negate => -x,
            Self::Sqrt => x.sqrt(),
            Self::Sin => x.sin(),
            Self::Cos => x.cos(),
            Self::Tan => x.tan(),
            Self::Abs => x.abs(),
            Self::Exp => x.exp(),
            Self::Log => x.ln(),
            Self::Tanh => x.tanh(),
            Self::Atan => x.atan(),
            Self::Sign if x == 0.0 => x,
            Self::Sign => x.signum(),
        }
    }
}

/// Operations on two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Add,
    /// a − b.
    Subtract,
    /// a · b.
    Multiply,
    /// a / b.
    Divide,
    /// aᵇ.
    Power,
    /// The direction of (b, a), from −π to π.
    Atan2,
    /// b where a > 0, else 0.
    Where,
    /// 0 where a > 0, else b.
    Unless,
}

impl Operator {
    pub(super) fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => a.powf(b),
            Self::Atan2 => a.atan2(b),
            Self::Where => {
                if a > 0.0 {
                    b
                } else {
                    0.0
                }
            }
            Self::Unless => {
                if a > 0.0 {
                    0.0
                } else {
                    b
                }
            }
        }
    }
}

impl Expression {
    pub(super) fn apply(function: Function, argument: Self) -> Self {
        Self::Apply(function, Box::new(argument))
    }

    pub(super) fn join(operator: Operator, left: Self, right: Self) -> Self {
        Self::Join(operator, Box::new(left), Box::new(right))
    }

    /// √(vx² + vy²) of a point.
    pub(super) fn speed(point: usize) -> Self {
        Self::magnitude([0, 1].map(|axis| Self::Point { index: point, axis, order: 1 }))
    }

    /// √(x² + y²).
    pub(super) fn magnitude(vector: [Self; 2]) -> Self {
        let [x, y] = vector.map(|part| Self::join(Operator::Power, part, Self::Number(2.0)));
        Self::apply(Function::Sqrt, Self::join(Operator::Add, x, y))
    }

    /// Its derivative by time, of what is linear in coordinates and positions of points; none of
    /// anything else.
    pub(super) fn rate(&self) -> Option<Self> {
        match self {
            fixed if fixed.is_fixed() => Some(Self::Number(0.0)),
            &Self::Coordinate { index, order } => {
                (order < 2).then_some(Self::Coordinate { index, order: order + 1 })
            }
            &Self::Point { index, axis, order } => {
                (order < 2).then_some(Self::Point { index, axis, order: order + 1 })
            }
            Self::Apply(Function::Negate, x) => Some(Self::apply(Function::Negate, x.rate()?)),
            Self::Join(operator @ (Operator::Add | Operator::Subtract), a, b) => {
                Some(Self::join(*operator, a.rate()?, b.rate()?))
            }
            Self::Join(Operator::Multiply, a, b) if a.is_fixed() => {
                Some(Self::join(Operator::Multiply, (**a).clone(), b.rate()?))
            }
            _ => None,
        }
    }

    /// The least of two where `sign` is −1, the greatest where it is 1: ½ (a + b ± |a − b|).
    pub(super) fn extreme(sign: f64, a: Self, b: Self) -> Self {
        let distance = Self::apply(Function::Abs, Self::join(Operator::Subtract, a.clone(), b.clone()));
        let distance = Self::join(Operator::Multiply, Self::Number(sign), distance);
        let sum = Self::join(Operator::Add, Self::join(Operator::Add, a, b), distance);
        Self::join(Operator::Multiply, Self::Number(0.5), sum)
    }

    /// b where the margin is above 0, else c.
    pub(super) fn choice(margin: Self, b: Self, c: Self) -> Self {
        let b = Self::join(Operator::Where, margin.clone(), b);
        Self::join(Operator::Add, b, Self::join(Operator::Unless, margin, c))
    }

    /// A function in it that jumps; at its cut a direction does.
    pub(super) fn jump(&self) -> Option<&'static str> {
        match self {
            Self::Apply(Function::Sign, x) if !x.is_fixed() => Some("sign"),
            Self::Join(Operator::Where | Operator::Unless, ..) => Some("if"),
            Self::Join(Operator::Atan2, a, b) if !(a.is_fixed() && b.is_fixed()) => Some("atan2"),
            Self::Apply(_, x) => x.jump(),
            Self::Join(_, a, b) => a.jump().or_else(|| b.jump()),
            _ => None,
        }
    }

    /// Whether it depends on parameters only.
    pub(super) fn is_fixed(&self) -> bool {
        match self {
            Self::Number(_) | Self::Parameter(_) => true,
            Self::Apply(_, x) => x.is_fixed(),
            Self::Join(_, a, b) => a.is_fixed() && b.is_fixed(),
            _ => false,
        }
    }

    /// Whether it depends on what the motion was before.
    pub(super) fn reads_history(&self) -> bool {
        match self {
            Self::Dissipated => true,
            Self::Apply(_, x) => x.reads_history(),
            Self::Join(_, a, b) => a.reads_history() || b.reads_history(),
            _ => false,
        }
    }

    /// Whether it is made of sums, products, whole powers, sines and cosines of what it reads.
    pub(super) fn is_entire(&self) -> bool {
        match self {
            Self::Apply(Function::Negate | Function::Sin | Function::Cos, x) => x.is_entire(),
            Self::Apply(_, x) => x.is_fixed(),
            Self::Join(Operator::Divide, a, b) => a.is_entire() && b.is_fixed(),
            Self::Join(Operator::Power, a, n) => a.is_entire() && is_count(n) || a.is_fixed() && n.is_fixed(),
            Self::Join(Operator::Add | Operator::Subtract | Operator::Multiply, a, b) => {
                a.is_entire() && b.is_entire()
            }
            Self::Join(_, a, b) => a.is_fixed() && b.is_fixed(),
            _ => true,
        }
    }

    /// Whether it depends on this parameter.
    pub(super) fn has_parameter(&self, parameter: usize) -> bool {
        match self {
            Self::Parameter(i) => *i == parameter,
            Self::Apply(_, x) => x.has_parameter(parameter),
            Self::Join(_, a, b) => a.has_parameter(parameter) || b.has_parameter(parameter),
            _ => false,
        }
    }
}

/// A number that is a whole one above zero.
pub(super) fn is_count(n: &Expression) -> bool {
    matches!(n, Expression::Number(n) if *n > 0.0 && n.fract() == 0.0)
}
