//! Closed forms of CATALOGUE.md, each a function of the angle; m = L = g = 1 unless an argument says otherwise.

pub mod a_frame;
pub mod double_pendulum;
pub mod hinged_bar;
pub mod ladder;
pub mod rod_on_floor;
pub mod vanishing_support;

#[cfg(test)]
mod tests;
