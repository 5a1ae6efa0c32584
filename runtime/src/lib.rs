//! Planar bar systems with one-sided supports: equations derived at compile time, contacts decided at run time.
//!
//! Declare a system with the derive macro [`BarSystem`](derive@BarSystem): bars, bodies and particles; hinges, pins, welds,
//! sliders and drives; supports and threads, smooth or rough, with restitution; springs and dampers, forces and couples.
//! Prepare a [`Simulation`], read its [`Trajectory`]: events, coordinates, reactions, joint and internal forces as
//! [`Output`]s. The [`book`] begins with a tutorial that does it step by step.
//!
//! ```
//! use liftoff::prelude::*;
//!
//! /// A ladder of length `l` between a smooth floor and a smooth wall.
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
//! let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
//! let run = Simulation::new(&ladder)?.start(Pose::at("phi", 1.3))?.until("phi = 0")?.run()?;
//! let leaves = &run.events()[1];
//! assert_eq!((leaves.kind, &leaves.supports[..]), (EventKind::Open, &["B"][..]));
//! // sin φ = ⅔ sin φ₀, and the floor bears a quarter of the weight.
//! assert!((leaves.state[0].sin() - 2.0 / 3.0 * 1.3f64.sin()).abs() < 1e-10);
//! assert!((run.value(&Output::parse::<Ladder>("N(A) / (m * g)")?, leaves.t) - 0.25).abs() < 1e-10);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # Without the standard library
//!
//! Without its default feature `std`, and with `libm`, this crate is `no_std` and allocates nothing: models, their equations,
//! all steppers but Radau's, and [`flow`](fn@flow), a motion without events. Programs that only flow have no code of guards, contacts
//! or impacts with `std` either.
//!
//! # The files
//!
//! - [`model`]: the traits that the derive implements, a phase, the full equations; [`kernel`], [`figure`], [`chain`]: what
//!   emitted code calls.
//! - [`scalar`]: the numbers that emitted code runs on; [`series`]: Taylor series of a phase, order by order.
//! - [`integrate`]: steppers (Taylor, DOP853, Tsitouras, Radau, Gauss) and what they share; [`method`]: which of them a run
//!   takes; [`guard`]: roots and extrema of a function over one step.
//! - `start`: a pose completed from what is given; `simulation`: what is asked for; `scales`: natural units.
//! - `flow`: a motion without events. All that follows needs the standard library, feature `std`.
//! - `driver`: decide, integrate, decide again; impacts, their accumulation, and what is planned; `contact`:
//!   complementarity of accelerations with its degenerate cases, and of impulses ([`impulse`]: in plain numbers);
//!   `rest`: equilibria; `chart`, `pivot`: where a closed form holds.
//! - `segment`: one phase up to its first event; `watch`: its guards; `project`: back onto the constraints; `moment`: a
//!   state between steps; `singular`: through positions where closed loops lose rank.
//! - `reference`: a motion once more in double-double, by extrapolation; `precision`: error against run time.
//! - `event`, `occurrence` (which of them), `observe` (runs seen while they are computed), `trajectory`, `output` (expressions), `phase_handle` (equations without integrator), `names`, `error`,
//!   `explain`, `modes`: what is told.
//! - `batch`: a phase's equations for many states at once; `ensemble`, a feature: many motions at once, on all threads.
//! - Feature `report`: `scene` (a model's run worth seeing), `catalog` (models by name, their types erased), `plot` (charts as
//!   SVG), `picture` (drawings of models and motions), `animation` (a motion as a page that plays it), `html` (pages),
//!   `work_precision` (error against run time as a table), `stability` (runs judged), `report` (all of it on a page).
//! - `sweep`, a feature: many runs over ranges; `cli`, a feature: the command line over all of these.

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("without the feature `std` elementary functions come from the feature `libm`");

#[cfg(test)]
extern crate self as liftoff;

