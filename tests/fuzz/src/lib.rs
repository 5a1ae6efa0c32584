//! Hostile input from seeds: the same cases on every machine.
//!
//! A [`Subject`] draws cases and judges them; a [`worker`] runs a range of seeds in a process of
//! its own, so that a stack overflow, an abort or a hang is a finding like any other; a
//! [`campaign`] keeps workers busy for a given time.

pub mod campaign;
pub mod declaration;
pub mod expression;
pub mod journal;
pub mod metamorphic;
pub mod run;
pub mod subject;
pub mod sweep;
mod text;
pub mod worker;

pub use subject::{Fate, Finding, Subject, judge};
