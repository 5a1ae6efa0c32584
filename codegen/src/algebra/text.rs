//! Series and quotients in textbook notation, common factors in front: `½ m l² (4 φ̇² − 3 cos φ)`.

mod names;
mod products;
mod shorter;
mod sums;

pub use names::{SymbolNames, lettered, printed};
pub use products::lead;
pub use shorter::Shorthand;
pub use sums::rank;
