//! Joints of a chain on the way of their elimination.

use super::plane::{Matrix, PlaneVector, Symmetric};

/// X and β of a joint.
#[derive(Clone, Copy)]
pub(super) struct JointCompliance<S> {
    pub(super) compliance: Symmetric<S>,
    pub(super) parting: PlaneVector<S>,
}

/// X⁻¹Y and X⁻¹β of an eliminated joint.
pub(super) struct Eliminated<S> {
    pub(super) carried: Matrix<S>,
    pub(super) own: PlaneVector<S>,
}
