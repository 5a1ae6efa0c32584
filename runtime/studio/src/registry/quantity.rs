//! Numbers as expressions of named variables, with a unit behind them: `75*pi/180`, `2.5 mm`,
//! `lambda deg`.

use core::fmt;
use liftoff::__private::expression::Formula;
use liftoff::__private::expression::si_unit::SiUnit;
use liftoff::OutputError;
use liftoff_codegen::units::{self, Unit};
use thiserror::Error;

/// A number that depends on variables; with a unit behind it, it is in SI units and radians.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    text: String,
    formula: Formula,
    unit: Option<Unit>,
}

/// Text that is no number with a unit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum QuantityError {
    /// An unknown unit.
    #[error("{0}")]
    Unit(String),
    /// What stands before it is no formula of the variables.
    #[error(transparent)]
    Formula(#[from] OutputError),
}

impl Quantity {
    /// Reads an expression of these variables and the unit behind it.
    ///
    /// # Errors
    /// It is no expression, names something else, or its unit is unknown.
    pub fn parse(text: &str, variables: &[&str]) -> Result<Self, QuantityError> {
        let (number, unit) = units::split(text).map_err(QuantityError::Unit)?;
        let formula = Formula::parse(number, variables)?;
        Ok(Self { text: text.trim().to_owned(), formula, unit })
    }

    /// A number as an expression of numbers and `pi`, and the unit behind it.
    ///
    /// # Errors
    /// It is none; the first of it is told with why.
    pub fn parse_number(text: &str) -> Result<Self, String> {
        let told: String = text.chars().take(60).collect();
        Self::parse(text, &[]).map_err(|error| format!("`{told}` is no number: {error}"))
    }

    /// Its value where the variables have these, in their order; NaN where there are too few.
    pub fn value(&self, variables: &[f64]) -> f64 {
        let value = self.formula.value(variables);
        self.unit.as_ref().map_or(value, |unit| unit.convert(value))
    }

    /// The coherent unit of its value, if a unit stands behind it.
    pub fn unit(&self) -> Option<SiUnit> {
        let [metre, second, kilogram, radian] = self.unit.as_ref()?.powers();
        Some(SiUnit::new(kilogram, metre, second, radian))
    }

    /// Whether it depends on the variable of this index.
    pub fn depends_on(&self, variable: usize) -> bool {
        self.formula.depends_on(variable)
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_behind_formulas() {
        let value = |text: &str| Quantity::parse(text, &["lambda"]).map(|given| given.value(&[0.25]));
        assert_eq!(value("10*lambda mm"), Ok(2.5e-3));
        assert_eq!(value("75*pi/180"), Ok(75.0 * core::f64::consts::PI / 180.0));
        let error = |text: &str| value(text).expect_err("no quantity").to_string();
        assert_eq!(error("3 mmm"), "no unit `mmm`; did you mean `mm`?");
        assert_eq!(error("1 - lamda"), "no name `lamda`; did you mean `lambda`?");
        let long = "1".repeat(20_000) + " m";
        assert!(matches!(value(&long), Err(QuantityError::Formula(OutputError::Length { .. }))));
    }
}
