//! What was derived.

use super::Subject;
use crate::explain;
use crate::registry::MotionError;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    Ok(explain::html::part(&explain::equations(subject.model.layout())))
}
