//! Why there is no picture.

use crate::registry::MotionError;
use liftoff::OutputError;

/// A declaration that cannot be read again.
#[derive(thiserror::Error, Debug)]
#[error("cannot draw {figure}: {reason}")]
pub struct DrawingError {
    /// Name of the model.
    pub figure: String,
    /// Why.
    pub reason: String,
}

/// Why there is no picture.
#[derive(thiserror::Error, Debug)]
pub enum PictureError {
    /// A name that the model does not have, or a run that failed.
    #[error(transparent)]
    Model(#[from] MotionError),
    /// Something that cannot be drawn.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
}

impl From<OutputError> for PictureError {
    fn from(error: OutputError) -> Self {
        MotionError::from(error).into()
    }
}
