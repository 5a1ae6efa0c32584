//! The Taylor series of a closed form: one order after the other of everything that varies along a motion.

mod code;
mod expansion;
mod lowering;

pub(crate) use code::SeriesCode;
pub(crate) use expansion::Expansion;
