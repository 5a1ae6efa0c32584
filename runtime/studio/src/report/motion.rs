//! The default run, played: the page of the motion within this one.

use super::Subject;
use crate::animation::{About, page};
use crate::html::escaped;
use crate::registry::MotionError;

/// Makes the frame as high as the page in it, whatever the width.
const FIT: &str = "for (const frame of document.querySelectorAll('iframe')) frame.addEventListener('load', () => { \
    const page = frame.contentDocument.documentElement; \
    const fit = () => { frame.style.height = `${page.offsetHeight + 4}px`; }; \
    new ResizeObserver(fit).observe(page); fit(); });";

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let about = About {
        title: subject.model.name(),
        summary: subject.model.summary(),
        parameters: &subject.spec.parameters,
        stopped: subject.stopped.as_deref(),
        ..About::default()
    };
    let page = page(subject.record()?, &about)?;
    Ok(format!(
        "<iframe title=\"the motion, played\" srcdoc=\"{}\"></iframe>\n<script>{FIT}</script>\n",
        escaped(&page)
    ))
}
