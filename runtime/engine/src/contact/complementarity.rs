//! 0 ≤ J a + b ⟂ λ ≥ 0 over the candidate rows, J a + b = 0 over the fixed ones, with M a = f + Jᵀ λ.
//!
//! Murty's least-index principal pivoting finds the set of a regular problem; where supports are redundant and it
//! fails, all sets are tried. Of several λ ≥ 0 with the same accelerations the one of least norm is taken.
//!
//! A rough contact brings its tangential rows, two-sided while it is closed. The problem is then no linear
//! complementarity problem with a semidefinite matrix: it may have several solutions or none, and all sets are tried,
//! the largest first.

use nalgebra::DVector;

use super::equilibrated_kkt::{EquilibratedKkt, TrialSolution};

/// Up to this many candidates all sets may be tried.
const EXHAUSTIVE: usize = 14;

/// Accelerations with their reactions and openings.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) accelerations: DVector<f64>,
    /// λ of every row, zero where it is not closed.
    pub(crate) reactions: DVector<f64>,
    /// Candidates with neither a reaction nor an opening.
    pub(crate) degenerate: Vec<usize>,
    /// Candidates that bear.
    pub(crate) bearing: Vec<usize>,
    /// Fixed rows with λ < 0.
    pub(crate) pulling: Vec<usize>,
    /// Fixed rows with λ > 0.
    pub(crate) pushing: Vec<usize>,
    /// Whether λ is the only one.
    pub(crate) unique: bool,
}

/// Why there is no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LcpError {
    Jammed,
    Singular,
    NotFinite,
}

/// Which rows may be closed.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LcpRows<'a> {
    /// Two-sided rows.
    pub(crate) fixed: &'a [usize],
    /// One-sided rows.
    pub(crate) candidates: &'a [usize],
    /// Two-sided rows that are closed with another one: (row, the other).
    pub(crate) tied: &'a [(usize, usize)],
}

impl LcpRows<'_> {
    /// The rows of a choice among the candidates, in ascending order.
    pub(crate) fn rows(&self, closed: &[bool]) -> Vec<usize> {
        let kept = self.candidates.iter().zip(closed).filter(|(_, closed)| **closed).map(|(row, _)| *row);
        let mut rows: Vec<usize> = self.fixed.iter().copied().chain(kept).collect();
        let tied = self.tied.iter().filter(|(_, with)| rows.contains(with)).map(|(row, _)| *row);
        rows.extend(tied.collect::<Vec<_>>());
        rows.sort_unstable();
        rows
    }

    /// Whether a candidate brings other rows with it.
    fn is_rough(&self) -> bool {
        self.tied.iter().any(|(_, with)| self.candidates.contains(with))
    }
}

impl EquilibratedKkt {
    /// The solution, its set found among the candidates.
    pub(crate) fn solve(&self, choice: &LcpRows) -> Result<Solution, LcpError> {
        let rough = choice.is_rough() && choice.candidates.len() <= EXHAUSTIVE;
        let (closed, attempt) = match (!rough).then(|| self.pivot(choice)).flatten() {
            Some(found) => found,
            None => self.exhaust(choice)?,
        };
        Ok(self.finish(choice, &closed, attempt))
    }

    /// Murty: from all closed, flip the least violated index until none is.
    fn pivot(&self, choice: &LcpRows) -> Option<(Vec<usize>, TrialSolution)> {
        let candidates = choice.candidates;
        let mut closed = vec![true; candidates.len()];
        for _ in 0..1usize << candidates.len().min(EXHAUSTIVE) {
            let rows = choice.rows(&closed);
            let attempt = self.attempt(&rows).ok()?;
            let violated =
                (0..candidates.len()).find(|&k| !self.holds(candidates[k], closed[k], &rows, &attempt));
            match violated {
                Some(k) => closed[k] = !closed[k],
                None if attempt.consistent => return Some((rows, attempt)),
                None => return None,
            }
        }
        None
    }

