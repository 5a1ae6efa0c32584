//! `[M −Cᵀ; J 0] [a; λ] = [f; −b]` with the rows of closed contacts in J and, in C, J_N − σ μ J_t
//! instead of J_N for those that slide.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::modes::{
    Bound, ContactMode, Frictional, ImpulseBounds, ModeChoice, ModeCondition, SlipDirection, smooth_choices,
};
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::{EquilibratedKkt, largest_in_part};
use crate::contact::trials::LcpError;
use crate::numerics::decomposition::svd;
use crate::numerics::zero::MARGIN;

/// Pivots that differ by more belong to a matrix that a singular value decomposition has to judge.
const SOUND: f64 = 1e-9;
/// Residual of equations that hold, in units of roundoff of as many terms as there are equations.
const CONSISTENT: f64 = 16.0;
/// The error of a located event in units of rounding.
const LOCATED: f64 = 1e3;

/// Contacts of both kinds.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FrictionProblem<'a> {
    /// Two-sided rows, contacts without friction, rough ones.
    pub(crate) rows: LcpRows<'a>,
    /// Contacts with friction.
    pub(crate) contacts: &'a [Frictional],
}

/// A contact of either kind with its modes.
#[derive(Clone)]
pub(super) struct Unit {
    pub(super) normal: usize,
    /// The row along which friction acts.
    pub(super) tangent: Option<usize>,
    pub(super) mu: f64,
    pub(super) limit: f64,
    pub(super) given: Option<ImpulseBounds>,
    pub(super) choices: Vec<ModeChoice>,
}

impl Unit {
    /// Whether it is a guide: neither open nor on one side alone.
    pub(super) fn is_guide(&self) -> bool {
        self.choices.iter().any(|choice| matches!(choice.mode, ContactMode::Guide { .. }))
    }

    /// |R| while it slides in a sense.
    pub(super) fn kinetic(&self, sense: SlipDirection) -> Bound {
        self.bound(sense, self.mu)
    }

    /// The bound of R against a slip in a sense while it sticks.
    pub(super) fn limit(&self, sense: SlipDirection) -> Bound {
        self.bound(sense, self.limit)
    }

    fn bound(&self, sense: SlipDirection, slope: f64) -> Bound {
        match (self.given, sense) {
            (None, _) => Bound { slope, offset: 0.0 },
            (Some(given), SlipDirection::Forward) => given.forward,
            (Some(given), SlipDirection::Backward) => given.backward,
        }
    }
}

/// All contacts with the balanced equations.
pub(super) struct BalancedProblem<'a> {
    pub(super) kkt: &'a EquilibratedKkt,
    pub(super) question: &'a FrictionProblem<'a>,
    /// Contacts with friction, then those without.
    pub(super) units: Vec<Unit>,
}

/// A combination of the balanced multipliers of rows, (row, part).
pub(super) type Edge = Vec<(usize, f64)>;

/// Closed rows, the columns that are not the transposed rows, (normal, tangent, −σ μ), and
/// multipliers that are given.
#[derive(Default)]
pub(super) struct ActiveRows {
    pub(super) rows: Vec<usize>,
    pub(super) bends: Vec<(usize, usize, f64)>,
    pub(super) loads: Vec<(usize, f64)>,
}

impl ActiveRows {
    /// The place of a row that is closed.
    pub(super) fn find_place(&self, row: usize) -> Option<usize> {
        self.rows.iter().position(|&other| other == row)
    }

    /// What multipliers of closed rows the loads of edges are, a column for each; `None` where an
    /// edge has a row that is not closed.
    pub(super) fn build_edge_matrix(&self, edges: &[Edge]) -> Option<DMatrix<f64>> {
        let mut of_edges = DMatrix::zeros(self.rows.len(), edges.len());
        for (k, edge) in edges.iter().enumerate() {
            for &(row, part) in edge {
                of_edges[(self.find_place(row)?, k)] = part;
            }
        }
        Some(of_edges)
    }
}

/// Balanced accelerations and multipliers of all rows.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    pub(super) a: DVector<f64>,
    pub(super) reactions: DVector<f64>,
    /// Whether the multipliers are the only ones.
    pub(super) unique: bool,
    /// Whether the accelerations are the only ones in these modes.
    pub(super) determined: bool,
}

/// A solution with one choice of every contact.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    pub(super) chosen: Vec<usize>,
    /// The modes it was found with, contacts that it does not need open.
    pub(super) acting: Vec<ContactMode>,
    pub(super) trial: Trial,
}

/// A matrix of the balanced problem with its right-hand side, over some rows.
pub(super) struct RowEquations {
    pub(super) index: Vec<usize>,
    pub(super) matrix: DMatrix<f64>,
    pub(super) right: DVector<f64>,
}

