//! Texts that are no expressions of a model.

use thiserror::Error;

use super::NameError;

/// Characters of an expression.
pub(crate) const LONGEST: usize = 10_000;
/// Operators of an expression, which bound how deep its tree is.
pub(crate) const MOST_OPERATORS: usize = 1000;

/// Text that is no expression of the model.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum OutputError {
    /// A character or word in the wrong place.
    #[error("expected {expected}, found {found} at column {column}")]
    Unexpected {
        /// What could have stood there.
        expected: &'static str,
        /// What does.
        found: String,
        /// Where, counted from 1.
        column: usize,
    },
    /// An unknown name.
    #[error(transparent)]
    Name(#[from] NameError),
    /// What books call a centre of mass, which no point of the model is called.
    #[error(
        "no name `{name}`: write `x(A)` for the x of point A; a centre of mass is a point if the declaration says so, `#[point(G = AB, at = l / 2)]`"
    )]
    Centre {
        /// What was asked for.
        name: String,
    },
    /// An equation joined with another condition: it holds at moments, not between them.
    #[error("`{condition}`: `and` joins `<` and `>`, not equations; `a > b` is met where a rises through b")]
    Combined {
        /// The condition.
        condition: String,
    },
    /// Too many comparisons in one condition.
    #[error("`and` and `or` join {most} comparisons at most")]
    Clauses {
        /// The limit.
        most: usize,
    },
    /// The share of one support is not determined.
    #[error("only the total reaction of {contact} is determined: write N({contact})")]
    NotShared {
        /// The contact's label.
        contact: String,
    },
    /// Several names where a function takes one.
    #[error("{function} takes one {argument}: write {function}({first})")]
    Several {
        /// The function.
        function: String,
        /// What it takes, a point or a support.
        argument: &'static str,
        /// The first of the names given.
        first: String,
    },
    /// Supports that do not make up one contact.
    #[error("{supports} are not a single contact")]
    NoContact {
        /// The supports given.
        supports: String,
    },
    /// A friction force or a slip velocity is asked of a smooth contact.
    #[error(
        "{contact} is smooth, with neither a friction force nor a slip velocity: declare it with `friction = mu`, or `rough`"
    )]
    Smooth {
        /// The contact's label.
        contact: String,
    },
    /// A slip velocity is asked of a contact that does not slip.
    #[error("{contact} is rough and does not slip: declare it with `friction = mu` in place of `rough`")]
    Rough {
        /// The contact's label.
        contact: String,
    },
    /// A condition on nothing that moves: it holds always or never, and cannot become true.
    #[error("`{condition}` holds always or never: it cannot end a run")]
    Constant {
        /// The condition.
        condition: String,
    },
    /// A condition on what only a recorded motion has.
    #[error(
        "`{condition}` depends on the dissipated energy `D`, which only a finished motion has: it cannot end a run"
    )]
    History {
        /// The condition.
        condition: String,
    },
    /// A condition on what jumps: no method sees where.
    #[error(
        "`{condition}`: `{function}` jumps, in outputs and loads; compare what it depends on, with `and` and `or`"
    )]
    Jump {
        /// The condition.
        condition: String,
        /// What jumps.
        function: &'static str,
    },
    /// More text than any expression has.
    #[error("an expression of {characters} characters: at most {LONGEST} are allowed")]
    Length {
        /// Length of the text.
        characters: usize,
    },
    /// More operators than any expression has.
    #[error("more than {MOST_OPERATORS} operators, at column {column}")]
    Operators {
        /// Where the first of those is that are too many, counted from 1.
        column: usize,
    },
    /// Parentheses or signs nested too deeply.
    #[error("nested too deeply at column {column}")]
    Depth {
        /// Where, counted from 1.
        column: usize,
    },
}
