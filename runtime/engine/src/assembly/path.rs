//! The path on which a pose is completed: the given coordinates move along a line from their values
//! in the nominal figure, those left open follow, by a step along the tangent and Gauss–Newton back
//! to the closed rows:
//!
//! ```text
//! J_open q_open′ = −J_given q_given′          J_open Δq_open = −g(q)
//! ```
//!
//! (Allgower and Georg, *Introduction to Numerical Continuation Methods*, 2003, chapters 2 and 6).
//! A step is halved that is not short beside what it corrects, or behind which det J_open has
//! another sign: it has come onto another branch. Only where no step is short enough the path has
//! come to a branch point, as a parallelogram's, and goes straight across, or to a dead centre.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::problem::AssemblyProblem;
use crate::context::CLOSED;
use crate::numerics::decomposition::svd;

/// The longest step of a given coordinate, 11° or a fifth of the natural length, and of one left
/// open: a length may go farther where the path is straight, as along a slope.
const STEP: f64 = core::f64::consts::PI / 16.0;
const FOLLOWS: f64 = 2.5 * STEP;
/// The most steps, where none is halved.
const STEPS: f64 = 64.0;
/// The shortest step, as part of the way.
const SHORTEST: f64 = 1e-8;
/// What a step may be corrected by, in lengths of the step, and then each time in what it was
/// before.
const CONTRACTION: f64 = 0.25;
/// A correction this small, in lengths of the step, leaves a tangent that is good enough; of a
/// smaller step no part counts.
const NEAR: f64 = 1e-3;
const SMALL: f64 = 1e-6;
const CORRECTIONS: usize = 8;
/// A smaller singular value, in largest ones, is that of a branch point.
const LEAST: f64 = 1e-13;
/// Rows are independent if the ratio of their singular values is no smaller.
const INDEPENDENT: f64 = 1e-9;

/// Whether a step stays on its branch for sure.
#[derive(Clone, Copy, PartialEq)]
enum Branch {
    Same,
    Any,
}

/// The rows to be closed and the coordinates to be found, with the position where the path begins.
pub(super) struct AssemblyPath<'a> {
    assembly: &'a AssemblyProblem<'a>,
    closed: &'a [usize],
    open: &'a [usize],
    begin: PathPoint,
}

/// A position on the path.
#[derive(Clone)]
struct PathPoint {
    /// The part of the way behind it.
    fraction: f64,
    q: Vec<f64>,
    gap: DVector<f64>,
    /// By all coordinates, in natural units.
    jacobian: DMatrix<f64>,
    /// That by the coordinates left open.
    svd: SVD<f64, Dyn, Dyn>,
    /// The sign of its determinant, zero where it is not square.
    side: f64,
}

/// How many steps moves of the given coordinates take, where none is halved.
pub(super) fn steps(assembly: &AssemblyProblem<'_>, moves: &[f64]) -> usize {
    let unit = |i: usize| assembly.context.scales.coordinate(&assembly.layout().coordinates[i]);
    let far = moves.iter().enumerate().map(|(i, by)| by.abs() / unit(i)).fold(0.0, f64::max);
    (far / STEP).ceil().clamp(1.0, STEPS) as usize
}

impl<'a> AssemblyPath<'a> {
    /// The one that begins at a position, if that closes the rows and determines a tangent.
    pub(super) fn from(
        q: Vec<f64>,
        assembly: &'a AssemblyProblem<'a>,
        (closed, open): (&'a [usize], &'a [usize]),
    ) -> Option<Self> {
        if closed.len() > open.len() {
            return None;
        }
        let begin = PathPoint::evaluate(assembly, (closed, open), 0.0, q);
        let values = &begin.svd.singular_values;
        let is_independent = values.min() > INDEPENDENT * values.max();
        let is_determined = is_independent && begin.gap.amax() <= CLOSED;
        is_determined.then_some(Self { assembly, closed, open, begin })
    }

