//! From when to when an importer wants to simulate, and how accurately.

/// An experiment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Experiment {
    /// The time of the start, s.
    pub(crate) start: f64,
    /// The time beyond which nothing is asked for, s.
    pub(crate) stop: Option<f64>,
    /// Relative tolerance.
    pub(crate) tolerance: Option<f64>,
}

impl Experiment {
    /// Checks its values.
    ///
    /// # Errors
    /// One of them makes no sense.
    pub(crate) fn check(&self) -> Result<(), String> {
        let Self { start, stop, tolerance } = *self;
        match (stop, tolerance) {
            _ if !(start >= 0.0 && start.is_finite()) => {
                Err(format!("the start time {start} is not a finite time ≥ 0"))
            }
            (Some(stop), _) if !(stop > start && stop.is_finite()) => {
                Err(format!("the stop time {stop} is not a finite time after the start at {start}"))
            }
            (_, Some(tolerance)) if !(tolerance > 0.0 && tolerance < 1.0) => {
                Err(format!("the tolerance {tolerance} is not between 0 and 1"))
            }
            _ => Ok(()),
        }
    }
}
