//! What was derived.

use super::Subject;
use crate::catalog::Failure;
use crate::explain;

pub fn html(subject: &Subject) -> Result<String, Failure> {
    Ok(explain::html::part(&subject.model.layout().explain()))
}
