//! The motion of one contact set near a position at rest:
//!
//! ```text
//! δq = Z ξ,   J Z = 0,   Zᵀ M Z = 1,   ξ̈ = a(ξ, ξ̇)
//! ```
//!
//! In closed form Z = G L⁻ᵀ with G = ∂q/∂r and Gᵀ M G = L Lᵀ, which holds too where rows of J
//! coincide, as those of sin α = sin β at cos α = 0; with multipliers Z spans the null space of J.

use std::sync::Arc;

use liftoff_core::model::{ContactSet, Form};
use liftoff_core::scalar::{DoubleDouble, Real};
use liftoff_core::system::PhaseEquations;
use nalgebra::{DMatrix, DVector};

use crate::{AnalysisError, Subject};

/// A closed form holds where it gives the state back to within this part of natural units.
const SAME: f64 = 1e-7;
/// Rows of J depend on each other below this.
const RANK: f64 = 1e-9;
/// Half the span of differences, in natural units: their error is its square.
const SPAN: f64 = 1e-9;

/// One contact set near a position at rest.
pub(crate) struct Local<'a> {
    subject: &'a Subject,
    phase: Arc<dyn PhaseEquations<DoubleDouble>>,
    /// The reduced state at rest.
    rest: Vec<DoubleDouble>,
    /// δr = into · ξ, of the reduced coordinates.
    into: DMatrix<f64>,
    /// ξ̈ = onto · r̈.
    onto: DMatrix<f64>,
    /// Z.
    pub(crate) basis: DMatrix<f64>,
}

impl<'a> Local<'a> {
    /// Of the contacts of a set, closed at `state`.
    pub(crate) fn new(
        subject: &'a Subject,
        set: ContactSet,
        state: &[DoubleDouble],
    ) -> Result<Self, AnalysisError> {
        let closed = Arc::clone(&subject.system).phase(set, Form::Reduced);
        let info = closed.info();
        if info.form == Form::Reduced && info.coordinates == info.rates {
            let rest = restricted(&*closed, state);
            if let Some(local) = is_image(subject, &*closed, &rest, state)
                .then(|| Self::in_closed_form(subject, &closed, &rest, state))
                .flatten()
            {
                return Ok(local);
            }
        }
        let phase = Arc::clone(&subject.system).phase(set, Form::Multipliers);
        let basis = null_space(subject, set, state).ok_or(AnalysisError::Massless)?;
        let onto = basis.transpose() * mass_of(subject, state);
        Ok(Self { subject, rest: restricted(&*phase, state), phase, into: basis.clone(), onto, basis })
    }

    fn in_closed_form(
        subject: &'a Subject,
        phase: &Arc<dyn PhaseEquations<DoubleDouble>>,
        rest: &[DoubleDouble],
        state: &[DoubleDouble],
    ) -> Option<Self> {
        let info = phase.info();
        let (n, k) = (subject.layout().coordinates.len(), info.rates);
        let mut moves = DMatrix::zeros(n, k);
        for (column, place) in info.places_of_rates().enumerate() {
            let mut moving = rest.to_vec();
            moving[place] = DoubleDouble::from_f64(1.0);
            let full = embedded(subject, &**phase, &moving);
            (0..n).for_each(|i| moves[(i, column)] = full[n + i].hi());
        }
        let mass = moves.transpose() * mass_of(subject, state) * &moves;
        let lower = mass.cholesky()?.l();
        let into = lower.transpose().solve_upper_triangular(&DMatrix::identity(k, k))?;
        let basis = &moves * &into;
        Some(Self {
            subject,
            phase: Arc::clone(phase),
            rest: rest.to_vec(),
            onto: lower.transpose(),
            into,
            basis,
        })
    }

    /// How many coordinates ξ there are.
    pub(crate) fn degrees(&self) -> usize {
        self.into.ncols()
    }

    /// ξ̈ at ξ and ξ̇.
    pub(crate) fn acceleration(&self, [xi, rate]: [&DVector<f64>; 2]) -> Vec<DoubleDouble> {
        let info = self.phase.info();
        let mut y = self.rest.clone();
        let moved = [&self.into * xi, &self.into * rate];
        for (from, moved) in [0, info.coordinates].into_iter().zip(&moved) {
            moved
                .iter()
                .enumerate()
                .for_each(|(i, by)| y[from + i] = y[from + i] + DoubleDouble::from_f64(*by));
        }
        let mut derivative = vec![DoubleDouble::from_f64(0.0); y.len()];
        self.phase.derivative(&y, &mut derivative);
        let rates = &derivative[info.places_of_rates()];
        let row = |i: usize| {
            let terms = rates.iter().enumerate().map(|(j, a)| DoubleDouble::from_f64(self.onto[(i, j)]) * *a);
            terms.fold(DoubleDouble::from_f64(0.0), |sum, term| sum + term)
        };
        (0..self.degrees()).map(row).collect()
    }

