//! The default run in pictures: coordinates, reactions and energies against time, and positions on
//! the way.

use super::Subject;
use crate::html::fitting;
use crate::picture::{Charts, Positions};
use crate::registry::MotionError;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let record = subject.record()?;
    let charts = fitting(|width| Charts::new(record).size(width, None).svg());
    let positions = fitting(|width| Positions::new(record).size(width, None).svg());
    let failed = |error: MotionError| MotionError::Input(error.to_string());
    let [charts, positions] = [charts.map_err(failed)?, positions.map_err(failed)?];
    Ok(format!("<div class=figures>\n{charts}{positions}</div>\n"))
}
