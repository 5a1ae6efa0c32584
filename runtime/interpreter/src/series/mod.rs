//! The Taylor series of closed forms and of the full equations: one order after the other of
//! everything that varies along a motion.

mod code;
mod expansion;
mod lowering;
mod orders;

pub(crate) use code::SeriesCode;
#[cfg(feature = "jit")]
pub(crate) use code::SeriesOperation;
pub(crate) use expansion::expansion;
pub(crate) use orders::{KernelCode, Orders};
