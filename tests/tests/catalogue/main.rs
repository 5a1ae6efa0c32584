//! Every model of the catalogue against its closed form, or its published reference.
//!
//! Runs are made at tolerance 1e-13; what they are held to is 1e-10 unless a test says why not.

#[path = "../common/mod.rs"]
mod common;

mod chains;
mod falls;
mod loops;
mod points;
mod sections;
mod statics;

/// What runs are held to.
const CLOSE: f64 = 1e-10;
