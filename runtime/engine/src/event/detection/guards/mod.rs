//! What is watched over the steps of a phase: each kind of guard with its values, its series, its
//! bound and its memory.

mod condition;
mod drive;
mod foot;
mod gap;
mod grip;
mod limit;
mod list;
mod low_flight;
mod parting;
mod reaction;
mod slip;
mod watch;

pub(super) use list::list_guards;
pub(super) use watch::{Findings, Watch};