    /// The position behind all moves of the given coordinates, but for its last digits, if the path
    /// leads there.
    pub(super) fn end(&self, moves: &[f64]) -> Option<Vec<f64>> {
        let longest = 1.0 / steps(self.assembly, moves) as f64;
        let mut here = self.begin.clone();
        let mut step = longest;
        while here.fraction < 1.0 {
            let next = self.step(&here, moves, (step, Branch::Same));
            match next.or_else(|| self.step(&here, moves, (longest, Branch::Any))) {
                Some(next) => {
                    step = (2.0 * (next.fraction - here.fraction)).min(longest);
                    here = next;
                }
                None if 1.0 - here.fraction <= 2.0 * SHORTEST => break,
                None => return None,
            }
        }
        Some(here.q)
    }

    fn unit(&self, coordinate: usize) -> f64 {
        self.assembly.context.scales.coordinate(&self.assembly.layout().coordinates[coordinate])
    }

    /// The next point, a step or the next half of it that is short enough away.
    fn step(&self, from: &PathPoint, moves: &[f64], (longest, branch): (f64, Branch)) -> Option<PathPoint> {
        let halves = core::iter::successors(Some(longest), |step| Some(0.5 * step));
        let mut halves = halves.take_while(|step| *step >= SHORTEST);
        halves.find_map(|step| {
            let next = self.corrected(from, moves, (from.fraction + step).min(1.0))?;
            (branch == Branch::Any || next.side == from.side).then_some(next)
        })
    }

    /// The point behind so much of the way, if the tangent leads near it.
    fn corrected(&self, from: &PathPoint, moves: &[f64], fraction: f64) -> Option<PathPoint> {
        let part = fraction - from.fraction;
        let given = DVector::from_fn(moves.len(), |i, _| part * moves[i] / self.unit(i));
        let tangent = -from.solve(&(&from.jacobian * &given))?;
        let length = tangent.amax().max(given.amax()).max(SMALL);
        let mut far = self.open.iter().zip(tangent.iter()).filter(|(_, by)| by.abs() > FOLLOWS);
        let is_long = far.clone().next().is_some();
        if far.any(|(&i, _)| self.assembly.layout().coordinates[i].is_angle) {
            return None;
        }
        let mut q: Vec<f64> = from.q.iter().zip(moves).map(|(q, by)| q + part * by).collect();
        let mut change = tangent;
        let mut most = length;
        for _ in 0..CORRECTIONS {
            self.open.iter().zip(change.iter()).for_each(|(&i, by)| q[i] += by * self.unit(i));
            let mut point = PathPoint::evaluate(self.assembly, (self.closed, self.open), fraction, q.clone());
            change = -point.solve(&point.gap)?;
            if is_long && change.amax() > NEAR {
                return None;
            }
            most *= CONTRACTION;
            if change.amax() <= NEAR * length {
                // What is left of the gap is small beside the next step too, which may be much
                // shorter.
                self.open.iter().zip(change.iter()).for_each(|(&i, by)| point.q[i] += by * self.unit(i));
                return Some(point);
            }
            if change.amax() > most {
                return None;
            }
            most = change.amax();
        }
        None
    }
}

impl PathPoint {
    fn evaluate(
        assembly: &AssemblyProblem<'_>,
        (closed, open): (&[usize], &[usize]),
        fraction: f64,
        q: Vec<f64>,
    ) -> Self {
        let all: Vec<usize> = (0..q.len()).collect();
        let jacobian = assembly.jacobian(&q, (closed, &all));
        let by_open = jacobian.select_columns(open);
        let side = if by_open.is_square() { by_open.determinant().signum() } else { 0.0 };
        let gap = assembly.gaps(&q, closed);
        Self { fraction, q, gap, jacobian, svd: svd(by_open), side }
    }

    /// The least change of the coordinates left open that changes the gaps by as much.
    fn solve(&self, gap: &DVector<f64>) -> Option<DVector<f64>> {
        let change = self.svd.solve(gap, LEAST * self.svd.singular_values.max()).ok()?;
        change.iter().all(|x| x.is_finite()).then_some(change)
    }
}
