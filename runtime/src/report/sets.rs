//! Contact sets, their degrees of freedom, and what leads from one to another.

use super::Subject;
use crate::catalog::Failure;
use crate::html::escaped;

pub fn html(subject: &Subject) -> Result<String, Failure> {
    let modes = subject.model.modes(&subject.setup)?;
    Ok(format!("<pre>{}</pre>\n", escaped(&modes.to_string())))
}
