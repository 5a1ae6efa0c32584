//! Bar systems declared with liftoff, one file each with its figure, and what the `liftoff` command does with them.

pub mod catalog;
pub mod cli;
pub mod plot;
pub mod report;
pub mod scene;

mod a_frame;
mod double_pendulum;
mod falling_pair;
mod falling_pair_full;
mod ladder;
mod pendulum;
mod rod_on_floor;
mod zigzag;
mod zigzag_full;
mod zigzag_published;

pub use a_frame::AFrame;
pub use double_pendulum::DoublePendulum;
pub use falling_pair::FallingPair;
pub use falling_pair_full::FallingPairFull;
pub use ladder::Ladder;
pub use pendulum::Pendulum;
pub use rod_on_floor::RodOnFloor;
pub use zigzag::Zigzag;
pub use zigzag_full::ZigzagFull;
pub use zigzag_published::ZigzagPublished;
