//! Numerical checks: cases with the outcome that mechanics, a closed form or another way of
//! computing demands, the outcome measured, and a verdict.
//!
//! A [`Group`] has cases about one difficulty, written for its scenes.
//!
//! ```
//! use liftoff::prelude::*;
//! use liftoff_verification::motion_error::{input, stopped};
//! use liftoff_verification::cases::{Case, expect};
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
//! let expectations = vec![expect("phi'", -3f64.sqrt(), 1e-10)];
//! let case = Case::numbers("pendulum.falls", "a bar falls from the horizontal", "energy", expectations, move |by| {
//!     let simulation = Simulation::new(&Pendulum { m: 1.0, l: 1.0, g: 1.0 }).map_err(input)?;
//!     let falls = simulation.start(Pose::new("phi", core::f64::consts::FRAC_PI_2)).map_err(input)?;
//!     let record = falls.until("phi = 0").map_err(input)?.method(by).run().map_err(stopped)?;
//!     Ok(vec![record.final_state()[1]])
//! });
//! assert!(case.judge(Duration::from_secs(60)).passes());
//! ```

mod answer;
mod case;
pub mod event_summary;
mod group;
mod table;
mod verdict;

pub use answer::{Answer, Expectation, Expected, at_most, expect};
pub use case::Case;
pub use group::{Effort, Group, GroupResult};
pub use table::{summary, text};
pub use verdict::{Outcome, Verdict};
