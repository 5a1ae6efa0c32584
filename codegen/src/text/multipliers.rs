//! The equations of contact sets without a closed form: `M a + h = Q + Jᵀ λ`.

use super::phase::times;
use super::{PhaseEquations, TextWriter};
use crate::algebra::Symbol;
use crate::math::{Equation, Math};
use crate::motion::{ClosedSet, Contact, Dense, contains};
use crate::phases::Phase;

/// The sets of more contacts than this are not gone through.
const MOST: usize = 6;

impl TextWriter<'_> {
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
        let mut sets = self.analysis.motion.sets(contacts);
        sets.retain(|set| phases.iter().all(|phase| phase.set != *set));
        let others: Vec<PhaseEquations> = sets.iter().map(|&set| self.multiplied(dense, set)).collect();
        let either = |all: ClosedSet, set: &ClosedSet| ClosedSet {
            closed: all.closed | set.closed,
            stick: all.stick | set.stick,
        };
        let together = sets.iter().fold(ClosedSet::default(), either);
        let general = (!sets.is_empty()).then(|| PhaseEquations {
            multipliers: others.iter().map(|other| other.closed.clone()).collect(),
            eliminated: Vec::new(),
            ..self.multiplied(dense, together)
        });
        (others, general)
    }

    /// The constraints of a set, `0 = g(q)`, and its equations of motion.
    fn multiplied(&self, dense: &Dense, set: ClosedSet) -> PhaseEquations {
        let motion = &self.analysis.motion;
        let rows: Vec<usize> = (0..motion.rows.len()).filter(|&row| motion.is_closed(row, set)).collect();
        let slips = motion.sliding(set).map(|(_, row)| row);
        let acting: Vec<usize> = rows.iter().copied().chain(slips).collect();
        let closed = self.labels(set);
        PhaseEquations {
            multipliers: vec![closed.clone()],
            closed,
            unclosed: self.unclosed(),
            eliminated: rows.iter().filter_map(|&row| self.constraint(row)).collect(),
            motion: (0..motion.n).map(|i| self.balance(dense, &acting, i)).collect(),
            reactions: rows
                .iter()
                .filter_map(|&row| self.total(row))
                .chain(self.lengths(set))
                .chain(self.frictions(set))
                .collect(),
            ..PhaseEquations::default()
        }
    }

    /// Of a contact that it is closed, of one that is rough or sticks that it does not slip; those
    /// of joints are known.
    fn constraint(&self, row: usize) -> Option<Equation> {
        let motion = &self.analysis.motion;
        let zero = match row {
            _ if row < motion.contacts.len() => motion.rows[row].gap.clone(),
            _ if row < motion.slips() => return None,
            _ => motion.rows[row].velocity(),
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
        joint.map_or_else(|| self.row(row), |joint| Math::named("λ", &joint.name))
    }

    /// `R(A) = −μ N(A) sgn v(A)` of each contact that slides, of a guide with `N(A) sgn N(A)`.
    pub(super) fn frictions(&self, set: ClosedSet) -> impl Iterator<Item = Equation> + '_ {
        let motion = &self.analysis.motion;
        motion.sliding(set).filter_map(|(contact, row)| {
            let mu = self.series(&motion.contacts[contact].friction.as_ref()?.kinetic);
            let contact_of = &motion.contacts[contact];
            let label = contact_of.label(&self.analysis.system);
            let side =
                (contact_of.two_sided && contact_of.force.is_none()).then(|| Math::named("sgn N", &label));
            let factors =
                [mu, self.row(contact)].into_iter().chain(side).chain([Math::named("sgn v", &label)]);
            Some(Equation::new(self.row(row), Math::product(factors).minus()))
        })
    }

    /// `N(A) = √(fx(A, AB)² + fy(A, AB)²)` of each hinge with friction, and its law where it
    /// slides.
    fn lengths(&self, set: ClosedSet) -> impl Iterator<Item = Equation> + '_ {
        let motion = &self.analysis.motion;
        let closed = motion.contacts.iter().enumerate().filter(move |(i, _)| contains(set.closed, *i));
        let slides = |set: ClosedSet| ClosedSet { stick: 0, ..set };
        let laws = self.frictions(slides(set)).filter(move |_| motion.has_hinges() && set.stick != 0);
        let lengths = closed.filter_map(|(i, contact)| {
            let squares = contact.force?.map(|entry| {
                let (what, of) = motion.quantities[entry].name.split_at(2);
                let component = if what == "fx" { "fx" } else { "fy" };
                Math::named(component, of.trim_matches(['(', ')'])).power(2)
            });
            Some(Equation::new(self.row(i), Math::Root(Box::new(Math::sum(squares)))))
        });
        lengths.chain(laws)
    }

    /// The closed contacts, of those with friction whether they stick.
    pub(super) fn labels(&self, set: ClosedSet) -> Vec<String> {
        let contacts = self.analysis.motion.contacts.iter().enumerate();
        let closed = contacts.filter(|(i, _)| contains(set.closed, *i));
        let label = |(i, contact): (usize, &Contact)| {
            let label = contact.label(&self.analysis.system);
            match contact.friction {
                None => label,
                Some(_) if contains(set.stick, i) => format!("{label} sticking"),
                Some(_) => format!("{label} sliding"),
            }
        };
        closed.map(label).collect()
    }
}
