//! Impact without collision: a contact slides with ġ = 0 and no reaction satisfies Coulomb's law
//! (Painlevé's paradox). The compression of a stiff contact then grows however stiff it is, until
//! the slip has ended (Lecornu, *Sur la loi de Coulomb*, C. R. Acad. Sci. 140, 1905; Génot and
//! Brogliato, *New results on Painlevé paradoxes*, Eur. J. Mech. A 18, 1999): the limit is Routh's
//! path from ġ = 0. Where others are pressed on the way, all answer at once: besides none at all
//! the compression from ġ = 0 has other impulses that satisfy its law, and those are taken. Guides
//! answer with all others at once.

use super::super::super::impact::Stages;
use super::super::super::impulse::{Collision, CollisionError, Outcome};
use super::super::super::trials::Trials;
use super::super::stability::{Sliding, painleve};
use super::ImpactFriction;
use super::at_once::SolutionFilter;

impl Collision {
    /// The impulse that ends a slip which no reaction holds. All contacts have ġ = 0: approaches
    /// are none. Of several contacts that slide the one deepest in the paradox, with the least W_NN
    /// − σ μ W_Nt relative to W_NN, is tried first. `Jammed` where no impulse changes the motion.
    pub fn tangential_impact(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        self.check()?;
        let mut stages = Stages::new(self, Trials::up_to(most_trials));
        for &row in &stages.candidates {
            stages.approach[row] = stages.approach[row].max(0.0);
        }
        let alone = if stages.has_guides() { Vec::new() } else { stages.sliding() };
        for contact in alone {
            if let Some(outcome) = stages.path_of(contact.normal, Some(contact))?
                && !outcome.acting.is_empty()
            {
                return Ok(outcome);
            }
        }
        stages.moved()
    }
}

impl Stages<'_> {
    /// Contacts that slide, those deepest in the paradox first.
    fn sliding(&self) -> Vec<ImpactFriction> {
        let held = self.choice().rows(&[]);
        let depth = |it: &ImpactFriction| {
            let signed_mu = it.mu * self.approach[it.tangent].signum();
            let sliding = Sliding { normal: it.normal, tangent: it.tangent, signed_mu };
            let (mass, jacobian) = (&self.collision.mass, &self.collision.jacobian);
            let with = |sliding: Sliding| painleve(mass, jacobian, sliding, &held, &[]);
            Some(with(sliding)? / with(Sliding { signed_mu: 0.0, ..sliding })?)
        };
        let slides = |it: &ImpactFriction| self.approach[it.tangent] != 0.0;
        let contacts = self.collision.rubbing().into_iter().filter(slides);
        let mut contacts: Vec<_> = contacts.filter_map(|it| Some((depth(&it)?, it))).collect();
        contacts.sort_by(|a, b| a.0.total_cmp(&b.0));
        contacts.into_iter().map(|(_, it)| it).collect()
    }

    /// All contacts at once, with impulses that change the motion.
    fn moved(&self) -> Result<Outcome, CollisionError> {
        let first = self.stage(&self.approach, &self.at_rest(), SolutionFilter::Moved)?;
        let departs = self.candidates.iter().any(|&row| self.approach[row] > 0.0);
        let law = self.law_of(&first.acting(&self.candidates), departs)?;
        if !law.has_phases() {
            return Ok(self.outcome_of(first, law, None));
        }
        let second = self.expansion(&first, 1.0)?;
        Ok(self.outcome_of(second, law, Some((first.rates, first.impulses))))
    }
}
