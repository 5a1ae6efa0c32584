//! Pictures of a model and of its motion, as SVG.

mod anatomy;
mod charts;
mod drawing;
mod error;
#[cfg(test)]
mod examples;
mod pattern;
mod portrait;
mod pose;
mod quantities;
mod sample;

pub use charts::Charts;
pub use drawing::drawing;
pub use error::PictureError;
pub use pattern::Positions;
pub use portrait::Portrait;
pub use pose::telling;
pub use sample::curve;
