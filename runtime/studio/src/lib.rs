//! What is shown of models declared with [`liftoff`], known by their names.
//!
//! - [`registry`]: models by name ([`models!`]), what to run of them ([`RunSpec`], [`DefaultRun`]),
//!   the dimensions of their parameters.
//! - [`analyses`]: equilibria, linearised motions.
//! - [`explain`]: equations for people and as sources of other programs, derived again from the
//!   declaration; [`source`]: models of a file that need not be compiled.
//! - [`plot`]: charts as SVG; [`picture`]: drawings of models and motions; [`modes`]: the graph of
//!   contact sets.
//! - [`html`]: pages; [`animation`]: a motion as a page that plays it, or runs it again;
//!   [`mod@file`]: files written whole or not at all.
//! - [`work_precision`]: error against run time as a table and a chart; [`checks`]: what can be
//!   asked of any model's default run, and its page.
//! - [`sweep`]: many runs over ranges of parameters and starts; [`report`]: all that there is to
//!   know of a model on a page.

#[cfg(test)]
extern crate self as liftoff_studio;

pub mod analyses;
pub mod animation;
pub mod checks;
pub mod explain;
pub mod file;
pub mod html;
pub mod modes;
pub mod picture;
pub mod plot;
pub mod registry;
pub mod report;
pub mod source;
pub mod sweep;
pub mod work_precision;

pub use explain::{Equations, equations};
pub use liftoff_verification as verification;
pub use registry::run_spec::{self, DefaultRun, RunSpec};
