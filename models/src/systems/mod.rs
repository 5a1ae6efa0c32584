//! The systems of the paper, compiled. The files beside them are run as text: [`crate::models`].

mod falling_pair;
mod falling_pair_full;
mod narrow_gap;
mod zigzag;
mod zigzag_full;
mod zigzag_published;
mod zigzag_thread;

pub use falling_pair::FallingPair;
pub use falling_pair_full::FallingPairFull;
pub use narrow_gap::NarrowGap;
pub use zigzag::Zigzag;
pub use zigzag_full::ZigzagFull;
pub use zigzag_published::ZigzagPublished;
pub use zigzag_thread::ZigzagThread;
