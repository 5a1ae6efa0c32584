//! What of error against run time to measure.

use core::time::Duration;

use liftoff::method::MethodId;
use thiserror::Error;

/// Relative tolerances below this tell nothing: doubles have 2.2e-16.
const LEAST: f64 = 1e-18;

/// What of error against run time to measure.
#[derive(Clone, PartialEq, Debug)]
pub struct PrecisionSpec {
    /// Methods in this order.
    pub methods: Vec<MethodId>,
    /// Relative tolerances.
    pub tolerances: Vec<f64>,
    /// Time for each method at each tolerance.
    pub measuring: Duration,
}

/// What cannot be measured.
#[derive(Clone, Copy, PartialEq, Debug, Error)]
pub enum PrecisionSpecError {
    /// No error is relative to it.
    #[error("tolerance {0} is not between 0 and 1")]
    Tolerance(f64),
    /// Doubles do not tell it from a greater one.
    #[error("tolerance {0:e} is below the resolution of f64: the least is {LEAST:e}")]
    Fine(f64),
    /// Nothing is asked for.
    #[error("no method or no tolerance to measure")]
    Nothing,
}

impl PrecisionSpec {
    /// Refuses what cannot be measured.
    pub fn check(&self) -> Result<(), PrecisionSpecError> {
        if self.methods.is_empty() || self.tolerances.is_empty() {
            return Err(PrecisionSpecError::Nothing);
        }
        self.tolerances.iter().try_for_each(|tolerance| check_tolerance(*tolerance))
    }
}

/// Refuses relative tolerances that mean nothing.
pub fn check_tolerance(tolerance: f64) -> Result<(), PrecisionSpecError> {
    match tolerance {
        t if !(t > 0.0 && t < 1.0) => Err(PrecisionSpecError::Tolerance(t)),
        t if t < LEAST => Err(PrecisionSpecError::Fine(t)),
        _ => Ok(()),
    }
}

impl Default for PrecisionSpec {
    /// Every method at 1e-3 … 1e-14.
    fn default() -> Self {
        let tolerances = (3..=14).map(|digits| format!("1e-{digits}").parse().unwrap_or(f64::NAN));
        Self {
            methods: MethodId::ALL.to_vec(),
            tolerances: tolerances.collect(),
            measuring: Duration::from_millis(20),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unmeasurable_requests_are_refused() {
        let with = |tolerances: &[f64]| {
            PrecisionSpec { tolerances: tolerances.to_vec(), ..PrecisionSpec::default() }.check()
        };
        assert_eq!(PrecisionSpec::default().check(), Ok(()));
        for tolerance in [-1.0, 0.0, 1.0, f64::INFINITY] {
            assert_eq!(with(&[1e-3, tolerance]), Err(PrecisionSpecError::Tolerance(tolerance)));
        }
        assert!(matches!(with(&[f64::NAN]), Err(PrecisionSpecError::Tolerance(_))));
        assert_eq!(with(&[1e-300]), Err(PrecisionSpecError::Fine(1e-300)));
        assert_eq!(with(&[]), Err(PrecisionSpecError::Nothing));
        let told = PrecisionSpecError::Fine(1e-300).to_string();
        assert_eq!(told, "tolerance 1e-300 is below the resolution of f64: the least is 1e-18");
    }
}
