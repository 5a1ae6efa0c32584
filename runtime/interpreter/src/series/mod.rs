//! The Taylor series of a closed form: one order after the other of everything that varies along a motion.

mod code;
mod expansion;
mod lowering;

#[cfg(feature = "jit")]
pub(crate) use code::Operation;
pub(crate) use code::SeriesCode;
pub(crate) use expansion::Expansion;
