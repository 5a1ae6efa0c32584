//! The equations of contact sets without a closed form: `M a + h = Q + Jᵀ λ`.

use super::phase::times;
use super::{PhaseEquations, Writer};
use crate::algebra::{Series, Symbol};
use crate::math::{Equation, Math};
use crate::motion::{Dense, contains};
use crate::phases::Phase;

/// The sets of more contacts than this are not gone through.
const MOST: usize = 6;

impl Writer<'_> {
    /// Those of each set, and those of all of them.
    pub(super) fn without_closed_form(
        &self,
        dense: &Dense,
        phases: &[Phase],
    ) -> (Vec<PhaseEquations>, Option<PhaseEquations>) {
        let contacts = self.analysis.motion.contacts.len();
        if contacts > MOST {
            return (Vec::new(), None);
        }
        let mut sets: Vec<u64> = (0..1 << contacts).collect();
        sets.retain(|set| phases.iter().all(|phase| phase.set != *set));
        sets.sort_by_key(|set| set.count_ones());
        let others: Vec<PhaseEquations> = sets.iter().map(|&set| self.multiplied(dense, set)).collect();
        let together = sets.iter().fold(0, |all, set| all | set);
        let general = (!sets.is_empty()).then(|| PhaseEquations {
            multipliers: others.iter().map(|other| other.closed.clone()).collect(),
            eliminated: Vec::new(),
            ..self.multiplied(dense, together)
        });
        (others, general)
    }

    /// The constraints of a set, `0 = g(q)`, and its equations of motion.
    fn multiplied(&self, dense: &Dense, set: u64) -> PhaseEquations {
        let motion = &self.analysis.motion;
        let rows: Vec<usize> = (0..motion.rows.len()).filter(|&row| motion.is_closed(row, set)).collect();
        let closed = self.labels(set);
        PhaseEquations {
            multipliers: vec![closed.clone()],
            closed,
            unclosed: self.unclosed(),
            eliminated: rows.iter().filter_map(|&row| self.constraint(row)).collect(),
            motion: (0..motion.n).map(|i| self.balance(dense, &rows, i)).collect(),
            ..PhaseEquations::default()
        }
    }

    /// Of a contact that it is closed, of a rough one that it does not slip; those of joints are known.
    fn constraint(&self, row: usize) -> Option<Equation> {
        let motion = &self.analysis.motion;
        let slips = motion.rows.len() - motion.tangents.len();
        let rates = |(i, j): (usize, &Series)| j * &Series::symbol(Symbol::rate(i));
        let zero = match row {
            _ if row < motion.contacts.len() => motion.rows[row].gap.clone(),
            _ if row < slips => return None,
            _ => motion.rows[row].jacobian.iter().enumerate().map(rates).sum(),
        };
        Some(Equation::new(Math::ZERO, self.series(&zero)))
    }

    fn balance(&self, dense: &Dense, rows: &[usize], i: usize) -> Equation {
        let mass = dense.mass[i].iter().enumerate();
        let terms = mass.filter(|(_, entry)| !entry.is_zero());
        let terms = terms.map(|(k, entry)| times(self.series(entry), self.symbol(Symbol::acceleration(k))));
        let velocity = &dense.velocity_terms[i];
        let velocity = (!velocity.is_zero()).then(|| self.series(velocity));
        let force = (!dense.forces[i].is_zero()).then(|| self.series(&dense.forces[i]));
        let reactions = rows.iter().map(|&row| (&self.analysis.motion.rows[row].jacobian[i], row));
        let reactions = reactions.filter(|(lever, _)| !lever.is_zero());
        let reactions = reactions.map(|(lever, row)| times(self.series(lever), self.multiplier(row)));
        let [left, right]: [Vec<Math>; 2] =
            [terms.chain(velocity).collect(), force.into_iter().chain(reactions).collect()];
        Equation::new(Math::sum(left), Math::sum(right))
    }

    /// `N(A)`, `R(A)`, `λ(hinge at A (x))`.
    fn multiplier(&self, row: usize) -> Math {
        let contacts = self.analysis.motion.contacts.len();
        let joint = row.checked_sub(contacts).and_then(|i| self.analysis.kinematics.joints.get(i));
        joint.map_or_else(|| self.row(row), |joint| Math::of("λ", &joint.name))
    }

    pub(super) fn labels(&self, set: u64) -> Vec<String> {
        let contacts = self.analysis.motion.contacts.iter().enumerate();
        let closed = contacts.filter(|(i, _)| contains(set, *i));
        closed.map(|(_, contact)| contact.label(&self.analysis.system)).collect()
    }
}
