//! Motions computed where there is no standard library: compiled here, not where they are called,
//! so that a bare-metal build of this crate has all of their code.

use liftoff::{FlowError, flow};

use crate::{FallingBar, Pendulum, SprungPendulum};

/// The pendulum's angle and its rate a `duration` after these.
///
/// # Errors
/// As [`flow`].
pub fn swing(state: &[f64; 2], duration: f64, tolerance: f64) -> Result<[f64; 2], FlowError> {
    flow(&Pendulum::SCENE, state, duration, tolerance)
}

/// The same of the pendulum with a spring.
///
/// # Errors
/// As [`flow`].
pub fn bounce(state: &[f64; 2], duration: f64, tolerance: f64) -> Result<[f64; 2], FlowError> {
    flow(&SprungPendulum::SCENE, state, duration, tolerance)
}

/// Angle and position of the falling bar and their rates a `duration` after these.
///
/// # Errors
/// As [`flow`].
pub fn fall(state: &[f64; 6], duration: f64, tolerance: f64) -> Result<[f64; 6], FlowError> {
    flow(&FallingBar::SCENE, state, duration, tolerance)
}
