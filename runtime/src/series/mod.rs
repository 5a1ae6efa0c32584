//! Taylor series of a phase, order by order: what emitted code calls.

mod order;
mod tape;

pub use order::{Coefficients, Order, Values};
pub use tape::Tape;

/// Orders that a tape has room for.
pub const ORDERS: usize = 32;

/// Columns of one block of a tape.
pub const LANES: usize = 8;
