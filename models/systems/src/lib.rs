//! Bar systems declared with liftoff, one file each. Four of the paper are compiled, the other
//! files are run as text. The default run of each is in `default_run`.

mod default_run;
mod falling_pair;
mod registry;
mod zigzag;
mod zigzag_full;
mod zigzag_published;

pub use falling_pair::FallingPair;
pub use registry::{models, with_default_runs};
pub use zigzag::Zigzag;
pub use zigzag_full::ZigzagFull;
pub use zigzag_published::ZigzagPublished;
