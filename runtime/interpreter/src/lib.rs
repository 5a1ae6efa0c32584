//! A derived model that runs without a compiler: the same declaration, the same equations, the same
//! events, its arithmetic interpreted on the numbers that the engine uses.
//!
//! ```text
//! Analysis → Interpreted → Model, on f64, dual numbers, Taylor series and double-double
//! ```
//!
//! - [`Interpreted`]: a model without values of its parameters.
//! - `layout`: its names, as derived code has them.
//! - `code`: straight-line arithmetic as instructions over registers; `constants`: what parameters
//!   alone determine.
//! - `system`: the full equations and the phases; `series`: the Taylor series of a phase.
//! - `numbers`: measures, restitution, the nominal figure.
//! - `native`, with the feature `jit`: what is run often, compiled for this processor.
//! - `pool`: memory that is lent, so that no step allocates.

mod code;
mod constants;
mod interpreted;
mod layout;
#[cfg(feature = "jit")]
mod native;
mod numbers;
mod pool;
mod series;
mod system;

pub use interpreted::Interpreted;
