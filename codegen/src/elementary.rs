//! Elementary functions of expressions beside sine, cosine and root.

/// A function of one number, analytic where it has a value.
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
}

impl Elementary {
    /// All.
    pub const ALL: [Self; 4] = [Self::Exp, Self::Log, Self::Tanh, Self::Atan];

    /// As declarations, conditions, C and SymPy write it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Tanh => "tanh",
            Self::Atan => "atan",
        }
    }

    /// As Rust calls it on a number.
    pub const fn method(self) -> &'static str {
        if matches!(self, Self::Log) { "ln" } else { self.name() }
    }

    /// Places on the tape of a series.
    pub const fn columns(self) -> usize {
        if matches!(self, Self::Tanh | Self::Atan) { 2 } else { 1 }
    }

    /// Its value at x.
    pub fn apply(self, x: f64) -> f64 {
        match self {
            Self::Exp => x.exp(),
            Self::Log => x.ln(),
            Self::Tanh => x.tanh(),
            Self::Atan => x.atan(),
        }
    }
}
