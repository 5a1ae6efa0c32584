//! What is to be integrated.

use core::cell::RefCell;

use super::filled;
use crate::integrate::StepState;
use crate::system::{Jacobian, PhaseEquations};

/// An initial value problem of a phase.
#[derive(Clone, Copy)]
pub struct InitialValueProblem<'a> {
    /// The equations.
    pub phase: &'a dyn PhaseEquations,
    /// Time at the start.
    pub t: f64,
    /// The reduced state there.
    pub start: &'a [f64],
    /// No step goes past this time.
    pub end: f64,
    /// Error allowed per step, relative to each entry.
    pub relative: f64,
    /// And absolute.
    pub absolute: &'a [f64],
    /// By which both are multiplied.
    pub tightness: f64,
    /// No step is longer.
    pub longest: Option<f64>,
}

impl<'a> InitialValueProblem<'a> {
    /// The number of entries.
    pub(super) fn len(&self) -> usize {
        self.start.len()
    }

    /// f of y′ = f(y), filled up with zeros.
    pub(super) fn rates<const N: usize>(&self) -> impl Fn(&[f64; N]) -> [f64; N] + use<'a, N> {
        let (phase, entries) = (self.phase, self.len());
        move |y| {
            let mut f = [0.0; N];
            phase.derivative(&y[..entries], &mut f[..entries]);
            f
        }
    }

    /// How many coordinates have the entries that follow as their rates: all or none, as f says
    /// where those are 1, 2, ….
    pub(super) fn pairs<const N: usize>(&self, step_state: &StepState<f64, N>) -> usize {
        let info = self.phase.info();
        let n = info.coordinates;
        if n != info.rates || 2 * n > self.len() {
            return 0;
        }
        let mut probe = *step_state.state();
        for (i, rate) in probe[n..2 * n].iter_mut().enumerate() {
            *rate = (i + 1) as f64;
        }
        if self.rates::<N>()(&probe)[..n] == probe[n..2 * n] { n } else { 0 }
    }
}

/// ∂f/∂y, filled up with zeros: the phase's own, or else by differences, which serve Newton's
/// iteration where nothing is stiff.
pub(super) struct JacobianMatrix<'a, const N: usize> {
    problem: InitialValueProblem<'a>,
    exact: Option<Jacobian<'a>>,
    /// Its entries, row by row.
    scratch: RefCell<Vec<f64>>,
}

impl<'a, const N: usize> JacobianMatrix<'a, N> {
    pub(super) fn from_problem(problem: &InitialValueProblem<'a>) -> Self {
        let n = problem.len();
        Self { problem: *problem, exact: problem.phase.jacobian(), scratch: RefCell::new(vec![0.0; n * n]) }
    }

    pub(super) fn evaluate(&self, y: &[f64; N]) -> [[f64; N]; N] {
        let Some(exact) = &self.exact else { return self.differences(y) };
        let mut entries = self.scratch.borrow_mut();
        let n = self.problem.len();
        exact(&y[..n], &mut entries);
        // At the zero of a root it has none.
        if !entries.iter().all(|entry| entry.is_finite()) {
            return self.differences(y);
        }
        let mut rows = [[0.0; N]; N];
        for (row, known) in rows.iter_mut().zip(entries.chunks_exact(n.max(1))) {
            *row = filled(known, 0.0);
        }
        rows
    }

    /// Forward differences over √ε of each entry's size.
    fn differences(&self, y: &[f64; N]) -> [[f64; N]; N] {
        let f = self.problem.rates::<N>();
        let f0 = f(y);
        let mut rows = [[0.0; N]; N];
        for (j, absolute) in self.problem.absolute.iter().enumerate() {
            let size = y[j].abs().max(absolute / self.problem.relative);
            let mut beside = *y;
            beside[j] += f64::EPSILON.sqrt() * size;
            let h = beside[j] - y[j];
            for (row, (f1, f0)) in rows.iter_mut().zip(f(&beside).iter().zip(&f0)) {
                row[j] = (f1 - f0) / h;
            }
        }
        rows
    }
}
