//! What is said of conditions and integrals: words and formulas in lines, whatever prints them.

mod sections;

use core::fmt;

use liftoff_codegen::math::{Equation, Math};

/// A part of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// Words.
    Words(String),
    /// A formula.
    Formula(Math),
    /// An equation.
    Equation(Equation),
}

/// A line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement(pub Vec<Piece>);

/// What is said of a contact set.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// Its heading.
    pub title: String,
    /// Line by line.
    pub statements: Vec<Statement>,
}

impl Statement {
    fn equation(equation: &Equation) -> Self {
        Self(vec![Piece::Equation(equation.clone())])
    }

    fn and(mut self, text: &str) -> Self {
        self.0.push(Piece::Words(text.to_owned()));
        self
    }

    fn then(mut self, equation: &Equation) -> Self {
        self.0.push(Piece::Equation(equation.clone()));
        self
    }

    fn formula(mut self, formula: &Math) -> Self {
        self.0.push(Piece::Formula(formula.clone()));
        self
    }

    /// Equations of which one holds.
    fn one_of(mut self, equations: &[Equation]) -> Self {
        for (i, equation) in equations.iter().enumerate() {
            if i > 0 {
                self = self.and("or");
            }
            self = self.then(equation);
        }
        self
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title)?;
        self.statements.iter().try_for_each(|statement| writeln!(f, "  {statement}"))
    }
}

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, piece) in self.0.iter().enumerate() {
            let gap = if i > 0 { " " } else { "" };
            match piece {
                Piece::Words(words) => write!(f, "{gap}{words}")?,
                Piece::Formula(math) => write!(f, "{gap}{math}")?,
                Piece::Equation(equation) => write!(f, "{gap}{equation}")?,
            }
        }
        Ok(())
    }
}
