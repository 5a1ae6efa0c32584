//! Formulas as they are written, whatever prints them: what stands over what, which brackets are
//! there, which number is raised. [`Series`](crate::algebra::Series) and what the equations are
//! made of become this; text, LaTeX and MathML are three ways to print it.

mod latex;
mod line_breaks;
mod mathml;
mod name;
mod normalise;
mod numbers;
#[cfg(test)]
mod tests;
mod text;

pub use name::Name;
pub(crate) use name::spelled;
pub(crate) use numbers::is_long;

/// A formula as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Math {
    /// A number ≥ 0.
    Number {
        /// Its numerator.
        numerator: u128,
        /// Its denominator.
        denominator: u128,
    },
    /// A letter or word, with so many dots: φ̈.
    Symbol(Name, u8),
    /// What belongs to something that has a name: N(A, E), gap(P).
    Of(&'static str, String),
    /// An entry of a matrix: M[y, φ].
    Entry(&'static str, Vec<Math>),
    /// Words.
    Words(String),
    /// Minus what follows.
    Minus(Box<Math>),
    /// Terms; a [`Minus`](Self::Minus) is subtracted.
    Sum(Vec<Math>),
    /// Factors one after the other.
    Product(Vec<Math>),
    /// A number right before a symbol: 2φ, ½π.
    Multiple(Box<Math>, Box<Math>),
    /// Raised to a power.
    Power(Box<Math>, i32),
    /// One over the other; in text the stroke has space around it where it divides all that stands
    /// before it.
    Fraction {
        /// Numerator and denominator.
        parts: Box<[Math; 2]>,
        /// Whether there is space around the stroke.
        wide: bool,
    },
    /// A function of an argument, itself raised to a power: cos² φ.
    Apply {
        /// `sin`, `cos`, `tan`.
        function: &'static str,
        /// The power.
        power: u32,
        /// What it is applied to.
        argument: Box<Math>,
    },
    /// A square root.
    Root(Box<Math>),
    /// In brackets.
    Group(Box<Math>),
}

impl Math {
    /// 0.
    pub const ZERO: Self = Self::integer(0);
    /// 1.
    pub const ONE: Self = Self::integer(1);

    /// A number.
    pub const fn integer(n: u128) -> Self {
        Self::Number { numerator: n, denominator: 1 }
    }

    /// A symbol by its name as it is declared: `phi_inner`, `m1`.
    pub fn symbol(name: &str) -> Self {
        Self::Symbol(Name::new(name), 0)
    }

    /// What belongs to something named.
    pub fn named(what: &'static str, name: &str) -> Self {
        Self::Of(what, name.to_owned())
    }

    /// Its opposite.
    pub fn minus(self) -> Self {
        match self {
            Self::Minus(inner) => *inner,
            sum @ Self::Sum(_) => Self::Minus(Box::new(sum.group())),
            other => Self::Minus(Box::new(other)),
        }
    }

    /// Itself, or its opposite.
    pub fn signed(self, negative: bool) -> Self {
        if negative { self.minus() } else { self }
    }

    /// A sum; of none it is 0.
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let mut terms: Vec<Self> = terms.into_iter().collect();
        match terms.len() {
            0 => Self::ZERO,
            1 => terms.remove(0),
            _ => Self::Sum(terms),
        }
    }

    /// A product, the sign of its first factor in front; of none it is 1. A first factor 1 is left
    /// out, sums are put in brackets.
    pub fn product(factors: impl IntoIterator<Item = Self>) -> Self {
        let mut all = Vec::new();
        let mut negative = false;
        for factor in factors {
            match factor {
                Self::Minus(inner) if all.is_empty() => {
                    negative = !negative;
                    all.extend(inner.factors());
                }
                other => all.extend(other.factors()),
            }
        }
        if all.len() > 1 && all[0] == Self::ONE {
            all.remove(0);
        }
        let product = match all.len() {
            0 => Self::ONE,
            1 => all.remove(0),
            _ => Self::Product(all.into_iter().map(Self::factor).collect()),
        };
        product.signed(negative)
    }

    fn factors(self) -> Vec<Self> {
        if let Self::Product(factors) = self { factors } else { vec![self] }
    }

    /// What may stand beside other factors: sums and what has a sign in brackets.
    fn factor(self) -> Self {
        if matches!(self, Self::Sum(_) | Self::Minus(_)) { self.group() } else { self }
    }

    /// What may stand below a stroke: one factor.
    fn divisor(self) -> Self {
        match self {
            Self::Product(_) | Self::Fraction { .. } | Self::Multiple(..) => self.group(),
            other => other.factor(),
        }
    }

    /// One over the other, the sign in front; a sum above, and all but one factor below, is put in
    /// brackets.
    pub fn over(self, below: Self) -> Self {
        self.divided(below, false)
    }

    /// The same, all that stands before the stroke.
    pub fn all_over(self, below: Self) -> Self {
        self.divided(below, true)
    }

    fn divided(self, below: Self, wide: bool) -> Self {
        match self {
            Self::Minus(above) => above.divided(below, wide).minus(),
            above => Self::Fraction { parts: Box::new([above.factor(), below.divisor()]), wide },
        }
    }

    /// Raised; all but single symbols and what has brackets is put in brackets.
    pub fn power(self, exponent: i32) -> Self {
        match self {
            base if exponent == 1 => base,
            base @ (Self::Symbol(..)
            | Self::Group(_)
            | Self::Root(_)
            | Self::Number { denominator: 1, .. }) => Self::Power(Box::new(base), exponent),
            base => Self::Power(Box::new(base.group()), exponent),
        }
    }

    /// In brackets.
    pub fn group(self) -> Self {
        match self {
            Self::Group(_) => self,
            other => Self::Group(Box::new(other)),
        }
    }

    /// Whether a sign stands between two of its terms, in brackets or not.
    pub fn contains_sum(&self) -> bool {
        match self {
            Self::Sum(_) => true,
            Self::Number { .. } | Self::Symbol(..) | Self::Of(..) | Self::Words(_) => false,
            Self::Entry(_, parts) | Self::Product(parts) => parts.iter().any(Self::contains_sum),
            Self::Fraction { parts, .. } => parts.iter().any(Self::contains_sum),
            Self::Minus(inner) | Self::Power(inner, _) | Self::Root(inner) | Self::Group(inner) => {
                inner.contains_sum()
            }
            Self::Multiple(_, inner) | Self::Apply { argument: inner, .. } => inner.contains_sum(),
        }
    }
}

/// `left = right`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// What is given.
    pub left: Math,
    /// What it equals.
    pub right: Math,
}

impl Equation {
    /// `left = right`.
    pub fn new(left: Math, right: Math) -> Self {
        Self { left, right }
    }
}
