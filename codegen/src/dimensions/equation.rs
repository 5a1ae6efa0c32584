//! What an expression demands of dimensions, and where.

use std::fmt;

use syn::{Expr, Ident};

use super::Dimension;
use super::affine::AffineDimension;

/// zero = 0.
#[derive(Clone, Debug)]
pub(super) struct DimensionEquation<'d> {
    /// What vanishes.
    pub zero: AffineDimension,
    /// Whether it may fail without a mistake: by a number with a dimension of its own.
    pub numeric: bool,
    /// The expression that contradicts if it does not hold.
    pub at: &'d Expr,
    /// Why it holds.
    pub reason: Reason,
    /// Where that stands.
    pub place: Place<'d>,
}

/// Why an equation holds.
#[derive(Clone, Debug)]
pub(super) enum Reason {
    /// The expression stands for something of this dimension.
    Needed(Dimension),
    /// It is added to something of this dimension.
    Added(AffineDimension),
}

/// Where an expression stands: the mass of `AB`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'d> {
    /// What the expression is.
    pub what: &'static str,
    /// Whose it is.
    pub owner: Option<&'d Ident>,
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.owner {
            Some(owner) => write!(f, "{} `{owner}`", self.what),
            None => f.write_str(self.what),
        }
    }
}
