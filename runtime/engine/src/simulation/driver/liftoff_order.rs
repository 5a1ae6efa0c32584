//! Contacts that open because their reaction reaches zero: how their gaps begin is known, g = ġ = g̈ = 0 < g⃛.

use super::Driver;
use crate::model::ContactSet;

/// Derivatives of the gap that vanish with a reaction at zero are those below this one.
const ORDER: usize = 3;

impl Driver<'_> {
    /// Gaps of contacts that have just opened so, with the order of their first derivative that is not zero.
    pub(super) fn liftoff_orders(&mut self) -> Vec<(usize, usize)> {
        core::mem::replace(&mut self.lifted, ContactSet::EMPTY).iter().map(|i| (i, ORDER)).collect()
    }
}
