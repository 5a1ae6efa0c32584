//! Instructions compiled for this processor, by Cranelift. The operations are those of the
//! interpreter in the same order, with fused products where the interpreter has them, so that their
//! bits are the same.
//!
//! - `writer`: arithmetic on registers; `straight`: code; `series`: one order of a series.
//! - `lazy`: what is run often enough to be compiled; `function`: what can be called, and why that
//!   is safe.

mod function;
mod lazy;
mod series;
mod straight;
#[cfg(test)]
mod tests;
mod writer;

pub(crate) use function::{Order, Straight};
pub(crate) use lazy::Lazy;
