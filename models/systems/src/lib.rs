//! Bar systems declared with liftoff, one file each. The paper's are compiled; the other files are run as text. The default
//! run of each is in `default_run`.

mod default_run;
mod falling_pair;
mod falling_pair_full;
mod narrow_gap;
mod registry;
mod zigzag;
mod zigzag_full;
mod zigzag_published;
mod zigzag_thread;

pub use falling_pair::FallingPair;
pub use falling_pair_full::FallingPairFull;
pub use narrow_gap::NarrowGap;
pub use registry::{models, with_default_run};
pub use zigzag::Zigzag;
pub use zigzag_full::ZigzagFull;
pub use zigzag_published::ZigzagPublished;
pub use zigzag_thread::ZigzagThread;
