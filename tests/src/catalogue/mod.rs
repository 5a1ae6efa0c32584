//! Closed forms and published references, each a function of the angle; m = L = g = 1 unless an
//! argument says otherwise.

pub mod a_frame;
pub mod bouncing_ball;
pub mod car_axis;
pub mod chimney;
pub mod compass;
pub mod double_pendulum;
pub mod falling_bar;
pub mod folded_chain;
pub mod hinged_bar;
pub mod jansen;
pub mod ladder;
pub mod oscillator;
pub mod parallelogram;
pub mod ring;
pub mod rocking_block;
pub mod rod_on_floor;
pub mod slider_crank;
pub mod squeezer;
pub mod struck_chain;
pub mod toppling_rod;
pub mod trebuchet;
pub mod vanishing_support;
pub mod zigzag_thread;

#[cfg(test)]
mod tests;
