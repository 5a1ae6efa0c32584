//! 0 ≤ J a + b ⟂ λ ≥ 0 over the candidate rows, J a + b = 0 over the fixed ones, with M a = f + Jᵀ
//! λ.
//!
//! Gauss's principle finds independent rows that bear
//! ([`LeastConstraint`](super::least_constraint)), the equations with these closed their values.
//! Where a motion without inertia follows from its contacts alone, the set is found by Murty's
//! least-index principal pivoting from all contacts closed.
//!
//! A rough contact brings its tangential rows, two-sided while it is closed. The problem is then no
//! linear complementarity problem with a semidefinite matrix: it may have several solutions or
//! none. All contacts are taken to stick, those that open are released with their tangents; where
//! that does not lead to a solution all sets are tried, the largest first.

use nalgebra::DVector;

use super::equilibrated_kkt::{EquilibratedKkt, TrialSolution};
use super::least_constraint::LeastConstraint;
use super::trials::{LcpError, Trials};

/// Up to this many candidates all sets may be tried.
const EXHAUSTIVE: usize = 14;

/// Accelerations with their reactions and openings.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) accelerations: DVector<f64>,
    /// λ of every row, zero where it is not closed. Where it is not unique, contacts that depend on
    /// those that bear have none.
    pub(crate) reactions: DVector<f64>,
    /// Candidates with neither a reaction nor an opening.
    pub(crate) degenerate: Vec<usize>,
    /// Candidates that bear.
    pub(crate) active_basis: Vec<usize>,
    /// Fixed rows with λ < 0.
    pub(crate) pulling: Vec<usize>,
    /// Fixed rows with λ > 0.
    pub(crate) pushing: Vec<usize>,
    /// All rows without an opening, tangential ones too.
    pub(super) tight: Vec<usize>,
    /// Whether λ is the only one.
    pub(crate) unique: bool,
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
    /// The sets that may be tried, if not any number.
    pub(crate) trials: Option<&'a Trials>,
}

impl LcpRows<'_> {
    /// Counts a set that is tried.
    pub(super) fn attempt(&self) -> Result<(), LcpError> {
        self.trials.map_or(Ok(()), Trials::take)
    }

    /// The fixed rows with some candidates and what is tied to any of them, in ascending order.
    pub(crate) fn rows(&self, closed: &[usize]) -> Vec<usize> {
        let mut rows: Vec<usize> = self.fixed.iter().chain(closed).copied().collect();
        rows.extend(self.tied_to(&rows));
        rows.sort_unstable();
        rows
    }

    pub(super) fn tied_to(&self, closed: &[usize]) -> Vec<usize> {
        self.tied.iter().filter(|(_, with)| closed.contains(with)).map(|(row, _)| *row).collect()
    }

    /// Whether a row brings others with it.
    pub(super) fn is_rough(&self, row: usize) -> bool {
        self.tied.iter().any(|(_, with)| *with == row)
    }
}

/// Closed rows with the solution that follows.
type ActiveSolution = (Vec<usize>, TrialSolution);

impl EquilibratedKkt {
    /// The solution, its set found among the candidates.
    pub(crate) fn solve(&self, choice: &LcpRows) -> Result<Solution, LcpError> {
        let least = self.least_constraint()?;
        let rough = choice.candidates.iter().any(|&row| choice.is_rough(row));
        let found = if rough { self.stick(choice, &least) } else { self.bear(choice, &least) };
        let (rows, attempt) = match found {
            Ok(found) => found,
            Err(LcpError::Jammed) if !rough => return Err(LcpError::Jammed),
            Err(_) => match if rough { None } else { self.pivot(choice)? } {
                Some(found) => found,
                None => self.exhaust(choice)?,
            },
        };
        Ok(self.finish(choice, &least, &rows, attempt))
    }

    /// Smooth contacts by the principle of least constraint.
    fn bear(&self, choice: &LcpRows, least: &LeastConstraint) -> Result<ActiveSolution, LcpError> {
        let fixed = choice.rows(&[]);
        let bearing = least.find_active_basis(&fixed, choice.candidates)?;
        let candidates: Vec<usize> =
            bearing.into_iter().filter(|row| choice.candidates.contains(row)).collect();
        self.checked(choice, choice.rows(&candidates))
    }

    /// Rough contacts: those that open slip, all others do not.
    fn stick(&self, choice: &LcpRows, least: &LeastConstraint) -> Result<ActiveSolution, LcpError> {
        let mut closed = choice.candidates.to_vec();
        loop {
            let held: Vec<usize> =
                choice.rows(&closed).into_iter().filter(|row| !closed.contains(row)).collect();
            let bearing = least.find_active_basis(&held, &closed)?;
            let mut rows: Vec<usize> = held.iter().chain(&bearing).copied().collect();
            rows.sort_unstable();
            rows.dedup();
            let attempt = self.attempt(&rows)?;
            // What bears is closed, whatever rounding leaves of its opening.
            let slips = |row: &usize| choice.is_rough(*row) && !rows.contains(row);
            let opens = |row: &usize| slips(row) && self.opening(*row, &attempt.x) > self.slack(*row);
            let before = closed.len();
            closed.retain(|row| !opens(row));
            if closed.len() == before {
                return self.checked(choice, rows);
            }
        }
    }