impl<'a> BalancedProblem<'a> {
    pub(super) fn new(kkt: &'a EquilibratedKkt, question: &'a FrictionProblem<'a>) -> Self {
        let with_friction = question.contacts.iter().map(|contact| Unit {
            normal: contact.normal,
            tangent: Some(contact.tangent),
            mu: contact.mu,
            limit: contact.limit,
            given: contact.given,
            choices: contact.choices.clone(),
        });
        let smooth = question.rows.candidates.iter().map(|&normal| Unit {
            normal,
            tangent: None,
            mu: 0.0,
            limit: 0.0,
            given: None,
            choices: smooth_choices(),
        });
        let units = with_friction.chain(smooth).collect();
        Self { kkt, question, units }
    }

    /// The same with some of the contacts, all others open.
    pub(super) fn with_units(&self, places: &[usize]) -> Self {
        let Self { kkt, question, ref units } = *self;
        Self { kkt, question, units: places.iter().map(|&k| units[k].clone()).collect() }
    }

    /// Rows and columns of some modes, one for each contact.
    pub(super) fn closed(&self, modes: &[ContactMode]) -> ActiveRows {
        let units = || self.units.iter().zip(modes);
        let candidates = units().filter(|(unit, mode)| unit.tangent.is_none() && mode.is_closed());
        let mut closed = ActiveRows {
            rows: self.question.rows.rows(&candidates.map(|(unit, _)| unit.normal).collect::<Vec<_>>()),
            ..ActiveRows::default()
        };
        for (unit, mode) in units() {
            let Some(tangent) = unit.tangent else { continue };
            closed.rows.extend(mode.is_closed().then_some(unit.normal));
            closed.rows.extend(mode.holds_tangent().then_some(tangent));
            let Some(sense) = mode.sense() else { continue };
            let Bound { slope, offset } = unit.kinetic(sense);
            if mode.is_closed() {
                closed.bends.push((unit.normal, tangent, -mode.side() * sense.sign() * slope));
            }
            if offset != 0.0 {
                closed.loads.push((tangent, -sense.sign() * offset));
            }
        }
        closed
    }

    /// The motion with contacts in some modes; `None` where the equations contradict each other.
    pub(super) fn attempt(&self, chosen: &[&ModeChoice]) -> Result<Option<Trial>, LcpError> {
        let modes: Vec<ContactMode> = chosen.iter().map(|choice| choice.mode).collect();
        let closed = self.closed(&modes);
        let equations = self.kkt.equations(&closed)?;
        if let Some(x) = equations.solve() {
            return Ok(Some(self.trial(&closed, &x)));
        }
        self.admissible(chosen, &closed, &equations)
    }

    pub(super) fn trial(&self, closed: &ActiveRows, x: &DVector<f64>) -> Trial {
        let n = self.kkt.n;
        let mut reactions = DVector::zeros(self.kkt.scale.len() - n);
        for (k, &row) in closed.rows.iter().enumerate() {
            reactions[row] += x[n + k];
        }
        for &(normal, tangent, factor) in &closed.bends {
            reactions[tangent] += factor * self.kkt.ratio(normal, tangent) * reactions[normal];
        }
        for &(tangent, load) in &closed.loads {
            reactions[tangent] += load / self.kkt.scale[n + tangent];
        }
        Trial { a: x.rows(0, n).into_owned(), reactions, unique: true, determined: true }
    }

    /// Whether a contact's conditions of a mode are met.
    pub(super) fn holds(&self, unit: &Unit, choice: &ModeChoice, trial: &Trial) -> bool {
        choice.conditions.iter().all(|&condition| {
            let (value, slack) = self.value(unit, choice.mode, condition, trial);
            value >= -slack
        })
    }

    /// What is to be ≥ 0, with its rounding.
    pub(super) fn value(
        &self,
        unit: &Unit,
        mode: ContactMode,
        condition: ModeCondition,
        trial: &Trial,
    ) -> (f64, f64) {
        let kkt = self.kkt;
        let slipping = || match (mode.sense(), unit.tangent) {
            (Some(sense), Some(tangent)) => {
                (sense.sign() * kkt.opening(tangent, &trial.a), kkt.slack(tangent))
            }
            _ => (0.0, 0.0),
        };
        match condition {
            ModeCondition::Opens => (kkt.opening(unit.normal, &trial.a), kkt.slack(unit.normal)),
            ModeCondition::Presses => (mode.side() * trial.reactions[unit.normal], kkt.slack(unit.normal)),
            ModeCondition::Below => self.reserve(unit, (mode, SlipDirection::Backward), trial),
            ModeCondition::Above => self.reserve(unit, (mode, SlipDirection::Forward), trial),
            ModeCondition::Slips => slipping(),
            ModeCondition::Follows => {
                let (value, slack) = slipping();
                (value, LOCATED * slack)
            }
        }
    }

    /// μ_s s λ_N + σ R in the unit of R's balanced row.
    fn reserve(&self, unit: &Unit, (mode, sense): (ContactMode, SlipDirection), trial: &Trial) -> (f64, f64) {
        let Some(tangent) = unit.tangent else { return (0.0, 0.0) };
        let Bound { slope, offset } = unit.limit(sense);
        let share = slope * self.kkt.ratio(unit.normal, tangent);
        let most = mode.side() * share * trial.reactions[unit.normal]
            + offset / self.kkt.scale[self.kkt.n + tangent];
        let value = most + sense.sign() * trial.reactions[tangent];
        (value, share * self.kkt.slack(unit.normal) + self.kkt.slack(tangent))
    }
}

