//! The shortest of the reactions within the cones of friction, where they are not unique.

use nalgebra::DVector;

use super::decision::FrictionSolution;
use super::problem::FrictionProblem;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::shares::{Factor, share};

impl EquilibratedKkt {
    /// λ of every row, the shortest of those that hold the motion of a solution; in impacts with
    /// what is given, those found.
    pub(crate) fn share_with_friction(
        &self,
        question: &FrictionProblem,
        found: &FrictionSolution,
    ) -> DVector<f64> {
        let reactions = &found.solution.reactions;
        let given = question.contacts.iter().any(|contact| contact.given.is_some());
        if found.solution.unique || !found.determined || given {
            return reactions.clone();
        }
        let (rows, factors) = factors(question, found);
        let mut shared = reactions.clone();
        let sided = question.contacts.iter().zip(&found.modes).filter(|(_, mode)| mode.side() < 0.0);
        let negative: Vec<usize> = sided.map(|(contact, _)| contact.normal).collect();
        share(self.closed_rows(rows), factors, &negative, (shared.as_mut_slice(), &mut None));
        shared
    }
}

/// The rows that bear, with tangents of contacts that slide, and K.
fn factors(question: &FrictionProblem, found: &FrictionSolution) -> (Vec<usize>, Vec<Factor>) {
    let mut rows: Vec<usize> = Vec::new();
    let mut factors = Vec::new();
    let contacts = question.contacts.iter().zip(&found.modes);
    for (contact, mode) in contacts.filter(|(_, mode)| mode.is_closed()) {
        let (normal, tangent) = (rows.len(), rows.len() + 1);
        rows.extend([contact.normal, contact.tangent]);
        factors.push(match mode.sense() {
            Some(sense) => Factor::Edge { normal, tangent, slope: -sense.sign() * contact.mu },
            None => Factor::Cone { normal, tangent, limit: contact.limit },
        });
    }
    let others: Vec<usize> = found.solution.tight.iter().copied().filter(|row| !rows.contains(row)).collect();
    for row in others {
        let place = rows.len();
        rows.push(row);
        if question.rows.candidates.contains(&row) {
            factors.push(Factor::Pressing(place));
        }
    }
    (rows, factors)
}
