//! Planar bar systems with one-sided supports: equations derived at compile time, contacts decided at run time.
//!
//! Declare a system with the derive macro [`BarSystem`](derive@BarSystem): bars, bodies and particles; hinges, pins, welds,
//! sliders and drives; supports and threads, smooth or rough, with restitution; springs and dampers, forces and couples.
//! Prepare a [`Simulation`], read its [`Trajectory`]: events, coordinates, reactions, joint and internal forces as
//! [`Output`]s. The book, in `liftoff_cli::book`, begins with a
//! tutorial that does it step by step.
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
//! assert!((run.value(&Output::parse(Ladder::LAYOUT, "N(A) / (m * g)")?, leaves.t) - 0.25).abs() < 1e-10);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # Without the standard library
//!
//! Without its default feature `std`, and with `libm`, this crate is `no_std` and allocates nothing: models, their equations,
//! all steppers but Radau's, and [`flow`](fn@flow), a motion without events. Programs that only flow have no code of guards, contacts
//! or impacts with `std` either.
//!
//! # The folders
//!
//! What a run goes through, in its order; all of it needs the standard library, feature `std`.
//!
//! - `simulation`: what is asked for, and the event loop: decide which contacts are closed, integrate, decide again.
//! - `scales`: natural units of a model; `assembly`: a pose completed from what is given to a start that satisfies the
//!   constraints.
//! - `contact`: complementarity of accelerations with its degenerate cases, and of impulses ([`impulse`]: in plain numbers).
//! - `integration`: one phase from its start to its first event: the form it is integrated in, the method ([`method`]), its
//!   equilibria, singular positions of closed loops; [`PhaseHandle`]: its equations without integrator.
//! - [`event`](mod@event): what happens in a motion; the guards that tell it, and their roots over one step.
//! - `trajectory`: the motion as computed; runs seen while they are computed. [`expression`]: outputs and conditions as text.
//! - `ensemble`, a feature: many motions at once, on all threads. `modes`: the contact sets of a model and how they follow one
//!   another. `error`: what can go wrong, by stage. `audit`: what every motion satisfies; `decomposition`: singular values and
//!   eigenvalues.
//!
//! Below the engine stands `liftoff-core`, whose modules are those of this crate too: [`model`], the traits that the derive
//! implements; [`kernel`], [`hinge`], [`figure`], [`chain`], what emitted code calls; [`scalar`], the numbers that it runs on; [`series`],
//! Taylor series of a phase; [`integrate`], steppers; `system`, a model with its type erased. Above it stand
//! `liftoff-verification` (references, precision, cases judged), `liftoff-analysis` (equilibria, linearisation),
//! `liftoff-conditions` (lift-off as a formula), `liftoff-studio` (models by name, drawings, charts, pages, sweeps) and
//! `liftoff-cli` (the command line over all of these).

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("without the feature `std` elementary functions come from the feature `libm`");

#[cfg(test)]
extern crate self as liftoff;

#[cfg(feature = "std")]
mod assembly;
#[cfg(feature = "std")]
mod audit;
#[cfg(feature = "std")]
mod contact;
#[cfg(feature = "std")]
mod context;
#[cfg(feature = "ensemble")]
pub mod ensemble;
#[cfg(feature = "std")]
mod error;
#[cfg(feature = "std")]
pub mod event;
#[cfg(feature = "std")]
pub mod expression;
#[cfg(feature = "std")]
mod integration;
#[cfg(feature = "std")]
mod modes;
#[cfg(feature = "std")]
mod numerics;
#[cfg(feature = "std")]
mod simulation;
#[cfg(feature = "std")]
mod trajectory;

#[cfg(feature = "std")]
pub use assembly::{Pose, StartError};
#[cfg(feature = "std")]
pub use audit::{Audit, Finding, Quantity};
#[cfg(feature = "std")]
pub use contact::ContactError;
#[cfg(feature = "std")]
pub use error::{ModelError, NameError, OutputError, ScheduleError, SupportError};
#[cfg(feature = "std")]
pub use event::{Event, EventKind, ImpactOrder, Note, PreImpact, Reaction};
#[cfg(feature = "std")]
pub use expression::contact_set;
#[cfg(feature = "std")]
pub use expression::{Condition, Formula, Output};
#[cfg(feature = "std")]
pub use integration::method;
#[cfg(feature = "std")]
pub use liftoff_core::batch::{Batch, NoClosedForm, Side};
#[cfg(feature = "std")]
pub use liftoff_core::scales::Scales;
#[cfg(feature = "std")]
pub use liftoff_core::system;
pub use liftoff_core::{FlowError, flow};
pub use liftoff_core::{chain, figure, hinge, integrate, kernel, model, scalar, series};
#[cfg(feature = "derive")]
#[doc = include_str!("attributes.md")]
pub use liftoff_derive::BarSystem;
#[cfg(feature = "derive")]
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
#[cfg(feature = "derive")]
#[doc(hidden)]
pub use liftoff_derive::documented;
pub use model::BarSystem;
#[cfg(feature = "std")]
pub use modes::{Change, Mode, Modes, Transition, modes};
#[cfg(feature = "std")]
pub use simulation::phase_handle::{PhaseHandle, Phases};
#[cfg(feature = "std")]
pub use simulation::{Budget, Exhausted, RunCause, RunError, Scene, Simulation};
#[cfg(feature = "std")]
pub use trajectory::observe::{Observer, Step};
#[cfg(feature = "std")]
pub use trajectory::{
    AppliedImpulse, Extremum, Instant, LogEntry, LoggedDecision, Segment, Statistics, Trajectory,
};

/// Collisions in plain numbers: rows of a Jacobian, laws of restitution, the impulses that follow,
/// and the path of a single contact with friction.
#[cfg(feature = "std")]
pub mod impulse {
    pub use crate::contact::impulse::*;
    pub use crate::contact::{Path, Striker, Vertex};
}

/// What a program needs to declare, run and read a simulation.
pub mod prelude {
    pub use crate::BarSystem;
    pub use crate::model::Form;
    #[cfg(feature = "std")]
    pub use crate::{Event, EventKind, Output, Phases, Pose, Reaction, RunError, Simulation, Trajectory};
}
