//! Why there is no picture.

use crate::plot::DrawingError;
use crate::registry::Failure;
use liftoff::OutputError;

/// Why there is no picture.
#[derive(thiserror::Error, Debug)]
pub enum PictureError {
    /// A name that the model does not have, or a run that failed.
    #[error(transparent)]
    Model(#[from] Failure),
    /// Something that cannot be drawn.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
}

impl From<OutputError> for PictureError {
    fn from(error: OutputError) -> Self {
        Failure::from(error).into()
    }
}
