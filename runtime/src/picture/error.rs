//! Why there is no picture.

use crate::catalog::Failure;
use crate::plot::DrawingError;

/// Why there is no picture.
#[derive(thiserror::Error, Debug)]
pub enum PictureError {
    /// Something asked for that the model does not have.
    #[error(transparent)]
    Asked(#[from] Failure),
    /// Something that cannot be drawn.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
}
