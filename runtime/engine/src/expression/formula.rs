//! Numbers as expressions of named variables: `75*pi/180`, `1 - lambda`.

use core::fmt;

use super::parse::{Parser, check_length};
use super::resolve::Vocabulary;
use super::tree::Expression;
use crate::error::OutputError;

/// A number that depends on variables, in the language of [`Output`](super::Output): numbers,
/// `+ - * / ^`, parentheses, `sqrt sin cos tan abs exp log tanh atan sign min max clamp atan2`,
/// `if(a > b, x, y)`, `pi`, and the variables' names.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    text: String,
    expression: Expression,
}

impl Formula {
    /// Reads an expression of these variables.
    ///
    /// # Errors
    /// It is no expression, or names something else.
    pub fn parse(text: &str, variables: &[&str]) -> Result<Self, OutputError> {
        check_length(text)?;
        let mut parser = Parser::new(text, Vocabulary::Variables(variables))?;
        let expression = parser.sum()?;
        parser.end()?;
        Ok(Self { text: text.trim().to_owned(), expression })
    }

    /// Its value where the variables have these, in their order; NaN where there are too few.
    pub fn value(&self, variables: &[f64]) -> f64 {
        self.expression.constant(variables).unwrap_or(f64::NAN)
    }

    /// Whether it depends on the variable of this index.
    pub fn depends_on(&self, variable: usize) -> bool {
        self.expression.has_parameter(variable)
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn formulas_are_numbers_and_expressions_of_variables() {
        let value = |text: &str| Formula::parse(text, &["lambda", "x"]).map(|f| f.value(&[0.25, 2.0]));
        assert_eq!(value("1 - lambda"), Ok(0.75));
        assert_eq!(value("75*pi/180"), Ok(75.0 * PI / 180.0));
        assert_eq!(value("-x^2 * sqrt(2)/2"), Ok(-(4.0 * 2f64.sqrt()) / 2.0));
    }

    #[test]
    fn other_names_are_reported_with_the_nearest() {
        let error = |text: &str| Formula::parse(text, &["lambda"]).expect_err("no variable").to_string();
        assert_eq!(error("1 - lamda"), "no name `lamda`; did you mean `lambda`?");
        assert_eq!(error("lambda'"), "no name `lambda'`; did you mean `lambda`?");
        assert_eq!(
            error("N(A)"),
            "no function `N`; known: sqrt, sin, cos, tan, abs, exp, log, tanh, atan, sign, min, max, …"
        );
    }

    #[test]
    fn a_formula_knows_what_it_depends_on() {
        let formula = Formula::parse("2*y - sin(x)", &["x", "y", "z"]).expect("a formula");
        assert_eq!([0, 1, 2].map(|i| formula.depends_on(i)), [true, true, false]);
    }
}
