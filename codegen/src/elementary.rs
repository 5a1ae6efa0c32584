//! Elementary functions of expressions beside sine, cosine and root.

use crate::spline::Table;

/// A function of one number, analytic where it has a value, but for the kinks of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elementary {
    /// eˣ.
    Exp,
    /// The natural logarithm of x > 0.
    Log,
    /// tanh x.
    Tanh,
    /// The angle between −π/2 and π/2 whose tangent is x.
    Atan,
    /// The value of a table at x.
    Table(Table),
}

impl Elementary {
    /// All that have a name.
    pub const ALL: [Self; 4] = [Self::Exp, Self::Log, Self::Tanh, Self::Atan];

    /// As declarations, conditions, C and SymPy write it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Tanh => "tanh",
            Self::Atan => "atan",
            Self::Table(_) => "table",
        }
    }

    /// As Rust calls it on a number.
    pub const fn method(self) -> &'static str {
        match self {
            Self::Log => "ln",
            Self::Table(_) => "spline",
            _ => self.name(),
        }
    }

    /// Places on the tape of a series.
    pub const fn columns(self) -> usize {
        match self {
            Self::Exp | Self::Log => 1,
            Self::Tanh | Self::Atan => 2,
            Self::Table(_) => 3,
        }
    }

    /// Its value at x.
    pub fn apply(self, x: f64) -> f64 {
        match self {
            Self::Exp => x.exp(),
            Self::Log => x.ln(),
            Self::Tanh => x.tanh(),
            Self::Atan => x.atan(),
            Self::Table(table) => table.evaluate(x),
        }
    }
}
