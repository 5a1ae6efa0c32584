//! The surface that starts on a section lie on: joints and touching contacts hold positions, joints
//! and closed contacts rates too,
//!
//! ```text
//! c(x, p) = 0:   g = 0,   ġ = J u + ∂g/∂t = 0,   v = 0 of what sticks,   h = 0 of a section h > 0, h < 0 or h = 0
//! ```
//!
//! with x = (q, u) in natural units. Its tangent space is spanned by T with ∂c/∂x T = 0 and Tᵀ T =
//! 1, what drifts left out; with a parameter it moves by −(∂c/∂x)⁺ ∂c/∂p.

use liftoff::Scales;
use liftoff_core::model::Layout;
use liftoff_core::scalar::{Dual4, Real};
use liftoff_core::system::{Equations, ModelOn};
use nalgebra::{DMatrix, DVector};

use super::{OrbitError, ReturnMap};
use crate::SensitivityError;
use crate::sensitivity::{Direction, WIDTH, moved, parameters};

/// Gaps and rates below this, in natural units, are zero: events are located far more closely.
const CLOSED: f64 = 1e-8;
/// Singular values below this, relative to the largest, are zero.
const RANK: f64 = 1e-9;
/// Corrections of Gauss and Newton, each of which squares the error.
const CORRECTIONS: usize = 4;

/// What is held: a row of the kernel, or the section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Held {
    Gap(usize),
    Rate(usize),
    Section,
}

/// A state on the surface, and the surface near it.
pub(super) struct Surface {
    pub(super) state: Vec<f64>,
    /// T, one column for each direction, in natural units.
    pub(super) basis: DMatrix<f64>,
    /// ∂x/∂p of the surface, in natural units.
    pub(super) motion: DVector<f64>,
    held: Vec<Held>,
    /// Whether the flow leaves it: a touching contact opens.
    pub(super) is_left: bool,
}

impl Surface {
    /// Whether it lies in the section, and the flow leaves it.
    pub(super) fn holds_section(&self) -> bool {
        self.held.contains(&Held::Section)
    }
}

impl ReturnMap<'_> {
    /// The surface through the point nearest to a state, with what touches there, or after a step
    /// from another with what touched there: along its tangent contacts stay closed to first order
    /// only.
    pub(super) fn surface(
        &self,
        at: &OrbitParameters,
        state: &[f64],
        from: Option<&Surface>,
    ) -> Result<Surface, OrbitError> {
        let held = from.map_or_else(|| self.held(at, state), |from| Ok(from.held.clone()))?;
        let mut state = state.to_vec();
        let mut constraints = self.constraints(at, &state, &held)?;
        for _ in 0..CORRECTIONS {
            let change = solve(&constraints.slopes, &-&constraints.values);
            state.iter_mut().zip(&change).zip(&at.units).for_each(|((x, by), unit)| *x += by * unit);
            constraints = self.constraints(at, &state, &held)?;
            if change.amax() <= f64::EPSILON {
                break;
            }
        }
        let is_left = held.iter().any(|row| matches!(row, Held::Gap(i) if !held.contains(&Held::Rate(*i))));
        let motion = solve(&constraints.slopes, &-&constraints.by_parameter);
        Ok(Surface { basis: null_space(&constraints.slopes, &self.drifting), motion, held, state, is_left })
    }

    fn held(&self, at: &OrbitParameters, state: &[f64]) -> Result<Vec<Held>, OrbitError> {
        let model = (self.model)(&parameters(&at.parameters, &[])).map_err(SensitivityError::Model)?;
        let layout = model.system.layout();
        let (contacts, joints) = (layout.contacts.len(), layout.joints.len());
        let state = full(layout, moved(state, &[]));
        let equations = model.system.equations(&state);
        let value = |row: Held| {
            let value = row.evaluate(&equations, &state).map_or(0.0, |value| value.value());
            (value * at.natural(layout, row)).abs() <= CLOSED
        };
        let mut held = Vec::new();
        for row in 0..contacts + joints {
            let is_joint = row >= contacts;
            if is_joint || !layout.contacts[row].is_hinge() && value(Held::Gap(row)) {
                held.push(Held::Gap(row));
                held.extend((is_joint || value(Held::Rate(row))).then_some(Held::Rate(row)));
            }
        }
        for row in contacts + joints..layout.rows() {
            let closed = layout.contact_of(row).is_none_or(|contact| held.contains(&Held::Rate(contact)));
            held.extend((closed && value(Held::Rate(row))).then_some(Held::Rate(row)));
        }
        held.extend(self.section.height(&model, &state).map(|_| Held::Section));
        Ok(held)
    }

    /// c with its derivatives, all in natural units.
    fn constraints(
        &self,
        at: &OrbitParameters,
        state: &[f64],
        held: &[Held],
    ) -> Result<Constraints, OrbitError> {
        let directions: Vec<Direction> = at.directions(state.len());
        let mut values = DVector::zeros(held.len());
        let mut slopes = DMatrix::zeros(held.len(), directions.len());
        for (chunk, four) in directions.chunks(WIDTH).enumerate() {
            let model = (self.model)(&parameters(&at.parameters, four)).map_err(SensitivityError::Model)?;
            let model: &ModelOn<Dual4> = &model;
            let layout = model.system.layout();
            let state = full(layout, moved(state, four));
            let equations = model.system.equations(&state);
            for (i, row) in held.iter().enumerate() {
                let value = row.evaluate(&equations, &state).or_else(|| self.section.height(model, &state));
                let value = value.unwrap_or(Dual4::constant(0.0));
                let scale = at.natural(layout, *row);
                values[i] = value.value() * scale;
                for (k, slope) in value.gradient().iter().enumerate().take(four.len()) {
                    slopes[(i, chunk * WIDTH + k)] = slope * scale;
                }
            }
        }
        // A condition has any unit: it is measured by how fast it changes.
        for i in (0..held.len()).filter(|&i| held[i] == Held::Section) {
            let steepness = slopes.row(i).columns(0, state.len()).norm();
            let scale = if steepness > 0.0 { steepness.recip() } else { 0.0 };
            slopes.row_mut(i).scale_mut(scale);
            values[i] *= scale;
        }
        let by_parameter = slopes.column(state.len()).into_owned();
        Ok(Constraints { values, by_parameter, slopes: slopes.columns(0, state.len()).into_owned() })
    }
}

