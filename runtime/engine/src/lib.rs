//! Planar bar systems with one-sided supports: equations derived at compile time, contacts decided
//! at run time.
//!
#![doc = include_str!("picture.svg")]
//!
//! Two bars lie across a gap. The reactions of its corners P and Q fall until they vanish: there
//! the bars leave both and fall freely. The formula for when is derived at compile time; the
//! instant is located at run time.
//!
//! Declare a system with the derive macro [`BarSystem`](derive@BarSystem): bars, bodies and
//! particles; hinges, pins, welds, sliders and drives; supports and threads, smooth or rough, with
//! restitution; springs and dampers, forces and couples. Prepare a [`Simulation`], read its
//! [`Trajectory`]: events, coordinates, reactions, joint and internal forces as [`Output`]s. The
//! book, in `liftoff_cli::book`, begins with a tutorial that does it step by step.
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
//! let run = Simulation::new(&ladder)?.start(Pose::new("phi", 1.3))?.until("phi = 0")?.run()?;
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
//! Without its default feature `std`, and with `libm`, this crate is `no_std` and allocates
//! nothing: models, their equations, all steppers but Radau's, and [`flow`](fn@flow), a motion
//! without events. Programs that only flow have no code of guards, contacts or impacts with `std`
//! either.
//!
//! # What a program meets
//!
//! - To declare: [`BarSystem`](derive@BarSystem), [`document`](macro@document); the model as a
//!   value of any kind, [`Scene`], [`Model`], [`Layout`].
//! - To run: [`Simulation`] from a [`Pose`], by a [`method`], to the end that is asked for;
//!   [`Budget`]. What can go wrong, by stage: [`ModelError`], [`StartError`], [`ScheduleError`],
//!   [`RunError`] with the motion so far.
//! - To read: [`Trajectory`] with [`Event`]s, dense output and [`Output`]s; [`Observer`] for a run
//!   while it is computed; [`Audit`].
//! - Without events: [`PhaseHandle`] for the equations of one contact set, [`flow`](fn@flow) for
//!   their motion, [`Modes`] for the graph of contact sets.
//! - Over other numbers: [`scalar`]; [`precise`] for double-double, [`varied`] for derivatives,
//!   [`lanes`] for several states at once.
//!
//! Below this crate stands `liftoff-core`: model traits, scalars, Taylor series, steppers. Above it
//! stand `liftoff-verification` (references, precision, cases judged), `liftoff-analysis`
//! (equilibria, linearisation), `liftoff-conditions` (lift-off as a formula), `liftoff-studio`
//! (models by name, drawings, charts, pages, sweeps) and `liftoff-cli` (the command line over all
//! of these).

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
#[cfg(feature = "equations")]
mod equations;
#[cfg(feature = "std")]
mod error;
#[cfg(feature = "std")]
mod event;
#[cfg(feature = "std")]
mod expression;
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
#[cfg(feature = "equations")]
pub use equations::equations;
#[cfg(feature = "std")]
pub use error::{ModelError, NameError, OutputError, ScheduleError, SupportError};
#[cfg(feature = "std")]
pub use event::{Event, EventFilter, EventKind, FrictionState, ImpactOrder, Note, PreImpact, Reaction};
#[cfg(feature = "std")]
pub use expression::{Condition, IntoConditions, Output, contact_set};
#[cfg(feature = "std")]
pub use integration::method;
pub use liftoff_core::model::{BarSystem, ContactSet, Form, Layout};
#[cfg(feature = "std")]
pub use liftoff_core::scales::Scales;
#[cfg(feature = "std")]
pub use liftoff_core::system::{Model, lanes, precise, varied};
pub use liftoff_core::{FlowError, flow, scalar};
#[cfg(feature = "std")]
use liftoff_core::{integrate, model, series, system};
#[cfg(feature = "derive")]
#[doc = include_str!("attributes.md")]
pub use liftoff_derive::BarSystem;
#[cfg(feature = "derive")]
/// Appends the equations of a model to its documentation; stands above `#[derive(BarSystem)]`.
///
/// `cargo doc` then shows energies, mass matrix, forces, gaps and the equations of every phase
/// below what the struct's own documentation says, set by the browser from MathML. Where the struct
/// is compiled and not documented it does nothing, and takes no time. Where the crate has another
/// name its path is given: `#[document(my::liftoff)]`.
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
#[cfg(feature = "std")]
pub use modes::{Change, Mode, ModeTransition, Modes, modes};
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

/// What emitted code calls and what the crates above the engine share: no part of the interface,
/// and it may change with every version.
#[doc(hidden)]
pub mod __private {
    pub use liftoff_core::__private::*;

    /// The reference of the language in Markdown: the documentation of `BarSystem`.
    #[cfg(feature = "std")]
    pub const LANGUAGE: &str = include_str!("attributes.md");

    #[cfg(feature = "std")]
    pub mod event {
        pub use crate::event::*;
    }

    #[cfg(feature = "std")]
    pub mod expression {
        pub use crate::expression::*;
    }

    /// Collisions in plain numbers: rows of a Jacobian, laws of restitution, the impulses that
    /// follow, and the path of a single contact with friction.
    #[cfg(feature = "std")]
    pub mod impulse {
        pub use crate::contact::impulse::*;
        pub use crate::contact::{Path, RouthContact, Vertex};
    }
}

/// What a program needs to declare, run and read a simulation.
pub mod prelude {
    pub use crate::{BarSystem, Form};
    #[cfg(feature = "std")]
    pub use crate::{Event, EventKind, Output, Phases, Pose, Reaction, RunError, Simulation, Trajectory};
}
