//! An independent oracle: planar rigid bodies in maximal coordinates, Newton–Euler with a dense KKT system.
//!
//! It shares no code and no formulation with the generator: every body has its own x, y and angle, every
//! joint, constraint and closed support is a row, and one dense system gives accelerations and all forces.

mod assembly;
mod coordinate;
mod energy;
mod kkt;
mod motion;
mod rows;
mod settle;
mod state;

pub use assembly::{AngleTie, Assembly, Body, Contact, Hinge, Load, Mark, Particle, Pin, Support};
pub use coordinate::Coordinate;
pub use kkt::Unsolvable;
pub use motion::Motion;
pub use rows::Row;
pub use state::{Anchor, State};