impl EquilibratedKkt {
    /// Joins the parts of the system that friction connects.
    pub(super) fn couple(&mut self, contacts: &[Frictional]) {
        self.limit_tangents(contacts.iter().map(|contact| (contact.normal, contact.tangent)));
        for contact in contacts {
            let [kept, joined] = [contact.normal, contact.tangent].map(|row| self.parts[self.n + row]);
            if kept == joined {
                continue;
            }
            let most = [contact.normal, contact.tangent].map(|row| self.slack(row)).into_iter();
            let most = most.fold(0.0, f64::max);
            for (part, tolerance) in self.parts.iter_mut().zip(self.tolerance.iter_mut()) {
                if *part == kept || *part == joined {
                    (*part, *tolerance) = (kept, most);
                }
            }
        }
    }

    /// The balanced unit of a row by that of another one: a force of the first in units of the
    /// second.
    pub(super) fn ratio(&self, row: usize, other: usize) -> f64 {
        self.scale[self.n + row] / self.scale[self.n + other]
    }

    /// The balanced matrix and right-hand side with some rows closed.
    pub(super) fn equations(&self, closed: &ActiveRows) -> Result<RowEquations, LcpError> {
        let index: Vec<usize> = (0..self.n).chain(closed.rows.iter().map(|row| self.n + row)).collect();
        let mut matrix = self.matrix.select_rows(&index).select_columns(&index);
        for &(normal, tangent, factor) in &closed.bends {
            let place = closed.find_place(normal).ok_or(LcpError::Singular)?;
            let share = factor * self.ratio(normal, tangent);
            for i in 0..self.n {
                matrix[(i, self.n + place)] += share * self.matrix[(i, self.n + tangent)];
            }
        }
        let mut right = self.right.select_rows(&index);
        for &(tangent, load) in &closed.loads {
            let column = self.matrix.view((0, self.n + tangent), (self.n, 1));
            let mut forces = right.rows_mut(0, self.n);
            forces.axpy(-load / self.scale[self.n + tangent], &column.column(0), 1.0);
        }
        match matrix.iter().chain(&right).all(|x| x.is_finite()) {
            true => Ok(RowEquations { index, matrix, right }),
            false => Err(LcpError::NotFinite),
        }
    }

    /// Whether y meets balanced equations with this matrix, but for roundoff of the sums in the
    /// part of each.
    pub(super) fn are_met(&self, equations: &RowEquations, matrix: &DMatrix<f64>, y: &DVector<f64>) -> bool {
        let parts: Vec<usize> = equations.index.iter().map(|&i| self.parts[i]).collect();
        let terms =
            largest_in_part(&parts, &(matrix.abs() * y.abs() + self.size.select_rows(&equations.index)));
        let roundoff = CONSISTENT * equations.index.len() as f64 * f64::EPSILON;
        (&equations.right - matrix * y)
            .abs()
            .iter()
            .zip(&terms)
            .all(|(rest, terms)| *rest <= roundoff * terms)
    }
}

impl RowEquations {
    /// The solution where the matrix is clearly regular, once refined.
    pub(super) fn solve(&self) -> Option<DVector<f64>> {
        self.solve_for(&self.right)
    }

    pub(super) fn solve_for(&self, right: &DVector<f64>) -> Option<DVector<f64>> {
        let factors = self.matrix.clone().full_piv_lu();
        let pivots = factors.u().diagonal().abs();
        if pivots.is_empty() {
            return Some(right.clone());
        }
        if pivots.min() <= SOUND * pivots.max() {
            return None;
        }
        let x = factors.solve(right)?;
        let rest = right - &self.matrix * &x;
        Some(&x + factors.solve(&rest)?)
    }

    /// The least-norm solution of a matrix that may be singular, and whether its first `n` entries
    /// are determined.
    pub(super) fn least_norm(&self, right: &DVector<f64>, n: usize) -> Option<(DVector<f64>, bool)> {
        let svd = svd(self.matrix.clone());
        let cutoff = cutoff(&svd);
        let vectors = svd.v_t.as_ref()?;
        let mut null = (0..vectors.nrows()).filter(|&k| svd.singular_values[k] <= cutoff);
        let free = null.any(|k| vectors.row(k).columns(0, n).norm() > MARGIN);
        Some((least_squares(&svd, right)?, !free))
    }
}

/// The singular value up to which a matrix is singular.
fn cutoff(svd: &SVD<f64, Dyn, Dyn>) -> f64 {
    let size = svd.u.as_ref().map_or(0, |u| u.nrows());
    8.0 * size as f64 * f64::EPSILON * svd.singular_values.amax()
}

/// The least-norm least-squares solution.
pub(super) fn least_squares(svd: &SVD<f64, Dyn, Dyn>, right: &DVector<f64>) -> Option<DVector<f64>> {
    svd.solve(right, cutoff(svd)).ok()
}
