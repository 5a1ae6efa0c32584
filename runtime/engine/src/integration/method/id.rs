//! Methods of integration by name.

use super::{Auto, Dop853, Gauss, Method, Problem, Radau, StartedStepper, Taylor, Tsit5};
use crate::error::NameError;
use core::str::FromStr;

/// A method of integration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum MethodId {
    /// Chosen for each phase: [`Auto`].
    Auto,
    /// Explicit Runge–Kutta of order 5: [`Tsit5`].
    Tsit5,
    /// Explicit Runge–Kutta of order 8: [`Dop853`].
    Dop853,
    /// Taylor series of variable order: [`Taylor`].
    Taylor,
    /// Radau IIA of order 5: [`Radau`].
    Radau,
    /// Gauss collocation of order 12: [`Gauss`].
    Gauss,
}

impl MethodId {
    /// All methods.
    pub const ALL: [Self; 6] =
        [Self::Auto, Self::Tsit5, Self::Dop853, Self::Taylor, Self::Radau, Self::Gauss];

    /// Its name.
    pub fn name(self) -> &'static str {
        self.method().name()
    }

    fn method(self) -> &'static dyn Method {
        match self {
            Self::Auto => &Auto,
            Self::Tsit5 => &Tsit5,
            Self::Dop853 => &Dop853,
            Self::Taylor => &Taylor,
            Self::Radau => &Radau,
            Self::Gauss => &Gauss,
        }
    }
}

impl Method for MethodId {
    fn name(&self) -> &'static str {
        self.method().name()
    }

    fn takes_series(&self) -> bool {
        self.method().takes_series()
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        self.method().begin(problem)
    }
}

impl FromStr for MethodId {
    type Err = NameError;

    fn from_str(name: &str) -> Result<Self, NameError> {
        let known = Self::ALL.map(Self::name);
        Self::ALL
            .into_iter()
            .find(|method| method.name() == name)
            .ok_or_else(|| NameError::new("method", name, known))
    }
}
