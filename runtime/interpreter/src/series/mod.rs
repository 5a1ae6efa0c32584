//! The Taylor series of closed forms and of the full equations: one order after the other of everything that varies along a
//! motion.

mod code;
mod expansion;
mod lowering;
mod orders;

#[cfg(feature = "jit")]
pub(crate) use code::Operation;
pub(crate) use code::SeriesCode;
pub(crate) use expansion::expansion;
pub(crate) use orders::{KernelCode, Orders};
