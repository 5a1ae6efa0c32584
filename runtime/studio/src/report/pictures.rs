//! The default run in pictures: coordinates, reactions and energies against time, and positions on the way.

use super::Subject;
use crate::picture::{Charts, Positions};
use crate::registry::MotionError;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let record = subject.record()?;
    let drawn = [Charts::new(record).svg(), Positions::new(record).svg()];
    let figures: Result<String, _> = drawn.into_iter().map(|svg| svg.map(figure)).collect();
    let failed = |error: MotionError| MotionError::Input(error.to_string());
    Ok(format!("<div class=figures>\n{}</div>\n", figures.map_err(failed)?))
}

fn figure(svg: String) -> String {
    format!("<figure class=wide>{svg}</figure>\n")
}
