//! The pose that shows best how a model is made.

use crate::registry::{Configuration, Entry, MotionError};
use crate::run_spec::RunSpec;

/// Points nearer than this part of the size count as one only where they lie on one another.
const APART: f64 = 1e-9;

/// The start of a run or the nominal figure: the one of which the points are the better told apart
/// and the angles seen.
///
/// # Errors
/// A spec that the model cannot start from.
pub fn clearest_pose(model: &Entry, spec: &RunSpec) -> Result<Configuration, MotionError> {
    let start = model.configuration(spec)?;
    let figure = RunSpec { start: Vec::new(), energy_of: Vec::new(), ..spec.clone() };
    match model.configuration(&figure) {
        Ok(figure) if clarity(&figure) > clarity(&start) => Ok(figure),
        _ => Ok(start),
    }
}

/// The least distance of two points over the greatest, and how far the angles are from none.
fn clarity(configuration: &Configuration) -> f64 {
    let points = &configuration.points;
    let pairs = points.iter().enumerate().flat_map(|(i, a)| points[..i].iter().map(move |b| (a, b)));
    let distances: Vec<f64> = pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).collect();
    let most = distances.iter().copied().fold(0.0, f64::max);
    let least = distances.iter().copied().filter(|d| *d > APART * most).fold(most, f64::min);
    let angles = configuration
        .layout
        .coordinates
        .iter()
        .zip(&configuration.state)
        .filter(|(coordinate, _)| coordinate.is_angle);
    let seen = angles.map(|(_, value)| value.sin().abs().min(0.3)).fold(0.3, f64::min);
    seen + if most > 0.0 { least / most } else { 0.0 }
}
