//! Contacts that open because their reaction reaches zero: how their gaps begin is known, g = ġ = g̈ = 0 < g⃛.

use super::Driver;
use crate::model::ContactSet;

/// Order of the first derivative of the gap that does not vanish where the reaction is zero.
const ORDER: usize = 3;

impl Driver<'_> {
    /// Gaps of contacts that have just opened so, each with the order of its first nonzero derivative.
    pub(super) fn liftoff_orders(&mut self) -> Vec<(usize, usize)> {
        core::mem::replace(&mut self.lifted, ContactSet::EMPTY).iter().map(|i| (i, ORDER)).collect()
    }
}
