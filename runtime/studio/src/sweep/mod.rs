//! Many runs of one model over ranges of its parameters and starts.
//!
//! A [`Sweep`] varies names: over grids, at random, or along Sobol's sequence. A varied name is a
//! parameter, a coordinate or rate at the start, or a name of its own that settings use in their
//! formulas. Of each member [`Observation`]s are read, on the thread that ran it; a member ends as
//! soon as all has been seen that is observed. A member's values depend neither on the number of
//! threads nor on the other members.
//!
//! ```
//! use liftoff::prelude::*;
//! use liftoff_studio::sweep::Sweep;
//!
//! /// A bar that falls from a wall.
//! #[derive(BarSystem)]
//! #[gravity(g)]
//! #[bar(AB, mass = m, length = l)]
//! #[support(A = floor)]
//! #[support(B = wall(0), facing = right)]
//! #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
//! #[coordinate(phi = angle(AB), from = horizontal)]
//! struct Ladder {
//!     m: f64,
//!     l: f64,
//!     g: f64,
//! }
//!
//! let models = liftoff_studio::models![Ladder];
//! let sweep = Sweep::new(models.find("ladder")?).set("m=1")?.set("l=2")?.set("g=9.81")?;
//! let table = sweep.vary("phi=0.5:1.5:11")?.observe("first open")?.observe("first open sin(phi)")?.run()?;
//! for (row, cell) in table.cells(1) {
//!     // The wall lets go where sin φ = ⅔ sin φ₀.
//!     let expected = 2.0 / 3.0 * row.point[0].sin();
//!     assert!(cell.number().is_some_and(|value| (value - expected).abs() < 1e-10));
//! }
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! With a [journal](Sweep::journal) a sweep that was interrupted goes on where it was, and a sample
//! that is enlarged computes what is new; of a journal that was damaged it computes the damaged
//! rows once more. [`Sweep::run_shard`] computes a part of a sweep, in memory of a few bytes a
//! member, and [`merge`] makes the parts one table; processes that send each other messages
//! ([`Processes`](liftoff_processes::Processes)) share one by [`Sweep::team`] and [`Sweep::work`].
//! [`Sweep::thresholds`] narrows down where what is observed changes, [`Sweep::boundaries`] follows
//! the curves in a plane across which it does.

mod aligned;
mod boundary;
mod builder;
mod cell;
mod check;
mod columnar;
mod condition;
mod criterion;
mod drawing;
mod error;
mod journal;
mod member;
mod observation;
mod paired;
mod plan;
mod range;
mod run;
mod sample;
mod setting;
mod shard;
mod summary;
mod table;
mod team;
#[cfg(test)]
mod tests;
mod threshold;
mod worker;

/// Members of a sweep, of which each is kept until the end.
pub const MOST_MEMBERS: usize = 4_000_000;
/// Threads of a sweep.
pub const MOST_THREADS: usize = 1024;

pub use aligned::{Columns, aligned};
pub use boundary::{Boundary, BoundaryEnd};
pub use builder::Sweep;
pub use cell::{Cell, MemberResult, Outcome};
pub use error::SweepError;
pub use observation::Observation;
pub use range::{Range, Spread, Varied};
pub use sample::Sample;
pub use shard::{MOST_SHARDS, Merged, Shard, Share, merge};
pub use summary::SHOWN;
pub use table::Table;
pub use team::Leader;
pub use threshold::Threshold;
pub use worker::refuse;