    /// The solution with these rows closed, if it meets all conditions.
    fn checked(&self, choice: &LcpRows, rows: Vec<usize>) -> Result<ActiveSolution, LcpError> {
        let attempt = self.attempt(&rows)?;
        let holds = |&row: &usize| self.holds(row, &rows, &attempt);
        match attempt.consistent {
            true if choice.candidates.iter().all(holds) => Ok((rows, attempt)),
            false if attempt.nullity > 0 => Err(LcpError::Jammed),
            _ => Err(LcpError::Singular),
        }
    }

    /// Murty: from all closed, flip the least violated index until none is.
    fn pivot(&self, choice: &LcpRows) -> Result<Option<ActiveSolution>, LcpError> {
        let candidates = choice.candidates;
        let mut closed = candidates.to_vec();
        for _ in 0..1usize << candidates.len().min(EXHAUSTIVE) {
            choice.attempt()?;
            let rows = choice.rows(&closed);
            let Ok(attempt) = self.attempt(&rows) else { return Ok(None) };
            match candidates.iter().find(|&&row| !self.holds(row, &rows, &attempt)) {
                Some(row) if closed.contains(row) => closed.retain(|other| other != row),
                Some(row) => closed.push(*row),
                None => return Ok(attempt.consistent.then_some((rows, attempt))),
            }
        }
        Ok(None)
    }

    /// Tries every set, larger ones first. Only redundant or rough contacts can jam; without them a
    /// missing solution is a numerical failure.
    fn exhaust(&self, choice: &LcpRows) -> Result<ActiveSolution, LcpError> {
        let count = choice.candidates.len();
        if count > EXHAUSTIVE {
            return Err(LcpError::Jammed);
        }
        let mut sets: Vec<u32> = (0..1u32 << count).collect();
        sets.sort_unstable_by_key(|set| (count as u32 - set.count_ones(), *set));
        let mut failure = LcpError::Singular;
        for set in sets {
            let closed = (0..count).filter(|k| set >> k & 1 == 1).map(|k| choice.candidates[k]);
            let rows = choice.rows(&closed.collect::<Vec<_>>());
            choice.attempt()?;
            let Ok(attempt) = self.attempt(&rows) else { continue };
            let holds = |row: &usize| self.holds(*row, &rows, &attempt);
            if attempt.consistent && choice.candidates.iter().all(holds) {
                return Ok((rows, attempt));
            }
            if attempt.nullity > 0 || !choice.tied.is_empty() {
                failure = LcpError::Jammed;
            }
        }
        Err(failure)
    }

    /// Whether a candidate's condition is met: λ ≥ 0 if closed, J a + b ≥ 0 if open.
    fn holds(&self, row: usize, rows: &[usize], attempt: &TrialSolution) -> bool {
        let value = match rows.iter().position(|&closed| closed == row) {
            Some(place) => attempt.x[self.n + place],
            None => self.opening(row, &attempt.x),
        };
        value >= -self.slack(row)
    }

    fn finish(
        &self,
        choice: &LcpRows,
        least: &LeastConstraint,
        rows: &[usize],
        attempt: TrialSolution,
    ) -> Solution {
        let x = attempt.x;
        let mut balanced = DVector::zeros(self.scale.len() - self.n);
        for (k, &row) in rows.iter().enumerate() {
            balanced[row] = x[self.n + k];
        }
        let closed = |row: &usize| rows.contains(row) || self.opening(*row, &x).abs() <= self.slack(*row);
        // A rough contact found open slips: closing it would be another motion, no other share of
        // the same one.
        let slips = |row: &usize| choice.tied.iter().any(|(tied, with)| with == row && !rows.contains(tied));
        let tight = choice.candidates.iter().copied().filter(closed).filter(|row| !slips(row));
        let tight: Vec<usize> = tight.collect();
        let bears = |row: &usize| balanced[*row] > self.slack(*row);
        let pulls = |row: &usize| balanced[*row] < -self.slack(*row);
        let (bearing, degenerate) = tight.iter().partition(|row| bears(row));
        let all = choice.rows(&tight);
        Solution {
            accelerations: DVector::from_fn(self.n, |i, _| x[i] * self.scale[i]),
            active_basis: bearing,
            degenerate,
            reactions: DVector::from_fn(balanced.len(), |row, _| balanced[row] * self.scale[self.n + row]),
            pulling: choice.fixed.iter().copied().filter(pulls).collect(),
            pushing: choice.fixed.iter().copied().filter(bears).collect(),
            unique: attempt.nullity == 0
                && (all.len() == rows.len() || least.independent(&all).len() == all.len()),
            tight: all,
        }
    }
}
