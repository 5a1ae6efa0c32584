//! What the data say of the variables: by the singular values of Ĵ, whose columns are those of J
//! made units,
//!
//! ```text
//! J = Ĵ N,    Ĵ = U Σ Vᵀ,    (JᵀJ)⁻¹ = N⁻¹ V Σ⁻² Vᵀ N⁻¹
//! ```

use nalgebra::{DMatrix, DVector};

use super::trial::Trial;
use super::{Datum, Fit, FitError};
use crate::numeric::student::two_sided_quantile;

/// The part of estimates that is to lie within their interval.
const CONFIDENCE: f64 = 0.95;
/// A variable of its own size that changes what is measured by less than this part of it does not
/// change it: some hundred times the error of a derivative.
const NO_CHANGE: f64 = 1e-10;
/// Columns that depend on each other up to this are dependent: the same error, and its square in
/// JᵀJ beside rounding.
const DEPENDENT: f64 = 1e-7;
/// Columns of J and residuals whose cosine is below this are orthogonal: a search ends where it is
/// below 1e-5, the root of its tolerance.
const ORTHOGONAL: f64 = 1e-3;
/// A variable of its own size that changes less than this part of what is computed leads nowhere:
/// its derivative vanishes there.
const SLIGHT: f64 = 1e-2;
/// Residuals below this part of what is measured are those of runs, a thousand times over.
const RUN_ERROR: f64 = 1e-8;
/// Variables with less than this part in a change that changes nothing have no part in it.
const NO_PART: f64 = 1e-3;

/// A variable as the data have it.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// As users write it.
    pub name: String,
    /// The value, in SI units.
    pub value: f64,
    /// Its standard error; none without a degree of freedom.
    pub standard_error: Option<f64>,
    /// The interval that has the true value with a probability of 95 %.
    pub interval: Option<[f64; 2]>,
}

/// Estimates with their correlations, given s.
pub(super) fn estimates(
    fit: &Fit<'_>,
    best: &Trial,
    jacobian: &DMatrix<f64>,
    scatter: Option<f64>,
) -> Result<(Vec<Estimate>, Vec<Vec<f64>>), FitError> {
    let inverse = inverse(fit, best, jacobian)?;
    let n = fit.variables.len();
    let freedom = fit.data.len() - n;
    let quantile = (freedom > 0).then(|| two_sided_quantile(CONFIDENCE, freedom));
    let estimate = |k: usize| {
        let value = best.values[k];
        let standard_error = scatter.map(|scatter| scatter * inverse[(k, k)].sqrt());
        let half = quantile.zip(standard_error).map(|(t, error)| t * error);
        let interval = half.map(|half| [value - half, value + half]);
        Estimate { name: fit.variables[k].name.clone(), value, standard_error, interval }
    };
    let correlation = |i: usize, k: usize| inverse[(i, k)] / (inverse[(i, i)] * inverse[(k, k)]).sqrt();
    let correlations = (0..n).map(|i| (0..n).map(|k| correlation(i, k)).collect());
    Ok(((0..n).map(estimate).collect(), correlations.collect()))
}

/// Whether the residuals are more than the errors of runs, and a change of one variable makes them
/// less to first order: there is no minimum.
pub(super) fn is_held_up(fit: &Fit<'_>, best: &Trial, jacobian: &DMatrix<f64>) -> bool {
    let residuals = &best.residuals;
    let norm = residuals.norm();
    let computed = fit.data.iter().zip(&best.computed).map(|(datum, y)| y / datum.deviation);
    let computed = DVector::from_iterator(fit.data.len(), computed).norm();
    let leads_on = |k: usize| {
        let column = jacobian.column(k);
        let changes = column.norm();
        column.dot(residuals).abs() > ORTHOGONAL * changes * norm
            && changes * fit.variables[k].unit > SLIGHT * computed
    };
    norm > RUN_ERROR * size(fit, best) && (0..fit.variables.len()).any(leads_on)
}

/// The norm of what is computed and measured, in standard deviations.
fn size(fit: &Fit<'_>, best: &Trial) -> f64 {
    let larger = |(datum, y): (&Datum, &f64)| y.abs().max(datum.value.abs()) / datum.deviation;
    DVector::from_iterator(fit.data.len(), fit.data.iter().zip(&best.computed).map(larger)).norm()
}

/// (JᵀJ)⁻¹; or which variables the data do not determine.
fn inverse(fit: &Fit<'_>, best: &Trial, jacobian: &DMatrix<f64>) -> Result<DMatrix<f64>, FitError> {
    let n = fit.variables.len();
    let named = |undetermined: &dyn Fn(usize) -> bool| {
        let names = (0..n).filter(|&k| undetermined(k)).map(|k| fit.variables[k].name.clone());
        FitError::Undetermined(names.collect())
    };
    let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    let changes = |k: usize| norms[k] * fit.variables[k].unit;
    let largest = (0..n).map(changes).fold(size(fit, best), f64::max);
    if let Some(k) = (0..n).find(|&k| changes(k) <= NO_CHANGE * largest) {
        return Err(named(&|i| i == k));
    }
    let unit = DMatrix::from_fn(jacobian.nrows(), n, |i, k| jacobian[(i, k)] / norms[k]);
    let decomposed = unit.svd(false, true);
    let along = decomposed.v_t.unwrap_or_else(|| DMatrix::identity(n, n));
    let values = decomposed.singular_values;
    if let Some(row) = (0..n).find(|&row| values[row] <= DEPENDENT * values.max()) {
        return Err(named(&|k| along[(row, k)].abs() > NO_PART));
    }
    let entry = |i: usize, k: usize| -> f64 {
        let term = |row: usize| along[(row, i)] * along[(row, k)] / (values[row] * values[row]);
        (0..n).map(term).sum::<f64>() / (norms[i] * norms[k])
    };
    Ok(DMatrix::from_fn(n, n, entry))
}