struct Constraints {
    values: DVector<f64>,
    slopes: DMatrix<f64>,
    by_parameter: DVector<f64>,
}

/// Parameters, one of which may vary, and the natural units of states.
pub(super) struct OrbitParameters {
    pub(super) parameters: Vec<f64>,
    /// The parameter that varies, by its place.
    pub(super) varied: Option<usize>,
    /// What it varies on.
    pub(super) unit: f64,
    /// Of coordinates and rates.
    pub(super) units: Vec<f64>,
    pub(super) scales: Scales,
}

impl OrbitParameters {
    /// Each entry of a state, then the parameter, in their units.
    fn directions(&self, entries: usize) -> Vec<Direction> {
        let along = |i: usize| {
            let start = (0..entries).map(|k| if k == i { 1.0 } else { 0.0 }).collect();
            Direction { start, parameter: None, unit: self.units[i] }
        };
        let parameter = Direction { start: vec![0.0; entries], parameter: self.varied, unit: self.unit };
        (0..entries).map(along).chain([parameter]).collect()
    }

    /// What turns a held value of a row into natural units.
    fn natural(&self, layout: &Layout, row: Held) -> f64 {
        match row {
            Held::Gap(row) => layout.unit(row, self.scales.length).recip(),
            Held::Rate(row) => self.scales.time / layout.unit(row, self.scales.length),
            Held::Section => 1.0,
        }
    }
}

impl Held {
    /// What is zero, but for the section.
    fn evaluate(self, equations: &Equations<Dual4>, state: &[Dual4]) -> Option<Dual4> {
        match self {
            Self::Gap(row) => Some(equations.gap()[row]),
            Self::Rate(row) => {
                let jacobian = equations.jacobian(row);
                let along = jacobian.iter().zip(&state[jacobian.len()..]);
                Some(
                    along
                        .fold(equations.prescribed_gap_rate()[row], |sum, (entry, u)| entry.mul_add(*u, sum)),
                )
            }
            Self::Section => None,
        }
    }
}

/// A full state of coordinates and rates, at the time zero.
fn full(layout: &Layout, mut state: Vec<Dual4>) -> Vec<Dual4> {
    let values: Vec<f64> = state.iter().map(Dual4::value).collect();
    state.extend(layout.state_at(&values, 0.0)[state.len()..].iter().map(|&x| Dual4::constant(x)));
    state
}

/// x of least norm with A x = b.
pub(super) fn solve(matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let nothing = || DVector::zeros(matrix.ncols());
    if matrix.is_empty() {
        return nothing();
    }
    let svd = matrix.clone().svd(true, true);
    let cutoff = RANK * svd.singular_values.max();
    svd.solve(right, cutoff).unwrap_or_else(|_| nothing())
}

/// T with A T = 0, Tᵀ T = 1 and zeros in the drifting entries.
fn null_space(matrix: &DMatrix<f64>, drifting: &[usize]) -> DMatrix<f64> {
    let (rows, n) = matrix.shape();
    // As many rows as columns at least, so that all right singular vectors are there.
    let mut all = DMatrix::zeros((rows + drifting.len()).max(n), n);
    all.view_mut((0, 0), (rows, n)).copy_from(matrix);
    drifting.iter().enumerate().for_each(|(k, &entry)| all[(rows + k, entry)] = 1.0);
    let svd = all.svd(false, true);
    let cutoff = RANK * svd.singular_values.max();
    let free: Vec<usize> = (0..n).filter(|&k| svd.singular_values[k] <= cutoff).collect();
    svd.v_t.map_or_else(|| DMatrix::zeros(n, 0), |right| right.select_rows(&free).transpose())
}
