//! Contact sets, their degrees of freedom, and what leads from one to another.

use super::Subject;
use crate::html::escaped;
use crate::registry::MotionError;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let modes = subject.model.modes(&subject.spec)?;
    let table = format!(
        "<details><summary>In words</summary>\n<pre>{}</pre></details>\n",
        escaped(&modes.to_string())
    );
    Ok(format!(
        "<div class=figures><figure class=\"wide graph\">{}</figure></div>\n{table}",
        crate::modes::svg(&modes)
    ))
}
