//! The functions of a [`Tree`], each by one pass out from the ground or in from the leaves: their
//! length grows as the number of bodies.
//!
//! In all of them a is the acceleration of the point that a body turns about, less that of free
//! fall; ω and α are the body's angular velocity and acceleration, p its first moment and I its
//! moment of inertia about that point, e reaches from it to the point where a further body begins,
//! and v⊥ is v turned by a right angle.

mod energy;
mod factors;
mod geometry;
mod inverse;
mod joints;
mod mass;
mod recursion;
mod vector;

pub use mass::Paths;

pub(super) use energy::{energy, momenta, points};
pub(super) use geometry::TreeGeometry;
pub(super) use inverse::Inverse;
pub(super) use joints::joints;
pub(super) use mass::paths;
pub use recursion::accelerations as recursion;
