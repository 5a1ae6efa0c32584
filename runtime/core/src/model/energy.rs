//! Energies of a motion.

/// Kinetic and potential energy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Energy<S> {
    /// T.
    pub kinetic: S,
    /// V.
    pub potential: S,
}

impl Energy<f64> {
    /// What the sum has gained since another; the parts are compared first, so that large ones do
    /// not hide it.
    pub fn gained_since(&self, before: &Self) -> f64 {
        (self.kinetic - before.kinetic) + (self.potential - before.potential)
    }
}
