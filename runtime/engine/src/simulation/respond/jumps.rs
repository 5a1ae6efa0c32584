//! Conditions that become true by a jump: impacts change rates, and a change of contacts, springs
//! or loads changes accelerations and reactions, at once. An equation is met by no jump: what
//! passes a value without having it does not have it.

use super::Next;
use crate::event::{EventKind, Guard, Note};
use crate::expression::Relation;
use crate::model::ContactSet;
use crate::numerics::zero::SOLVED;
use crate::simulation::RunCause;
use crate::simulation::awaited::Role;
use crate::simulation::snapshot::Snapshot;

/// What conditions are about before an event.
pub(crate) struct Before {
    /// How far each condition holds: above 0 where it does.
    margins: Vec<Option<f64>>,
    state: Vec<f64>,
    closed: ContactSet,
}

impl Snapshot<'_> {
    /// What is to be compared with what an event leaves; nothing where no condition can jump.
    pub(in crate::simulation) fn before_event(&self) -> Option<Before> {
        let jumps = self.awaited.conditions.iter().any(|condition| condition.relation() != Relation::Equal);
        jumps.then(|| Before { margins: self.margins(), state: self.state.clone(), closed: self.closed() })
    }

    /// Does what conditions ask for that the event has made true. Those that it was the root of are
    /// done with.
    pub(in crate::simulation) fn follow_jumps(
        &mut self,
        before: Option<Before>,
        roots: &[Guard],
    ) -> Result<Next, RunCause> {
        let Some(before) = before else { return Ok(Next::Continue) };
        let is_root = |k: &usize| roots.contains(&Guard::Condition(*k));
        let mut done: Vec<usize> = self.awaited.places().filter(is_root).collect();
        while self.state != before.state || self.closed() != before.closed {
            let margins = self.margins();
            let met = (0..margins.len()).find(|k| {
                let (Some(from), Some(to)) = (before.margins[*k], margins[*k]) else { return false };
                from <= 0.0 && to > SOLVED * from.abs() && self.is_awaited(*k) && !self.is_done(*k, &done)
            });
            let Some(met) = met else { break };
            done.push(met);
            match self.awaited.role(met) {
                Role::Stop => {
                    let note = Note::Condition(self.awaited.conditions[met].clone());
                    self.record(EventKind::Stop, ContactSet::EMPTY, Some(note));
                    return Ok(Next::Finished);
                }
                Role::Planned(entry) => self.execute(&[entry])?,
                Role::Switch { switch, arms } => self.switch(&[(switch, arms)])?,
                Role::Domain(domain) => return Err(self.left(domain)),
            }
        }
        Ok(Next::Continue)
    }

    /// Whether a condition, or that of the same switch which is its opposite, has been met.
    fn is_done(&self, condition: usize, done: &[usize]) -> bool {
        let switch = |k: usize| match self.awaited.role(k) {
            Role::Switch { switch, .. } => Some(switch),
            _ => None,
        };
        done.iter().any(|&k| k == condition || switch(k).is_some() && switch(k) == switch(condition))
    }

    /// How far each condition holds; nothing of equations.
    fn margins(&self) -> Vec<Option<f64>> {
        let (context, point) = (&self.setup.context, self.point());
        self.awaited.conditions.iter().map(|condition| condition.margin(context, &point)).collect()
    }
}
