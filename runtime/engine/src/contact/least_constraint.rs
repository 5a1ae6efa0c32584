//! Gauss's principle of least constraint: of all accelerations that the contacts allow, the motion
//! takes those nearest to the free ones,
//!
//! ```text
//! ½ (a − a°)ᵀ M (a − a°) → min,    M a° = f,    J a + b = 0 (two-sided),    J a + b ≥ 0 (one-sided)
//! ```
//!
//! whose multipliers are the reactions, `0 ≤ J a + b ⟂ λ ≥ 0`. Solved by the dual active set method
//! of Goldfarb and Idnani (*A numerically stable dual method for solving strictly convex quadratic
//! programs*, Math. Programming 27, 1983): the most violated contact is closed, those whose
//! reaction would turn negative on the way are opened. The contacts it ends with are independent of
//! each other whatever the number of redundant ones: a bearing basis.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::active_rows::ActiveRows;
use super::trials::LcpError;

/// Inertia given to motions without any, in units of the others: a light body stands for a massless
/// one. Which contacts bear then is checked with the equations themselves.
const LIGHT: f64 = 1e-8;
/// Openings that dependent contacts cannot agree on are no contradiction up to this, relative to
/// their terms.
const AGREED: f64 = 1e-9;
/// Contacts opened and closed at most, for each contact and coordinate there is: a bound on what
/// rounding can make of a finite method.
const CHANGES: usize = 50;

/// The problem in coordinates in which M is the identity, `z = Lᵀ a` with `M = L Lᵀ`.
pub(super) struct LeastConstraint {
    /// Columns of L⁻¹ Jᵀ, each divided by its length.
    normals: Vec<DVector<f64>>,
    /// b in units of those lengths.
    bias: Vec<f64>,
    /// What an opening may fall short by, in those units.
    slack: Vec<f64>,
    /// z without any contact.
    free: DVector<f64>,
}

/// The rows that bear so far.
struct Bearing {
    active: ActiveRows,
    /// λ of each, in units of the lengths; of two-sided ones, which come first, without meaning.
    multipliers: Vec<f64>,
    two_sided: usize,
    z: DVector<f64>,
    changes: usize,
}

impl LeastConstraint {
    /// Of a balanced problem: M has ones on its diagonal, or zeros where there is no inertia.
    pub(super) fn new(
        mass: &DMatrix<f64>,
        jacobian: &DMatrix<f64>,
        (force, bias): (&DVector<f64>, &DVector<f64>),
        slack: &DVector<f64>,
    ) -> Result<Self, LcpError> {
        let lower = factor(mass).ok_or(LcpError::Singular)?;
        let solve = |right: DVector<f64>| lower.solve_lower_triangular(&right).ok_or(LcpError::Singular);
        let rows = 0..jacobian.nrows();
        let columns: Vec<_> =
            rows.map(|row| solve(jacobian.row(row).transpose())).collect::<Result<_, _>>()?;
        let units: Vec<f64> =
            columns.iter().map(|y| if y.norm() > 0.0 { 1.0 / y.norm() } else { 1.0 }).collect();
        let in_units = |values: &DVector<f64>| values.iter().zip(&units).map(|(x, unit)| x * unit).collect();
        Ok(Self {
            normals: columns.iter().zip(&units).map(|(y, unit)| y * *unit).collect(),
            bias: in_units(bias),
            slack: in_units(slack),
            free: solve(force.clone())?,
        })
    }

    /// Independent rows that bear all of the load: of the `fixed` ones, which may pull, and of the
    /// candidates.
    pub(super) fn find_active_basis(
        &self,
        fixed: &[usize],
        candidates: &[usize],
    ) -> Result<Vec<usize>, LcpError> {
        let mut bearing = self.begin(fixed, candidates.len());
        let mut agreed = vec![false; candidates.len()];
        loop {
            let excess = |k: &usize| self.opening(candidates[*k], &bearing.z) + self.slack[candidates[*k]];
            let asked = (0..candidates.len())
                .filter(|k| !agreed[*k] && !bearing.active.rows.contains(&candidates[*k]));
            let worst = asked.min_by(|a, b| excess(a).total_cmp(&excess(b)));
            let Some(worst) = worst.filter(|k| excess(k) < 0.0) else { return Ok(bearing.active.rows) };
            agreed[worst] = !self.close(&mut bearing, candidates[worst])?;
        }
    }

    /// Independent ones of some rows, the first that are.
    pub(super) fn independent(&self, rows: &[usize]) -> Vec<usize> {
        let mut active = ActiveRows::default();
        for &row in rows {
            active.push(row, &self.normals[row]);
        }
        active.rows
    }

