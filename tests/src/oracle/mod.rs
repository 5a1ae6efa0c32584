//! An independent oracle: planar rigid bodies in maximal coordinates, Newton–Euler with a dense KKT
//! system.
//!
//! It shares no code and no formulation with the generator: every body has its own x, y and angle,
//! every joint, constraint and closed support is a row, and one dense system gives accelerations
//! and all forces.

mod assembly;
mod coordinate;
mod energy;
mod forces;
mod formula;
mod impact;
mod internal;
mod joints;
mod kkt;
mod load;
mod motion;
mod rows;
mod settle;
mod state;
mod support;

pub use assembly::{Assembly, Body, Mark, Particle, Place};
pub use coordinate::Coordinate;
pub use formula::{Formula, Jet};
pub use impact::Impact;
pub use internal::Internal;
pub use joints::{AngleTie, Drive, Guide, Hinge, Pin, Slider};
pub use kkt::Unsolvable;
pub use load::{Couple, Load, Spring, Torsion};
pub use motion::Motion;
pub use rows::Row;
pub use state::{Anchor, State};
pub use support::{Contact, Support};
