//! Phases that are first integrated on trial: those that begin where contacts depend on each other.
//! What sinks in the trial takes the place of the one it depends on most.

use super::Driver;
use crate::simulation::RunCause;
use crate::simulation::phase_run::{PhaseOutcome, Termination};

impl Driver<'_> {
    /// Takes contacts to bear with which none of the others sinks, if there are such.
    pub(super) fn bear_what_sinks(&mut self) -> Result<(), RunCause> {
        let mut tried = Vec::new();
        while !tried.contains(&self.now.active_basis()) && self.now.is_singular() {
            tried.push(self.now.active_basis());
            let PhaseOutcome { end, counts, state, .. } = self.integrate(true);
            self.trajectory.statistics.add(counts);
            self.spend(counts, 0)?;
            let Termination::Event(_) = end else { return Ok(()) };
            let sunk = self.now.deepest_dependent(&state);
            let Some(bearing) = sunk.and_then(|sunk| self.now.exchanged(sunk)) else { return Ok(()) };
            self.respond(|now| now.bear(bearing))?;
        }
        Ok(())
    }
}
