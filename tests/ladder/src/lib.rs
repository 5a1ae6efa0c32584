//! A ladder of scenes: a free bar, with gravity, a pin, a support, impacts, a spring, a thread.
//! Each is declared, and in `by_hand` written out as an expert would for that scene alone.
//!
//! The declarations need no standard library. The programs in `src/bin` run each scene, derived and
//! by hand; what they are made of is measured by `cargo bench -p liftoff-tests --bench speed` and
//! tested in `tests/symbols.rs`.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod bare;
#[cfg(feature = "std")]
pub mod by_hand;
mod dropped_bar;
mod falling_bar;
mod free_bar;
#[cfg(feature = "measure")]
pub mod measure;
mod pendulum;
mod slung_bar;
mod sprung_pendulum;
mod standing_bar;

pub use dropped_bar::DroppedBar;
pub use falling_bar::FallingBar;
pub use free_bar::FreeBar;
pub use pendulum::Pendulum;
pub use slung_bar::SlungBar;
pub use sprung_pendulum::SprungPendulum;
pub use standing_bar::StandingBar;

/// g.
pub const GRAVITY: f64 = 9.81;
