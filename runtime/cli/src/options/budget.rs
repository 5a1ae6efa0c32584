//! What a run may take.

use crate::options::values::{time, whole};
use clap::Args;
use liftoff::Budget;
use std::time::Duration;

/// Units of memory by their names, the longer first.
const UNITS: [(&str, f64); 7] = [
    ("KiB", 1024.0),
    ("MiB", 1_048_576.0),
    ("GiB", 1_073_741_824.0),
    ("kB", 1e3),
    ("MB", 1e6),
    ("GB", 1e9),
    ("B", 1.0),
];

/// What a run may take; one that takes more ends with an error and is printed as far as it came.
#[derive(Args, Debug)]
#[command(next_help_heading = "Budget")]
pub struct BudgetArgs {
    /// Steps of the integration
    #[arg(long, value_name = "N", value_parser = whole(1..=1 << 53), default_value_t = Budget::default().steps as usize)]
    max_steps: usize,
    /// Events
    #[arg(long, value_name = "N", value_parser = whole(1..=1 << 53), default_value_t = Budget::default().events)]
    max_events: usize,
    /// Impacts within one natural time
    #[arg(long, value_name = "N", value_parser = whole(1..=1 << 53), default_value_t = Budget::default().impacts)]
    max_impacts: usize,
    /// Sets of contacts tried to decide which are closed
    #[arg(long, value_name = "N", value_parser = whole(1..=1 << 53), default_value_t = Budget::default().trials)]
    max_trials: usize,
    /// Memory of a recorded motion, for --audit
    #[arg(long, value_name = "BYTES", value_parser = bytes, default_value = "1GiB")]
    max_memory: usize,
    /// Wall time [default: unlimited]
    #[arg(long, value_name = "T", value_parser = duration)]
    timeout: Option<Duration>,
}

impl BudgetArgs {
    pub fn budget(&self) -> Budget {
        Budget {
            steps: self.max_steps as u64,
            events: self.max_events,
            impacts: self.max_impacts,
            trials: self.max_trials,
            memory: self.max_memory,
            time: self.timeout,
        }
    }
}

/// A time > 0 on the clock.
fn duration(text: &str) -> Result<Duration, String> {
    let seconds = time(text)?;
    let found = Duration::try_from_secs_f64(seconds).ok().filter(|time| !time.is_zero());
    found.ok_or_else(|| format!("`{}` is no time > 0", text.trim()))
}

/// Bytes, `500 MB` or `2 GiB`.
fn bytes(text: &str) -> Result<usize, String> {
    let known = UNITS.iter().find_map(|(unit, size)| Some((text.trim().strip_suffix(unit)?, *size)));
    let (number, size) = known.unwrap_or((text.trim(), 1.0));
    let bytes = number.trim().parse::<f64>().ok().map(|number| number * size);
    let found = bytes.filter(|bytes| (1.0..=2f64.powi(53)).contains(bytes));
    found.map(|bytes| bytes as usize).ok_or_else(|| format!("`{}` is no memory, as `500 MB` is", text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_has_units() {
        assert_eq!(bytes("65536"), Ok(65536));
        assert_eq!(bytes(" 1.5 kB"), Ok(1500));
        assert_eq!(bytes("1GiB"), Ok(Budget::default().memory));
        for wrong in ["", "0", "-1 MB", "MB", "1 TB", "nan", "inf B", "1e300 GB"] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_timeout_is_a_time() {
        assert_eq!(duration("1.5"), Ok(Duration::from_millis(1500)));
        assert_eq!(duration("20 ms"), Ok(Duration::from_millis(20)));
        for wrong in ["0", "-1", "1e300", "1 m"] {
            assert!(duration(wrong).is_err(), "{wrong}");
        }
    }
}
