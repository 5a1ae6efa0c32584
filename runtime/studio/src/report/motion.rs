//! The default run, played: the page of the motion within this one.

use super::Subject;
use crate::animation::{About, page};
use crate::html::escaped;
use crate::registry::Failure;

pub fn html(subject: &Subject) -> Result<String, Failure> {
    let about = About {
        title: subject.model.name(),
        summary: subject.model.summary(),
        parameters: &subject.spec.parameters,
        stopped: subject.stopped.as_deref(),
        ..About::default()
    };
    let page = page(subject.record()?, &about)?;
    Ok(format!("<iframe title=\"the motion, played\" srcdoc=\"{}\"></iframe>\n", escaped(&page)))
}
