//! Pictures of a model and of its motion, as SVG.

mod charts;
mod drawing;
#[cfg(test)]
mod examples;
mod portrait;
mod pose;
mod quantities;
mod sample;
mod superposition;

pub use charts::{ChartCurve, ChartNumbers, Charts};
pub use drawing::drawing;
pub use portrait::Portrait;
pub use pose::clearest_pose;
pub(crate) use quantities::{energies, shown};
pub use sample::curve;
pub use superposition::Positions;