    /// ξ̈ at the position itself.
    pub(crate) fn at_rest(&self) -> DVector<f64> {
        let zero = DVector::zeros(self.degrees());
        DVector::from_iterator(
            self.degrees(),
            self.acceleration([&zero, &zero]).into_iter().map(DoubleDouble::hi),
        )
    }

    /// K = −∂ξ̈/∂ξ and C = −∂ξ̈/∂ξ̇.
    pub(crate) fn derivatives(&self) -> [DMatrix<f64>; 2] {
        let unit = self.subject.unit();
        let [xi, rate] = [SPAN * unit, SPAN * unit / self.subject.scales.time];
        [[xi, 0.0], [0.0, rate]].map(|steps| self.slopes(steps))
    }

    fn slopes(&self, steps: [f64; 2]) -> DMatrix<f64> {
        let k = self.degrees();
        let mut slopes = DMatrix::zeros(k, k);
        for column in 0..k {
            let at = |sign: f64| {
                let [xi, rate] = steps.map(|step| {
                    let mut moved = DVector::zeros(k);
                    moved[column] = sign * step;
                    moved
                });
                self.acceleration([&xi, &rate])
            };
            let (ahead, behind) = (at(1.0), at(-1.0));
            let span = 2.0 * (steps[0] + steps[1]);
            (0..k).for_each(|row| slopes[(row, column)] = -(ahead[row] - behind[row]).hi() / span);
        }
        slopes
    }

    /// The full state at ξ, at rest, before the contacts are closed again where there is no closed
    /// form.
    pub(crate) fn state_at(&self, xi: &DVector<f64>) -> Vec<DoubleDouble> {
        let mut y = self.rest.clone();
        let moved = &self.into * xi;
        moved.iter().enumerate().for_each(|(i, by)| y[i] = y[i] + DoubleDouble::from_f64(*by));
        embedded(self.subject, &*self.phase, &y)
    }
}

fn restricted(phase: &dyn PhaseEquations<DoubleDouble>, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
    let mut reduced = vec![DoubleDouble::from_f64(0.0); phase.info().entries];
    phase.restrict(state, &mut reduced);
    reduced
}

fn embedded(
    subject: &Subject,
    phase: &dyn PhaseEquations<DoubleDouble>,
    y: &[DoubleDouble],
) -> Vec<DoubleDouble> {
    let mut state = vec![DoubleDouble::from_f64(0.0); subject.layout().entries()];
    phase.embed(y, &mut state);
    state
}

/// Whether a closed form gives a position back.
fn is_image(
    subject: &Subject,
    phase: &dyn PhaseEquations<DoubleDouble>,
    rest: &[DoubleDouble],
    state: &[DoubleDouble],
) -> bool {
    let image = embedded(subject, phase, rest);
    let coordinates = subject.layout().coordinates.iter().zip(image.iter().zip(state));
    coordinates.into_iter().all(|(c, (image, given))| {
        let unit = subject.scales.coordinate(c).max(given.hi().abs());
        (image.hi() - given.hi()).abs() <= SAME * unit
    })
}

pub(crate) fn mass_of(subject: &Subject, state: &[DoubleDouble]) -> DMatrix<f64> {
    let equations = subject.system.equations(state);
    let n = subject.layout().coordinates.len();
    DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j].hi())
}

/// Z with J Z = 0 and Zᵀ M Z = 1; none where M is singular.
fn null_space(subject: &Subject, set: ContactSet, state: &[DoubleDouble]) -> Option<DMatrix<f64>> {
    let layout = subject.layout();
    let n = layout.coordinates.len();
    let lower = mass_of(subject, state).cholesky()?.l();
    let back = lower.transpose().solve_upper_triangular(&DMatrix::identity(n, n))?;
    let equations = subject.system.equations(state);
    let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
    // As many rows as columns, so that all right singular vectors are there.
    let mut jacobian = DMatrix::zeros(rows.len().max(n), n);
    for (i, &row) in rows.iter().enumerate() {
        (0..n).for_each(|j| jacobian[(i, j)] = equations.jacobian(row)[j].hi());
        let own = (jacobian.row(i) * &back).norm();
        jacobian.row_mut(i).unscale_mut(if own > 0.0 { own } else { 1.0 });
    }
    let svd = (jacobian * &back).svd(false, true);
    let right = svd.v_t?;
    let free: Vec<usize> = (0..n).filter(|&k| svd.singular_values[k] <= RANK).collect();
    Some(back * right.select_rows(&free).transpose())
}
