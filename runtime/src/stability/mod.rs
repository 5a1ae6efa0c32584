//! Whether runs can be trusted: cases with the outcome that mechanics, a closed form or another way of computing demands, the
//! outcome measured, and a verdict.
//!
//! A [`Group`] has cases about one difficulty, written for its scenes; a [`General`] one asks the same of any model's default
//! run. `stability` on the command line judges both.
//!
//! ```
//! use liftoff::catalog::run;
//! use liftoff::prelude::*;
//! use liftoff::scene::Setup;
//! use liftoff::stability::{Case, want};
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
//! let falls = Setup::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]).start(&[("phi", 1.5707963267948966)]).until("phi = 0");
//! let wants = vec![want("phi'", -3f64.sqrt(), 1e-10)];
//! let case = Case::numbers("pendulum.falls", "a bar falls from the horizontal", "energy", wants, move |by| {
//!     let record = run::<Pendulum>(by, &falls)?;
//!     Ok(vec![record.state(record.interval()[1])[1]])
//! });
//! assert!(case.judge(Duration::from_secs(60)).pass);
//! ```

mod answer;
mod case;
mod general;
mod group;
mod page;
pub mod story;
mod table;
mod verdict;

pub use answer::{Answer, Expected, Want, at_most, want};
pub use case::Case;
pub use general::{GENERAL, General};
pub use group::{Effort, Group, Judged};
pub use page::html;
pub(crate) use page::{STYLE, table as verdict_table};
pub use table::{summary, text};
pub use verdict::Verdict;
