//! The least start at rest from which a support lets go, by bisection over runs.

use super::ReportError;
use super::published::normalised;
use super::reading::events_of;
use crate::models;
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};

/// The least φ(0), all `angles` equal, from which a support of the model opens before the bars lie level.
pub fn threshold(model: &str, angles: &[&str], ratio: f64, tolerance: f64) -> Result<f64, ReportError> {
    let model = models().find(model)?;
    let opens = |start: f64| -> Result<bool, ReportError> {
        let start: Vec<_> = angles.iter().map(|name| (*name, start)).collect();
        let run = RunSpec { start: named(&start), ..RunSpec::default().tolerance(tolerance) };
        Ok(events_of(&model.run(&normalised(run, ratio))?, EventKind::Open).next().is_some())
    };
    let [mut stays, mut lifts] = [0.1, 1.5];
    while lifts - stays > 1e-9 {
        let middle = f64::midpoint(stays, lifts);
        if opens(middle)? { lifts = middle } else { stays = middle }
    }
    Ok(f64::midpoint(stays, lifts))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// μ of (3.18) on the way from rest at φ(0), greatest over the angle.
    fn most(start: f64, ratio: f64) -> f64 {
        let mu = |phi: f64| {
            let (sin, cos) = phi.sin_cos();
            let bracket = 1.0 / 3.0 + 2.0 * ratio * sin * sin;
            let turned = 1.0 / 6.0 + 2.0 * ratio * start.sin() * sin - ratio * sin * sin;
            (start.sin() - sin) / bracket * sin + turned * cos * cos / (bracket * bracket)
        };
        (0..=100_000).map(|k| mu(start * f64::from(k) / 100_000.0)).fold(0.0, f64::max)
    }

    #[test]
    fn starts_that_lift_off_are_those_of_the_papers_inequality() {
        for ratio in [0.25, 0.5, 0.75] {
            let found = threshold("zigzag-published", &["phi"], ratio, 1e-12).expect("runs");
            assert!((most(found, ratio) - 2.0).abs() < 1e-7, "{ratio}: {found}");
        }
        let strict = threshold("zigzag", &["phi_inner", "phi_outer"], 0.5, 1e-12).expect("runs");
        assert!((strict - 0.501596).abs() < 1e-6, "{strict}");
    }
}
