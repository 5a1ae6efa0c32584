//! A mirrored model with both of its halves.

use liftoff_interpreter::Interpreted;
use nalgebra::DMatrix;

use super::{Entry, MotionError};
use crate::explain::{Halves, halves};
use crate::run_spec::{RunSpec, Values};

/// Both halves of a mirrored model, each of which moves by itself.
pub struct Unfolded {
    model: Entry,
    halves: Halves,
}

impl Entry {
    /// Both halves of a mirrored model, interpreted: no compiler has seen them. Its default run has
    /// the parameters of this one.
    ///
    /// # Errors
    /// It has no mirror, or both halves are no model.
    pub fn unfolded(&self) -> Result<Unfolded, MotionError> {
        let halves = halves(self.layout()).map_err(MotionError::Input)?;
        let run = RunSpec { parameters: self.default_run().parameters, ..RunSpec::default() };
        let model = Self::interpreted(Interpreted::from_analysis(&halves.analysis)).with_default_run(run);
        Ok(Unfolded { model, halves })
    }
}

impl Unfolded {
    /// The model of both halves. Coordinates of the mirrored model keep their names; the image of
    /// `phi` is `phi_image`.
    pub fn model(&self) -> &Entry {
        &self.model
    }

    /// All coordinates of a symmetric position, given those of the mirrored model in the order of
    /// its layout.
    ///
    /// # Errors
    /// Parameters that it does not have, or that are not given.
    pub fn position(&self, parameters: &Values, mirrored: &[f64]) -> Result<Values, MotionError> {
        let parameters = self.model.model(parameters)?.parameters;
        let names = self.model.layout().coordinates.iter().map(|coordinate| coordinate.name.to_owned());
        Ok(names.zip(self.halves.position(&parameters, mirrored)).collect())
    }

    /// Π: the mirror image of a displacement δq from a symmetric position, as joints allow it, is Π
    /// δq.
    ///
    /// # Errors
    /// Parameters that it does not have, or that are not given.
    pub fn reflection(&self, parameters: &Values, position: &[f64]) -> Result<DMatrix<f64>, MotionError> {
        let rows = self.halves.reflection(&self.model.model(parameters)?.parameters, position);
        Ok(DMatrix::from_row_iterator(rows.len(), rows.len(), rows.into_iter().flatten()))
    }
}
