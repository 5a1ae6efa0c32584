//! What of error against run time to measure.

use core::time::Duration;

use liftoff::method::MethodId;

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
