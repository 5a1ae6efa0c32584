//! What can be asked of any model's default run, beside what [`liftoff_verification::cases`] has:
//! cases, groups of them and verdicts; and the page of verdicts.
//!
//! A [`Group`] has cases about one difficulty, written for its scenes; a [`General`] one asks the
//! same of any model's default run. `stability` on the command line judges both.
//!
//! ```
//! use liftoff::prelude::*;
//! use liftoff_studio::run_spec::RunSpec;
//! use liftoff_studio::checks::{Case, expect};
//! use std::time::Duration;
//!
//! /// A bar that swings.
//! #[derive(BarSystem)]
//! #[gravity(g)]
//! #[bar(OA, mass = m, length = l)]
//! #[pin(O = (0, 0))]
//! #[figure(A = (0, -l))]
//! #[coordinate(phi = angle(OA), from = down)]
//! struct Pendulum {
//!     m: f64,
//!     l: f64,
//!     g: f64,
//! }
//!
//! // φ̇² = 3 g/l cos φ where it falls from the horizontal.
//! let falls = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]).start(&[("phi", 1.5707963267948966)]).until("phi = 0");
//! let expectations = vec![expect("phi'", -3f64.sqrt(), 1e-10)];
//! let case = Case::numbers("pendulum.falls", "a bar falls from the horizontal", "energy", expectations, move |by| {
//!     let models = liftoff_studio::models![Pendulum];
//!     let record = models.find("pendulum")?.run_witnessed(by, &falls)?;
//!     Ok(vec![record.state(record.interval()[1])[1]])
//! });
//! assert!(case.judge(Duration::from_secs(60)).passes());
//! ```

mod general;
mod page;

pub use general::{GENERAL, General};
pub use liftoff_verification::cases::*;
pub use page::html;
pub(crate) use page::{STYLE, table as verdict_table};
