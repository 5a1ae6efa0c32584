//! Members run by the model's own type.

use super::cell::{Cell, Outcome};
use super::observation::{Observation, What, Which};
use crate::catalog::{chain, simulation};
use crate::ensemble::{Ensemble, MemberError, Motion};
use crate::event::{Event, EventKind};
use crate::model::BarSystem;
use crate::occurrence::Occurrence;
use crate::output::Output;
use crate::scene::Setup;
use crate::simulation::Simulation;
use crate::trajectory::Trajectory;
use std::sync::atomic::AtomicBool;

/// The members of a sweep, for the model to run.
pub struct Members<'a> {
    pub(super) count: usize,
    pub(super) setup: &'a (dyn Fn(usize) -> Setup + Sync),
    pub(super) observations: &'a [Observation],
    /// Is told what was read of each, from any thread.
    pub(super) told: &'a (dyn Fn(usize, Outcome) + Sync),
    /// Begins no more once this is true.
    pub(super) cancel: &'a AtomicBool,
}

const NONE: &str = "none";

impl Members<'_> {
    /// Runs them on the threads of the current pool.
    pub(crate) fn run<M: BarSystem>(&self) {
        let ensemble = Ensemble::of(self.count, |i| self.prepared::<M>(i)).cancel(self.cancel);
        let ends: Option<Vec<Output>> =
            self.observations.iter().map(|observation| observation.at_end().cloned()).collect();
        match ends {
            Some(outputs) => ensemble.outputs(outputs).each_end(&|i, end| {
                let read = |values: Vec<f64>| values.into_iter().map(Cell::Number).collect();
                self.tell(i, end.map(|member| read(member.outputs)));
            }),
            None => ensemble.each_motion(&|i, motion: Motion<M>| {
                let read = |run: &Trajectory<M>| self.observations.iter().map(|o| o.read(run)).collect();
                self.tell(i, motion.as_ref().map(read).map_err(Clone::clone));
            }),
        }
    }

    fn tell(&self, i: usize, outcome: Result<Vec<Cell>, MemberError>) {
        (self.told)(i, outcome.map_err(|error| chain(&error).replace('\n', " ")));
    }

    /// A member that ends as soon as all has been seen that is observed.
    fn prepared<M: BarSystem>(&self, i: usize) -> Result<Simulation<M>, MemberError> {
        let asked = simulation::<M>(&(self.setup)(i));
        let mut simulation = asked.map_err(|failure| MemberError::Asked(failure.to_string()))?;
        let enough: Option<Vec<Occurrence>> = self.observations.iter().map(Observation::suffices).collect();
        for Occurrence { kind, support } in enough.into_iter().flatten() {
            simulation = simulation.until_event(kind, support)?;
        }
        Ok(simulation)
    }
}

impl Observation {
    fn read<M: BarSystem>(&self, run: &Trajectory<M>) -> Cell {
        let range = |output: &Output| run.range(output);
        let number = |value: Option<f64>| value.map_or(Cell::Missing, Cell::Number);
        match &self.what {
            What::Ending => Cell::Name(run.events().last().map_or(NONE.to_owned(), ending)),
            What::End(output) => Cell::Number(run.value(output, run.end_time())),
            What::Greatest(output) => number(range(output).map(|[_, greatest]| greatest)),
            What::Least(output) => number(range(output).map(|[least, _]| least)),
            What::Count(occurrence) => {
                Cell::Number(run.events().iter().filter(|event| occurrence.is(event)).count() as f64)
            }
            What::Supports(which, occurrence) => {
                Cell::Name(which.of(run.events(), occurrence).map_or(NONE.to_owned(), subject))
            }
            What::Value(which, occurrence, output) => {
                number(which.of(run.events(), occurrence).map(|event| run.value(output, event.t)))
            }
        }
    }
}

impl Which {
    fn of<'a>(self, events: &'a [Event], occurrence: &Occurrence) -> Option<&'a Event> {
        let mut found = events.iter().filter(|event| occurrence.is(event));
        if self == Self::First { found.next() } else { found.next_back() }
    }
}

/// Which supports, or else what there is to say.
fn subject(event: &Event) -> String {
    match (&event.supports[..], &event.note) {
        ([], Some(note)) => note.clone(),
        ([], None) => event.kind.to_string(),
        (supports, _) => supports.join(", "),
    }
}

fn ending(event: &Event) -> String {
    match event.kind {
        EventKind::End => "end".into(),
        kind => format!("{kind}: {}", subject(event)),
    }
}
