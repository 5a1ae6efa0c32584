//! Near a symmetric position every motion is a symmetric and an antisymmetric one, neither of which
//! excites the other. With the mirror image Π δq of a displacement δq = Z ξ
//!
//! ```text
//! Π Z = Z Πξ,   Πξ² = 1,   Πξ V± = ±V±,   ξ = V± η:   η̈ + V±ᵀ C V± η̇ + V±ᵀ K V± η = 0
//! ```

use nalgebra::DMatrix;

use crate::{AnalysisError, Linearisation};

/// What is symmetric is so within this part of natural units: far above the rounding of K and Z.
const SAME: f64 = 1e-9;

/// A linearisation about a symmetric position, in two parts: what keeps its symmetry, and what
/// breaks it.
#[derive(Debug, Clone)]
pub struct BySymmetry {
    /// Of displacements that are their own mirror images.
    pub symmetric: Linearisation,
    /// Of displacements that are opposite to their mirror images.
    pub antisymmetric: Linearisation,
}

impl BySymmetry {
    /// How many times as fast as the fastest growing symmetric motion the fastest growing
    /// antisymmetric one grows; none where one of them does not grow.
    pub fn growth_ratio(&self) -> Option<f64> {
        let fastest = |part: &Linearisation| part.modes().first().map_or(0.0, crate::Mode::growth);
        let [symmetric, antisymmetric] = [&self.symmetric, &self.antisymmetric].map(fastest);
        (symmetric > 0.0 && antisymmetric > 0.0).then(|| antisymmetric / symmetric)
    }
}

impl Linearisation {
    /// The same in its symmetric and its antisymmetric part, given Π, one row and one column for
    /// each coordinate.
    ///
    /// # Errors
    /// The position, or the closed contacts, are not symmetric; Π does not fit.
    pub fn by_symmetry(&self, reflection: &DMatrix<f64>) -> Result<BySymmetry, AnalysisError> {
        if self.degrees() == 0 {
            return Ok(BySymmetry { symmetric: self.clone(), antisymmetric: self.clone() });
        }
        let reflected = self.reflected(reflection).ok_or(AnalysisError::Asymmetric)?;
        let eigen = (0.5 * (&reflected + reflected.transpose())).symmetric_eigen();
        let part = |sign: f64| {
            let of_sign = (0..self.degrees()).filter(|&i| sign * eigen.eigenvalues[i] > 0.0);
            self.restricted(&eigen.eigenvectors.select_columns(&of_sign.collect::<Vec<_>>()))
        };
        Ok(BySymmetry { symmetric: part(1.0), antisymmetric: part(-1.0) })
    }

    /// Πξ; none where it is no reflection of these equations.
    fn reflected(&self, reflection: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let n = self.basis.nrows();
        if reflection.shape() != (n, n) || !reflection.iter().chain(&self.basis).all(|x| x.is_finite()) {
            return None;
        }
        let natural = DMatrix::from_fn(n, self.degrees(), |i, j| self.basis[(i, j)] / self.units[i]);
        let images =
            DMatrix::from_fn(n, n, |i, j| reflection[(i, j)] * self.units[j] / self.units[i]) * &natural;
        let reflected = natural.clone().pseudo_inverse(0.0).ok()? * &images;
        let one = DMatrix::identity(self.degrees(), self.degrees());
        let commutes = |of: &DMatrix<f64>, unit: f64| {
            is_near(&(of * &reflected), &(&reflected * of), of.amax().max(unit))
        };
        let is_reflection = is_near(&images, &(&natural * &reflected), natural.amax())
            && is_near(&(&reflected * &reflected), &one, 1.0)
            && commutes(&self.stiffness, self.time.powi(-2))
            && commutes(&self.damping, self.time.recip());
        is_reflection.then_some(reflected)
    }
}

fn is_near(a: &DMatrix<f64>, b: &DMatrix<f64>, size: f64) -> bool {
    a.is_empty() || (a - b).amax() <= SAME * size
}
