//! Joints of a chain on the way of their elimination.

use super::plane::{Matrix, Symmetric, Vector};

/// X and β of a joint.
#[derive(Clone, Copy)]
pub(super) struct Joint<S> {
    pub(super) compliance: Symmetric<S>,
    pub(super) parting: Vector<S>,
}

/// X⁻¹Y and X⁻¹β of an eliminated joint.
pub(super) struct Eliminated<S> {
    pub(super) carried: Matrix<S>,
    pub(super) own: Vector<S>,
}
