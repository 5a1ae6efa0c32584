//! The commands that every program has.

pub mod animate;
pub mod boundary;
pub mod completions;
pub mod conditions;
pub mod equilibrium;
pub mod explain;
pub mod export;
pub mod fit;
pub mod linearise;
pub mod list;
pub mod merge;
pub mod modes;
pub mod new;
pub mod optimise;
pub mod orbit;
pub mod plot;
pub mod precision;
pub mod report;
pub mod run;
pub mod sensitivity;
pub mod stability;
pub mod sweep;
pub mod watch;
pub mod words;