    /// Unit normals of some rows that can move, without what two-sided rows take of them.
    pub(super) fn free_directions(&self, fixed: &[usize], rows: &[usize]) -> Vec<(usize, DVector<f64>)> {
        let mut held = ActiveRows::default();
        for &row in fixed {
            held.push(row, &self.normals[row]);
        }
        let splits = rows.iter().map(|&row| (row, held.split(&self.normals[row])));
        let movable = splits.filter(|(_, split)| !split.depends());
        movable.map(|(row, split)| (row, split.independent.normalize())).collect()
    }

    /// Two-sided rows closed; those that depend on others hold with them or contradict them, which
    /// the equations tell.
    fn begin(&self, fixed: &[usize], candidates: usize) -> Bearing {
        let (mut active, mut z) = (ActiveRows::default(), self.free.clone());
        for &row in fixed {
            let split = active.split(&self.normals[row]);
            if active.push(row, &self.normals[row]) {
                let step = -self.opening(row, &z) / split.independent.norm_squared();
                z.axpy(step, &split.independent, 1.0);
            }
        }
        let two_sided = active.rows.len();
        let changes = CHANGES * (candidates + z.len() + 1);
        Bearing { active, multipliers: vec![0.0; two_sided], two_sided, z, changes }
    }

    fn opening(&self, row: usize, z: &DVector<f64>) -> f64 {
        self.normals[row].dot(z) + self.bias[row]
    }

    /// Raises the reaction of a violated row until it opens no more, opening others whose reactions
    /// vanish on the way. False if the row depends on others that bear, which it agrees with up to
    /// rounding.
    fn close(&self, bearing: &mut Bearing, row: usize) -> Result<bool, LcpError> {
        let mut own = 0.0;
        loop {
            bearing.changes = bearing.changes.checked_sub(1).ok_or(LcpError::Singular)?;
            let split = bearing.active.split(&self.normals[row]);
            let fall = bearing.active.combination(&split);
            let blocking = bearing.first_to_vanish(&fall);
            let opening = self.opening(row, &bearing.z);
            let full = (!split.depends()).then(|| -opening / split.independent.norm_squared());
            let step = match (full, blocking) {
                (Some(full), Some((_, least))) => full.min(least),
                (Some(full), None) => full,
                (None, Some((_, least))) => least,
                (None, None) if -opening <= AGREED * self.size(row, &bearing.z) => return Ok(false),
                (None, None) => return Err(LcpError::Jammed),
            };
            own += step;
            bearing
                .multipliers
                .iter_mut()
                .zip(&fall)
                .for_each(|(multiplier, fall)| *multiplier -= step * fall);
            if full.is_some() {
                bearing.z.axpy(step, &split.independent, 1.0);
            }
            match blocking {
                Some((place, least)) if full.is_none_or(|full| least < full) => bearing.open(place),
                _ => {
                    bearing.active.push(row, &self.normals[row]);
                    bearing.multipliers.push(own);
                    return Ok(true);
                }
            }
        }
    }

    /// The size of the terms of an opening.
    fn size(&self, row: usize, z: &DVector<f64>) -> f64 {
        self.normals[row].abs().dot(&z.abs().zip_map(&self.free.abs(), f64::max)) + self.bias[row].abs()
    }
}

impl Bearing {
    /// The one-sided row whose reaction vanishes first as all fall in proportion, and when.
    fn first_to_vanish(&self, fall: &[f64]) -> Option<(usize, f64)> {
        let one_sided = self.two_sided..fall.len();
        let vanishes =
            one_sided.filter(|&k| fall[k] > 0.0).map(|k| (k, self.multipliers[k].max(0.0) / fall[k]));
        vanishes.min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    fn open(&mut self, place: usize) {
        self.active.remove(place);
        self.multipliers.remove(place);
    }
}

/// L of M = L Lᵀ, M with some inertia everywhere.
fn factor(mass: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = mass.nrows();
    let sound =
        |factor: &Cholesky<f64, Dyn>| factor.l_dirty().diagonal().iter().all(|pivot| pivot * pivot > LIGHT);
    let light = || Cholesky::new(mass + DMatrix::identity(n, n) * LIGHT);
    Some(Cholesky::new(mass.clone()).filter(sound).or_else(light)?.l())
}

/// Adds what a group has changed; where it is the only one that has, its value as it is.
pub(super) fn add_change(sum: &DVector<f64>, before: &DVector<f64>, after: &DVector<f64>) -> DVector<f64> {
    DVector::from_fn(
        sum.len(),
        |i, _| {
            if sum[i] == before[i] { after[i] } else { sum[i] + (after[i] - before[i]) }
        },
    )
}
