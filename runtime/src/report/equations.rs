//! What was derived.

use super::Subject;
use crate::catalog::Failure;
use crate::html::escaped;

pub fn html(subject: &Subject) -> Result<String, Failure> {
    let equations = subject.model.layout().explain().to_string();
    Ok(format!("<pre>{}</pre>\n", escaped(&equations)))
}
