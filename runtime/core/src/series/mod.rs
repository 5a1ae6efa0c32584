//! Taylor series along a motion, order by order: what the emitted code of a phase calls.
//!
//! An order computes coefficient n of everything from coefficient n of the state. Operations that
//! are linear are plain arithmetic; each of the others has a column of a [`Tape`], where it leaves
//! its operands for the orders above. The convolutions of all columns are summed together, column
//! beside column; of many motions ([`Columns`]), motion beside motion.

mod columns;
mod convolution;
#[cfg(feature = "std")]
mod growing;
mod ops;
mod tape;
#[cfg(test)]
mod tests;

pub use columns::Columns;
#[cfg(feature = "std")]
pub use growing::{Row, TapeOf};
pub use ops::SeriesOps;
pub use tape::{Tape, TaylorTape};

/// How many orders a tape has room for.
pub const ORDERS: usize = 32;

/// Columns of one block of a tape.
pub const LANES: usize = 8;
