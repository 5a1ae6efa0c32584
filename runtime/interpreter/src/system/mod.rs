//! The full equations and the phases of an interpreted model.

mod evaluator;
mod full;
mod jacobian;
mod kernel;
mod phase;

pub(crate) use evaluator::Evaluator;
pub(crate) use full::FullCode;
pub(crate) use kernel::Kernel;
pub(crate) use phase::PhaseCode;
