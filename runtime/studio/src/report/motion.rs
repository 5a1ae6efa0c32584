//! The default run, played: the page of the motion within this one.

use super::Subject;
use crate::animation::live::{FIT, section};
use crate::animation::{About, page};
use crate::html::escaped;
use crate::registry::MotionError;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let about = About {
        title: subject.model.name(),
        summary: subject.model.summary(),
        parameters: &subject.spec.parameters,
        stopped: subject.stopped.as_deref(),
        ..About::default()
    };
    if let Some(engine) = subject.engine {
        return section(subject.model, &subject.spec, subject.record()?, &about, engine);
    }
    let page = page(subject.record()?, &about)?;
    Ok(format!(
        "<iframe title=\"the motion, played\" srcdoc=\"{}\"></iframe>\n<script>{FIT}</script>\n",
        escaped(&page)
    ))
}
