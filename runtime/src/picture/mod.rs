//! Pictures of a model and of its motion.

mod anatomy;
mod drawing;
mod pose;

pub use drawing::drawing;
pub use pose::telling;
