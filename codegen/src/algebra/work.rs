//! A budget of term operations, so that no declaration takes time or memory without bound. Past it
//! every series that is computed is overflow, so that whatever is under way comes to its end at
//! once.

use std::cell::Cell;

thread_local! {
    static LEFT: Cell<u64> = const { Cell::new(u64::MAX) };
}

/// Restores the budget of whoever is around.
struct Outer(u64);

impl Drop for Outer {
    fn drop(&mut self) {
        LEFT.set(self.0);
    }
}

/// Runs `f` with a budget of term operations of its own; what it spends is not that of whoever is
/// around.
pub fn limited<T>(operations: u64, f: impl FnOnce() -> T) -> T {
    let _outer = Outer(LEFT.replace(operations));
    f()
}

/// Whether the budget is spent.
pub fn is_spent() -> bool {
    LEFT.get() == 0
}

/// How many operations are left.
pub fn left() -> u64 {
    LEFT.get()
}

/// Takes so many operations from the budget; false where it is spent.
pub fn spend(operations: usize) -> bool {
    let left = LEFT.get().saturating_sub(operations as u64);
    LEFT.set(left);
    left > 0
}
