//! Each scene as an expert writes it for that scene alone: its numbers in place, its own
//! coordinates, no general method.

mod integrate;

pub mod dropped_bar;
pub mod falling_bar;
pub mod fig_1a;
pub mod fig_1b;
pub mod four_bar;
pub mod free_bar;
pub mod pendulum;
pub mod rubbing_rod;
pub mod slung_bar;
pub mod sprung_pendulum;
pub mod standing_bar;

pub use integrate::integrate;
