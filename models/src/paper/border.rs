//! Where what a run shows changes with one number.

use super::ReportError;
use super::published::normalised;
use crate::models;
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::sweep::Sweep;

/// Where what the sweep observes changes first along its varied name, to within `width`.
pub fn find_border(sweep: &Sweep<'_>, width: f64) -> Result<f64, ReportError> {
    let changes = sweep.thresholds(width)?;
    let first = changes.first().ok_or(ReportError::NoChange)?;
    Ok(f64::midpoint(first.below, first.above))
}

/// The least φ(0), all `angles` equal, from which a support of the model opens before the bars lie
/// level.
pub fn find_least_start(
    model: &str,
    angles: &[&str],
    ratio: f64,
    tolerance: f64,
) -> Result<f64, ReportError> {
    let spec = normalised(RunSpec::default().tolerance(tolerance), ratio);
    let mut sweep =
        Sweep::new(models().find(model)?).spec(spec).vary("phi0=0.1:1.5:2")?.observe("first open")?;
    for angle in angles {
        sweep = sweep.start(&format!("{angle}=phi0"))?;
    }
    find_border(&sweep, 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::{published, strict};

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
            let found = find_least_start(published::MODEL, &["phi"], ratio, 1e-12).expect("runs");
            assert!((most(found, ratio) - 2.0).abs() < 1e-7, "{ratio}: {found}");
        }
        let strict = find_least_start(strict::MODEL, &["phi_inner", "phi_outer"], 0.5, 1e-12).expect("runs");
        assert!((strict - 0.501596).abs() < 1e-6, "{strict}");
    }
}
