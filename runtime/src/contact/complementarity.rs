//! 0 ≤ J a + b ⟂ λ ≥ 0 over the candidate rows, J a + b = 0 over the fixed ones, with M a = f + Jᵀ λ.
//!
//! Murty's least-index principal pivoting finds the set of a regular problem; where supports are redundant and it
//! fails, all sets are tried. Of several λ ≥ 0 with the same accelerations the one of least norm is taken.

use nalgebra::DVector;

use super::balanced::{Attempt, Balanced};

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
    /// Whether λ is the only one.
    pub(crate) unique: bool,
}

/// Why there is no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Failure {
    Jammed,
    Singular,
}

impl Balanced {
    /// The solution, its set found among the `candidates` beside the `fixed` rows.
    pub(crate) fn solve(&self, fixed: &[usize], candidates: &[usize]) -> Result<Solution, Failure> {
        let (closed, attempt) = match self.pivot(fixed, candidates) {
            Some(found) => found,
            None => self.exhaust(fixed, candidates)?,
        };
        Ok(self.finish(fixed, candidates, &closed, attempt))
    }

    /// Murty: from all closed, flip the least violated index until none is.
    fn pivot(&self, fixed: &[usize], candidates: &[usize]) -> Option<(Vec<usize>, Attempt)> {
        let mut closed = vec![true; candidates.len()];
        for _ in 0..1usize << candidates.len().min(EXHAUSTIVE) {
            let rows = chosen(fixed, candidates, &closed);
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

    /// Every set, the larger first. Only redundant contacts can jam; without them it is the numbers that fail.
    fn exhaust(&self, fixed: &[usize], candidates: &[usize]) -> Result<(Vec<usize>, Attempt), Failure> {
        let count = candidates.len().min(EXHAUSTIVE);
        let mut sets: Vec<u32> = (0..1u32 << count).collect();
        sets.sort_by_key(|set| (count as u32 - set.count_ones(), *set));
        let mut failure = Failure::Singular;
        for set in sets {
            let closed: Vec<bool> = (0..candidates.len()).map(|k| k >= count || set >> k & 1 == 1).collect();
            let rows = chosen(fixed, candidates, &closed);
            match self.attempt(&rows) {
                Ok(attempt)
                    if attempt.consistent
                        && (0..closed.len())
                            .all(|k| self.holds(candidates[k], closed[k], &rows, &attempt)) =>
                {
                    return Ok((rows, attempt));
                }
                Ok(attempt) if attempt.nullity > 0 => failure = Failure::Jammed,
                Ok(_) | Err(_) => {}
            }
        }
        Err(failure)
    }

    /// Whether a candidate's condition is met: λ ≥ 0 if closed, J a + b ≥ 0 if open.
    fn holds(&self, row: usize, closed: bool, rows: &[usize], attempt: &Attempt) -> bool {
        if closed {
            let reaction = rows.iter().position(|&r| r == row).map_or(0.0, |k| attempt.x[self.n + k]);
            reaction >= -self.tolerance
        } else {
            self.opening(row, &attempt.x) >= -self.tolerance
        }
    }

    fn finish(&self, fixed: &[usize], candidates: &[usize], rows: &[usize], attempt: Attempt) -> Solution {
        let tight: Vec<usize> = candidates
            .iter()
            .copied()
            .filter(|row| rows.contains(row) || self.opening(*row, &attempt.x).abs() <= self.tolerance)
            .collect();
        let all = chosen(fixed, &tight, &vec![true; tight.len()]);
        let unique = self.attempt(&all).map_or(attempt.nullity == 0, |full| full.nullity == 0);
        let (rows, x) =
            if unique { (rows.to_vec(), attempt.x) } else { self.least_norm(fixed, &tight, rows, attempt) };
        let mut balanced = DVector::zeros(self.scale.len() - self.n);
        for (k, &row) in rows.iter().enumerate() {
            balanced[row] = x[self.n + k];
        }
        let bears = |row: &usize| balanced[*row] > self.tolerance;
        Solution {
            accelerations: DVector::from_fn(self.n, |i, _| x[i] * self.scale[i]),
            bearing: tight.iter().copied().filter(bears).collect(),
            degenerate: tight.iter().copied().filter(|row| !bears(row)).collect(),
            reactions: DVector::from_fn(balanced.len(), |row, _| balanced[row] * self.scale[self.n + row]),
            unique,
        }
    }

    /// Of all λ ≥ 0 on the tight rows the shortest; on its support it is the shortest without the sign condition.
    fn least_norm(
        &self,
        fixed: &[usize],
        tight: &[usize],
        rows: &[usize],
        attempt: Attempt,
    ) -> (Vec<usize>, DVector<f64>) {
        let length = |rows: &[usize], x: &DVector<f64>| {
            (0..rows.len()).map(|k| (x[self.n + k] * self.scale[self.n + rows[k]]).powi(2)).sum::<f64>()
        };
        let mut best = (rows.to_vec(), attempt.x);
        let count = tight.len().min(EXHAUSTIVE);
        for set in 0..1u32 << count {
            let closed: Vec<bool> = (0..tight.len()).map(|k| k < count && set >> k & 1 == 1).collect();
            let rows = chosen(fixed, tight, &closed);
            if let Ok(attempt) = self.attempt(&rows)
                && attempt.consistent
                && tight.iter().zip(&closed).all(|(&row, &closed)| self.holds(row, closed, &rows, &attempt))
                && length(&rows, &attempt.x) < length(&best.0, &best.1)
            {
                best = (rows, attempt.x);
            }
        }
        best
    }
}

fn chosen(fixed: &[usize], candidates: &[usize], closed: &[bool]) -> Vec<usize> {
    let kept = candidates.iter().zip(closed).filter(|(_, closed)| **closed).map(|(row, _)| *row);
    let mut rows: Vec<usize> = fixed.iter().copied().chain(kept).collect();
    rows.sort_unstable();
    rows
}
