//! Legends on a strip above the axes, never over data: of lines and of coloured squares.

pub(super) mod lines;
pub(super) mod squares;

pub use lines::LegendLine;
pub use squares::LegendSquare;
