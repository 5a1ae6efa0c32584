//! All combinations of modes, one after the other: every solution is found.

use super::modes::ModeChoice;
use super::problem::{BalancedProblem, Candidate, Trial};
use crate::contact::trials::LcpError;

/// Up to this many combinations all are tried at once.
pub(super) const FEW: usize = 1024;
/// More are tried only where pivoting finds no solution, and no more than these.
const MOST: usize = 1 << 16;

impl BalancedProblem<'_> {
    fn combinations(&self) -> Option<usize> {
        self.units.iter().try_fold(1usize, |count, unit| count.checked_mul(unit.choices.len()))
    }

    pub(super) fn is_small(&self) -> bool {
        self.combinations().is_some_and(|count| count <= FEW)
    }

    /// The solutions among all combinations.
    pub(super) fn enumerate(&self) -> Result<Vec<Candidate>, LcpError> {
        let count = self.combinations().filter(|&count| count <= MOST).ok_or(LcpError::Exhausted)?;
        let mut found = Vec::new();
        for number in 0..count {
            self.question.rows.attempt()?;
            let chosen = self.combination(number);
            if let Some(trial) = self.verified(&chosen)? {
                found.push(Candidate { acting: self.modes(&chosen), chosen, trial });
            }
        }
        Ok(found)
    }

    /// Reads a number in the mixed radix of the contacts' modes.
    fn combination(&self, mut number: usize) -> Vec<usize> {
        let mut digit = |radix: usize| {
            let digit = number % radix;
            number /= radix;
            digit
        };
        self.units.iter().map(|unit| digit(unit.choices.len())).collect()
    }

    /// The motion of some modes if it meets all conditions.
    pub(super) fn verified(&self, chosen: &[usize]) -> Result<Option<Trial>, LcpError> {
        let choices: Vec<&ModeChoice> =
            self.units.iter().zip(chosen).map(|(unit, &k)| &unit.choices[k]).collect();
        let trial = self.attempt(&choices)?;
        let meets = |trial: &Trial| {
            self.units.iter().zip(&choices).all(|(unit, choice)| self.holds(unit, choice, trial))
        };
        Ok(trial.filter(meets))
    }
}