    /// Tries every set, larger ones first. Only redundant or rough contacts can jam; without them a missing solution is a
    /// numerical failure.
    fn exhaust(&self, choice: &LcpRows) -> Result<(Vec<usize>, TrialSolution), LcpError> {
        let candidates = choice.candidates;
        let count = candidates.len().min(EXHAUSTIVE);
        let mut sets: Vec<u32> = (0..1u32 << count).collect();
        sets.sort_by_key(|set| (count as u32 - set.count_ones(), *set));
        let mut failure = LcpError::Singular;
        for set in sets {
            let closed: Vec<bool> = (0..candidates.len()).map(|k| k >= count || set >> k & 1 == 1).collect();
            let rows = choice.rows(&closed);
            match self.attempt(&rows) {
                Ok(attempt)
                    if attempt.consistent
                        && (0..closed.len())
                            .all(|k| self.holds(candidates[k], closed[k], &rows, &attempt)) =>
                {
                    return Ok((rows, attempt));
                }
                Ok(attempt) if attempt.nullity > 0 || choice.is_rough() => failure = LcpError::Jammed,
                Ok(_) | Err(_) => {}
            }
        }
        Err(failure)
    }

    /// Whether a candidate's condition is met: λ ≥ 0 if closed, J a + b ≥ 0 if open.
    fn holds(&self, row: usize, closed: bool, rows: &[usize], attempt: &TrialSolution) -> bool {
        if closed {
            let reaction = rows.iter().position(|&r| r == row).map_or(0.0, |k| attempt.x[self.n + k]);
            reaction >= -self.tolerance
        } else {
            self.opening(row, &attempt.x) >= -self.tolerance
        }
    }

    fn finish(&self, choice: &LcpRows, rows: &[usize], attempt: TrialSolution) -> Solution {
        let tight: Vec<usize> = choice
            .candidates
            .iter()
            .copied()
            .filter(|row| rows.contains(row) || self.opening(*row, &attempt.x).abs() <= self.tolerance)
            .collect();
        let sliding = |row: &usize| !rows.contains(row) && choice.tied.iter().any(|(_, with)| with == row);
        let tight_choice = LcpRows { candidates: &tight, ..*choice };
        // A rough contact found open slips: closing it would be another motion, no other share of the same one.
        let all: Vec<bool> = tight.iter().map(|row| !sliding(row)).collect();
        let full = self.attempt(&tight_choice.rows(&all));
        let unique = full.map_or(attempt.nullity == 0, |full| full.nullity == 0);
        let (rows, x) =
            if unique { (rows.to_vec(), attempt.x) } else { self.least_norm(&tight_choice, rows, attempt) };
        let mut balanced = DVector::zeros(self.scale.len() - self.n);
        for (k, &row) in rows.iter().enumerate() {
            balanced[row] = x[self.n + k];
        }
        let bears = |row: &usize| balanced[*row] > self.tolerance;
        let pulls = |row: &usize| balanced[*row] < -self.tolerance;
        Solution {
            accelerations: DVector::from_fn(self.n, |i, _| x[i] * self.scale[i]),
            bearing: tight.iter().copied().filter(bears).collect(),
            degenerate: tight.iter().copied().filter(|row| !bears(row) && !sliding(row)).collect(),
            reactions: DVector::from_fn(balanced.len(), |row, _| balanced[row] * self.scale[self.n + row]),
            pulling: choice.fixed.iter().copied().filter(pulls).collect(),
            pushing: choice.fixed.iter().copied().filter(bears).collect(),
            unique,
        }
    }

    /// The least-norm λ ≥ 0 on the rows with g̈ = 0. On the rows where it is positive it is also the least-norm λ without the
    /// sign condition, so that trying all subsets finds it.
    fn least_norm(
        &self,
        choice: &LcpRows,
        rows: &[usize],
        attempt: TrialSolution,
    ) -> (Vec<usize>, DVector<f64>) {
        let tight = choice.candidates;
        let length = |rows: &[usize], x: &DVector<f64>| {
            (0..rows.len()).map(|k| (x[self.n + k] * self.scale[self.n + rows[k]]).powi(2)).sum::<f64>()
        };
        let first = attempt.x.rows(0, self.n).into_owned();
        let same = |x: &DVector<f64>| (x.rows(0, self.n) - &first).amax() <= 1e3 * self.tolerance;
        let mut best = (rows.to_vec(), attempt.x);
        let count = tight.len().min(EXHAUSTIVE);
        for set in 0..1u32 << count {
            let closed: Vec<bool> = (0..tight.len()).map(|k| k < count && set >> k & 1 == 1).collect();
            let rows = choice.rows(&closed);
            if let Ok(attempt) = self.attempt(&rows)
                && attempt.consistent
                && (!choice.is_rough() || same(&attempt.x))
                && tight.iter().zip(&closed).all(|(&row, &closed)| self.holds(row, closed, &rows, &attempt))
                && length(&rows, &attempt.x) < length(&best.0, &best.1)
            {
                best = (rows, attempt.x);
            }
        }
        best
    }
}