#[cfg(feature = "report")]
pub mod animation;
#[cfg(feature = "std")]
mod batch;
#[cfg(feature = "std")]
pub mod book;
#[cfg(feature = "report")]
pub mod catalog;
pub mod chain;
#[cfg(feature = "std")]
mod chart;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "std")]
mod contact;
#[cfg(feature = "std")]
mod driver;
#[cfg(feature = "ensemble")]
pub mod ensemble;
#[cfg(feature = "std")]
mod error;
#[cfg(feature = "std")]
mod event;
#[cfg(feature = "explain")]
pub mod explain;
pub mod figure;
mod flow;
#[cfg(feature = "std")]
pub mod guard;
#[cfg(feature = "report")]
pub mod html;
pub mod integrate;
pub mod kernel;
#[cfg(feature = "std")]
pub mod method;
pub mod model;
#[cfg(feature = "std")]
mod modes;
#[cfg(feature = "std")]
mod moment;
#[cfg(feature = "std")]
mod names;
#[cfg(feature = "std")]
mod number;
#[cfg(feature = "std")]
mod observe;
#[cfg(feature = "std")]
mod occurrence;
#[cfg(feature = "std")]
mod output;
#[cfg(feature = "std")]
mod phase_handle;
#[cfg(feature = "report")]
pub mod picture;
#[cfg(feature = "std")]
mod pivot;
#[cfg(feature = "report")]
pub mod plot;
#[cfg(feature = "std")]
mod precision;
mod project;
#[cfg(feature = "std")]
mod reference;
#[cfg(feature = "report")]
pub mod report;
#[cfg(feature = "std")]
mod rest;
pub mod scalar;
#[cfg_attr(not(feature = "std"), expect(dead_code, reason = "masses and forces are scales of contacts"))]
mod scales;
#[cfg(feature = "report")]
pub mod scene;
#[cfg(feature = "std")]
mod segment;
pub mod series;
#[cfg(feature = "std")]
mod simulation;
#[cfg(feature = "std")]
mod singular;
#[cfg(feature = "report")]
pub mod stability;
#[cfg(feature = "std")]
mod start;
#[cfg(feature = "sweep")]
pub mod sweep;
#[cfg(feature = "std")]
mod trajectory;
#[cfg(feature = "std")]
mod watch;
#[cfg(feature = "report")]
pub mod work_precision;

#[cfg(feature = "std")]
pub use batch::{Batch, BatchError, Side};
#[cfg(feature = "std")]
pub use contact::{ContactError, impulse};
#[cfg(feature = "std")]
pub use error::{ModelError, NameError, RunCause, RunError, ScheduleError, StartError, SupportError};
#[cfg(feature = "std")]
pub use event::{Event, EventKind, Reaction};
#[cfg(feature = "explain")]
pub use explain::equations;
pub use flow::{FlowError, flow};
#[cfg(feature = "explain")]
pub use liftoff_codegen::text::Equations;
#[doc = include_str!("attributes.md")]
pub use liftoff_derive::BarSystem;
/// Appends the equations of a model to its documentation; stands above `#[derive(BarSystem)]`.
///
/// `cargo doc` then shows energies, mass matrix, forces, gaps and the equations of every phase below what the struct's own
/// documentation says, set by the browser from MathML. Where the struct is compiled and not documented it does nothing, and
/// takes no time. Where the crate has another name its path is given: `#[document(my::liftoff)]`.
///
/// ```
/// use liftoff::prelude::*;
///
/// /// A bar that swings.
/// #[liftoff::document]
/// #[derive(BarSystem)]
/// #[gravity(g)]
/// #[bar(OA, mass = m, length = l)]
/// #[pin(O = (0, 0))]
/// #[figure(A = (0, -l))]
/// #[coordinate(phi = angle(OA), from = down)]
/// struct SwingingBar {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
/// ```
pub use liftoff_derive::document;
#[doc(hidden)]
pub use liftoff_derive::documented;
pub use model::BarSystem;
#[cfg(feature = "std")]
pub use modes::{Mode, Modes, Transition, modes};
#[cfg(feature = "std")]
pub use observe::{Observer, Step};
#[cfg(feature = "std")]
pub use output::{Condition, Formula, Output, OutputError};
#[cfg(feature = "std")]
pub use phase_handle::{PhaseHandle, Phases};
#[cfg(feature = "std")]
pub use precision::{Measurement, Precision, PrecisionError};
#[cfg(feature = "std")]
pub use reference::{Reference, ReferenceError};
#[cfg(feature = "std")]
pub use simulation::Simulation;
#[cfg(feature = "std")]
pub use start::Pose;
#[cfg(feature = "std")]
pub use trajectory::{Extremum, LogEntry, Segment, Statistics, Trajectory};

/// What a program needs to declare, run and read a simulation.
pub mod prelude {
    pub use crate::BarSystem;
    pub use crate::model::Form;
    #[cfg(feature = "report")]
    pub use crate::scene::{Scene, Setup};
    #[cfg(feature = "std")]
    pub use crate::{Event, EventKind, Output, Phases, Pose, Reaction, RunError, Simulation, Trajectory};
}

#[cfg(all(doctest, feature = "std"))]
#[doc = include_str!("../../README.md")]
struct Readme;
