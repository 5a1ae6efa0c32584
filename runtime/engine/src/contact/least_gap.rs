//! Contacts that touch where their gap is least: the end of a bar that hangs down to a floor. Along
//! every motion that the joints allow such a gap opens, so that the contact holds nothing, while
//! rounding makes of its row, which is zero there, one like any other.
//!
//! With the rows A of the joints, `P` the projector onto `A q̇ = 0` and μ by least squares, this is
//! the second-order condition of a minimum (Nocedal and Wright, *Numerical Optimization*, theorem
//! 12.6), its slope zero but for what it takes the gap to fall by less than counts as touching:
//!
//! ```text
//! s = J − Aᵀμ,   H = P (∂J/∂q − Σ μₖ ∂Aₖ/∂q) P ≥ 0,   |s|² ≤ 2 g₀ |H|
//! ```

use nalgebra::{DMatrix, DVector};

use super::ContactProblem;
use crate::decomposition;
use crate::integration::phase_point::RunContext;
use crate::model::ContactSet;
use crate::scalar::Jet;
use crate::system::{Equations, TIME_ORDERS, TimeSeries};

/// A slope up to this part of a natural unit is worth a second derivative.
const SLIGHT: f64 = 1e-3;
/// Singular values below this part of the largest, and negative curvatures, are rounding.
const ROUNDING: f64 = 1e-9;

/// The touching contacts whose gap is least here among the positions that the joints and the held
/// contacts allow. Gaps up to `closed`, g₀ in natural units, touch.
pub(crate) fn find_least_gaps(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
    closed: f64,
) -> ContactSet {
    let (layout, n) = (context.layout(), context.layout().coordinates.len());
    let ContactProblem { touching, held, .. } = *question;
    if touching.is_empty() || n == 0 {
        return ContactSet::EMPTY;
    }
    let equations = context.system().equations(state);
    let unit = |j: usize| context.scales.coordinate(&layout.coordinates[j]);
    let row = |i: usize| DVector::from_fn(n, |j, _| equations.jacobian(i)[j] * unit(j));
    let contacts = layout.contacts.len();
    let fixed: Vec<usize> = held.iter().chain(contacts..contacts + layout.joints.len()).collect();
    let mut normals = DMatrix::zeros(n, fixed.len().max(1));
    fixed.iter().enumerate().for_each(|(k, &i)| normals.set_column(k, &row(i)));
    let svd = decomposition::svd(normals.clone());
    let cutoff = ROUNDING * svd.singular_values.amax();
    // The gap of a contact along the joints: μ, and s in natural units.
    let along = |i: usize| {
        let multipliers = svd.solve(&row(i), cutoff).ok()?;
        let slope = (row(i) - &normals * &multipliers).norm() / layout.unit(i, context.scales.length);
        (slope < SLIGHT).then_some((i, multipliers, slope))
    };
    let slight: Vec<_> = touching.iter().filter_map(along).collect();
    let Some(derivatives) = (!slight.is_empty()).then(|| Derivatives::new(context, state)).flatten() else {
        return ContactSet::EMPTY;
    };
    let mut allowed = DMatrix::identity(n, n);
    for (normal, _) in
        svd.u.iter().flat_map(|u| u.column_iter().zip(&svd.singular_values)).filter(|(_, s)| **s > cutoff)
    {
        allowed -= normal * normal.transpose();
    }
    let is_least = |(i, multipliers, slope): &(usize, DVector<f64>, f64)| {
        let own = derivatives.hessian(*i, unit);
        let of_joints = fixed.iter().zip(multipliers).map(|(&k, mu)| *mu * derivatives.hessian(k, unit));
        let hessian = of_joints.fold(own, |sum, joint| sum - joint) / layout.unit(*i, context.scales.length);
        let hessian = &allowed * hessian * &allowed;
        let curvature = hessian.amax();
        let opens = (hessian + ROUNDING * curvature * DMatrix::identity(n, n)).cholesky().is_some();
        let is_slight = slope * slope <= 2.0 * closed * curvature && *slope <= SLIGHT * curvature;
        opens && is_slight && derivatives.is_constant(*i)
    };
    slight.into_iter().filter(is_least).map(|(i, ..)| i).collect()
}

/// Rows of the equations along motions through a state: of each coordinate alone, and of the time.
struct Derivatives {
    along: Vec<Equations<TimeSeries>>,
}

impl Derivatives {
    fn new(context: &RunContext, state: &[f64]) -> Option<Self> {
        let (layout, n) = (context.layout(), context.layout().coordinates.len());
        let series = |moving: usize| -> Vec<TimeSeries> {
            let rate = |entry: usize| match moving {
                k if k < n => u8::from(entry == k).into(),
                _ => layout.slope(entry) as f64,
            };
            let value = |(entry, &value): (usize, &f64)| {
                let mut coefficients = [0.0; TIME_ORDERS];
                (coefficients[0], coefficients[1]) = (value, rate(entry));
                Jet::new(coefficients)
            };
            state.iter().enumerate().map(value).collect()
        };
        let along = (0..=n).map(|moving| context.model.series.equations(&series(moving)));
        Some(Self { along: along.collect::<Option<_>>()? })
    }

    /// ∂²g/∂qⱼ∂qₖ of a row, in units of the coordinates.
    fn hessian(&self, row: usize, unit: impl Fn(usize) -> f64) -> DMatrix<f64> {
        let n = self.along.len() - 1;
        let entry = |j: usize, k: usize| self.along[k].jacobian(row)[j].coefficient(1) * unit(j) * unit(k);
        DMatrix::from_fn(n, n, entry)
    }

    /// Whether the gap of a row does not depend on time.
    fn is_constant(&self, row: usize) -> bool {
        let timed = self.along.last().expect("one along the time");
        let is_zero = |x: &TimeSeries| (0..TIME_ORDERS).all(|order| x.coefficient(order) == 0.0);
        is_zero(&timed.drift()[row])
    }
}
