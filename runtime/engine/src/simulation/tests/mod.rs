//! What simulations do, on small scenes.

pub(crate) mod given;
mod phases;
mod units;
