//! Linearised motion about a position at rest:
//!
//! ```text
//! δq = Z ξ,   ξ̈ + C ξ̇ + K ξ = ξ̈₀
//! ```
//!
//! with ξ̈₀ = 0 at an equilibrium. The loads of the contacts are in K: it is the Hessian of V + λᵀ
//! g on their tangent space.

use liftoff_core::model::ContactSet;
use nalgebra::{DMatrix, DVector};

use crate::local::Local;
use crate::mode::{self, Mode};
use crate::{AnalysisError, Subject};

/// The equations of a contact set, linearised about a position at rest.
#[derive(Debug, Clone)]
pub struct Linearisation {
    pub(crate) basis: DMatrix<f64>,
    pub(crate) stiffness: DMatrix<f64>,
    pub(crate) damping: DMatrix<f64>,
    residual: DVector<f64>,
    /// The natural time.
    pub(crate) time: f64,
    /// The unit of each coordinate.
    pub(crate) units: Vec<f64>,
    unit: f64,
}

impl Linearisation {
    /// About the position of the subject, with these contacts closed.
    ///
    /// # Errors
    /// The mass matrix is singular, or the equations depend on the time.
    pub fn compute(subject: &Subject, closed: ContactSet) -> Result<Self, AnalysisError> {
        subject.refuse_unsuited()?;
        Ok(Self::from_local(subject, &Local::new(subject, closed, &subject.state)?))
    }

    pub(crate) fn from_local(subject: &Subject, local: &Local<'_>) -> Self {
        let [stiffness, damping] = local.derivatives();
        let coordinates = subject.layout().coordinates;
        Self {
            basis: local.basis.clone(),
            stiffness,
            damping,
            residual: local.at_rest(),
            time: subject.scales.time,
            units: coordinates.iter().map(|c| subject.scales.coordinate(c)).collect(),
            unit: subject.unit(),
        }
    }

    /// Of the displacements ξ = V η alone, which have no accelerations but such; the columns of V
    /// are orthonormal.
    pub(crate) fn restricted(&self, to: &DMatrix<f64>) -> Self {
        let across = |matrix: &DMatrix<f64>| to.transpose() * matrix * to;
        Self {
            basis: &self.basis * to,
            stiffness: across(&self.stiffness),
            damping: across(&self.damping),
            residual: to.transpose() * &self.residual,
            units: self.units.clone(),
            ..*self
        }
    }

    /// Degrees of freedom k.
    pub fn degrees(&self) -> usize {
        self.stiffness.nrows()
    }

    /// Z, one row for each coordinate, k columns: δq = Z ξ with Zᵀ M Z = 1. Where inputs are
    /// generalised forces Q, ξ̈ has Zᵀ Q.
    pub fn basis(&self) -> &DMatrix<f64> {
        &self.basis
    }

    /// K, 1/s².
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// C, 1/s.
    pub fn damping(&self) -> &DMatrix<f64> {
        &self.damping
    }

    /// A of ẋ = A x + B Q with x = (ξ, ξ̇): 2k × 2k.
    pub fn state_matrix(&self) -> DMatrix<f64> {
        let k = self.degrees();
        let mut matrix = DMatrix::zeros(2 * k, 2 * k);
        matrix.view_mut((0, k), (k, k)).fill_with_identity();
        matrix.view_mut((k, 0), (k, k)).copy_from(&-&self.stiffness);
        matrix.view_mut((k, k), (k, k)).copy_from(&-&self.damping);
        matrix
    }

    /// B, one column for the generalised force of each coordinate.
    pub fn input_matrix(&self) -> DMatrix<f64> {
        let k = self.degrees();
        let mut matrix = DMatrix::zeros(2 * k, self.basis.nrows());
        matrix.view_mut((k, 0), (k, self.basis.nrows())).copy_from(&self.basis.transpose());
        matrix
    }

    /// How large the acceleration at the position is, in natural units: zero at an equilibrium.
    pub fn residual(&self) -> f64 {
        self.residual.amax() * self.time * self.time / self.unit
    }

    /// Modes of vibration, the fastest growing first, then the slowest.
    pub fn modes(&self) -> Vec<Mode> {
        mode::compute_modes([&self.stiffness, &self.damping], self.time)
            .into_iter()
            .map(|(rate, shape)| Mode::new(rate, &self.basis.map(mode::real), &shape, &self.units))
            .collect()
    }
}
