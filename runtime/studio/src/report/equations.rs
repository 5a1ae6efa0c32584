//! What was derived.

use super::Subject;
use crate::explain;
use crate::registry::Failure;

pub fn html(subject: &Subject) -> Result<String, Failure> {
    Ok(explain::html::part(&explain::equations(subject.model.layout())))
}
