//! How many sets of contacts one decision may try, and why a problem has no solution.

use std::cell::Cell;

/// Why there is no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LcpError {
    Jammed,
    Singular,
    NotFinite,
    /// Too many sets would have to be tried.
    Exhausted,
}

/// Sets of contacts that are left to be tried in one decision.
#[derive(Debug)]
pub(crate) struct Trials(Cell<usize>);

impl Trials {
    pub(crate) fn up_to(most: usize) -> Self {
        Self(Cell::new(most))
    }

    /// Whether the last one has not been taken.
    pub(super) fn any_left(&self) -> Result<(), LcpError> {
        if self.0.get() > 0 { Ok(()) } else { Err(LcpError::Exhausted) }
    }

    /// How many are left.
    pub(super) fn left(&self) -> usize {
        self.0.get()
    }

    /// Takes one.
    pub(super) fn take(&self) -> Result<(), LcpError> {
        let left = self.0.get().checked_sub(1).ok_or(LcpError::Exhausted)?;
        self.0.set(left);
        Ok(())
    }
}
