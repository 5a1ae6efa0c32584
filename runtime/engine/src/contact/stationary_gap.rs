//! Contacts that touch where their gap is stationary among the positions that the joints allow.
//! Rounding makes of their row, which is zero along the joints, one like any other.
//!
//! - Where the gap is least, as of a bar that hangs down to a floor, it opens along every motion:
//!   the contact holds nothing.
//! - Where it is greatest, as of a bar that stands upright below a thread, the position is the only
//!   one, but no finite reaction holds it: the contact is jammed by what moves the others.
//!
//! With the rows A of the joints, `P` the projector onto `A q̇ = 0` and μ by least squares, these
//! are the second-order conditions of a minimum and of a maximum (Nocedal and Wright, *Numerical
//! Optimization*, theorem 12.6). At a minimum the slope is zero but for what it takes the gap to
//! fall by less than counts as touching, at a maximum but for rounding:
//!
//! ```text
//! s = J − Aᵀμ,   H = P (∂J/∂q − Σ μₖ ∂Aₖ/∂q) P,
//! least: H ≥ 0, |s|² ≤ 2 g₀ |H|,   greatest: H ≤ 0, |s| ≤ ε |H|
//! ```
//!
//! Where H is the rounding of its terms the joints hold the gap: it is neither.

use nalgebra::{DMatrix, DVector};

use super::ContactProblem;
use crate::context::RunContext;
use crate::model::ContactSet;
use crate::numerics::decomposition;
use crate::numerics::zero::{MARGIN, roundoff};
use crate::scalar::Jet;
use crate::system::{Equations, TIME_ORDERS, TimeSeries};

/// A slope up to this part of a natural unit is worth a second derivative.
const SLIGHT: f64 = 1e-3;
/// Singular values below this part of the largest, and negative curvatures, are rounding.
const ROUNDING: f64 = 1e-9;

/// A slope up to this part of the curvature is the rounding of a position, and holds nothing.
const NO_SLOPE: f64 = roundoff(16.0);

/// The touching contacts whose gaps are stationary here.
#[derive(Debug, Default)]
pub(crate) struct StationaryGaps {
    /// Those whose gap is least.
    pub(crate) least: ContactSet,
    /// Those whose gap is greatest, with H in natural units.
    greatest: Vec<(usize, DMatrix<f64>)>,
    /// Those among them whose slope is rounding.
    pub(crate) flat: ContactSet,
}

impl StationaryGaps {
    /// Those of `touching` among the positions that the joints and the held contacts allow. Gaps up
    /// to `closed`, g₀ in natural units, touch.
    pub(crate) fn find(context: &RunContext, state: &[f64], question: &ContactProblem, closed: f64) -> Self {
        let (layout, n) = (context.layout(), context.layout().coordinates.len());
        let ContactProblem { touching, held, .. } = *question;
        if touching.is_empty() || n == 0 {
            return Self::default();
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
        let Some(derivatives) = (!slight.is_empty()).then(|| Derivatives::new(context, state)).flatten()
        else {
            return Self::default();
        };
        let mut allowed = DMatrix::identity(n, n);
        for (normal, _) in
            svd.u.iter().flat_map(|u| u.column_iter().zip(&svd.singular_values)).filter(|(_, s)| **s > cutoff)
        {
            allowed -= normal * normal.transpose();
        }
        let mut found = Self::default();
        for (i, multipliers, slope) in slight.into_iter().filter(|(i, ..)| derivatives.is_constant(*i)) {
            let own = derivatives.hessian(i, unit);
            let size = own.amax();
            let of_joints = fixed.iter().zip(&multipliers).map(|(&k, mu)| *mu * derivatives.hessian(k, unit));
            let (whole, terms) = of_joints.fold((own, size), |(sum, terms), joint| {
                let size = joint.amax();
                (sum - joint, terms.max(size))
            });
            let unit = layout.unit(i, context.scales.length);
            let (hessian, terms) = (&allowed * (whole / unit) * &allowed, terms / unit);
            let curvature = hessian.amax();
            // The joints leave the gap no motion at all: it depends on what they hold.
            if curvature <= ROUNDING * terms {
                continue;
            }
            let rounding = ROUNDING * curvature * DMatrix::identity(n, n);
            let may_fall = slope * slope <= 2.0 * closed * curvature && slope <= SLIGHT * curvature;
            if may_fall && (&hessian + &rounding).cholesky().is_some() {
                found.least = found.least.with(i);
            } else if slope <= ROUNDING * curvature && (rounding - &hessian).cholesky().is_some() {
                if slope <= NO_SLOPE * curvature {
                    found.flat = found.flat.with(i);
                }
                found.greatest.push((i, hessian));
            }
        }
        found
    }

    /// Those whose gap is greatest.
    pub(crate) fn greatest(&self) -> ContactSet {
        self.greatest.iter().map(|(i, _)| *i).collect()
    }

    /// Those whose gap falls, the greatest here, in the motion with these accelerations: q̇ᵀHq̇, or
    /// from rest q̈ᵀHq̈, is negative.
    pub(crate) fn find_jammed(
        &self,
        context: &RunContext,
        state: &[f64],
        accelerations: &[f64],
    ) -> ContactSet {
        let (layout, n) = (context.layout(), context.layout().coordinates.len());
        let natural = |values: &[f64], time: f64| {
            let unit = |j: usize| context.scales.coordinate(&layout.coordinates[j]) / time;
            DVector::from_fn(n, |j, _| values[j] / unit(j))
        };
        let time = context.scales.time;
        let motions = [natural(&state[n..2 * n], time), natural(accelerations, time * time)];
        let falls = |hessian: &DMatrix<f64>| {
            let along =
                |motion: &DVector<f64>| motion.dot(&(hessian * motion)) < -MARGIN * MARGIN * hessian.amax();
            motions.iter().any(along)
        };
        self.greatest.iter().filter(|(_, hessian)| falls(hessian)).map(|(i, _)| *i).collect()
    }
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
        is_zero(&timed.prescribed_gap_rate()[row])
    }
}
