//! Members of a sweep.

use super::cell::{Cell, Outcome};
use super::observation::{Observation, ObservedQuantity};
use crate::registry::{Entry, chain};
use crate::run_spec::RunSpec;
use liftoff::EventFilter;
use liftoff::Output;
use liftoff::Simulation;
use liftoff::Trajectory;
use liftoff::ensemble::{Ensemble, MemberError, Motion};
use liftoff::{Event, EventKind};
use std::sync::atomic::AtomicBool;

/// The members of a sweep.
pub(super) struct Members<'a> {
    pub(super) count: usize,
    pub(super) spec: &'a (dyn Fn(usize) -> RunSpec + Sync),
    pub(super) observations: &'a [Observation],
    /// Called with what was read of each member, from any thread.
    pub(super) on_result: &'a (dyn Fn(usize, Outcome) + Sync),
    /// Begins no more once this is true.
    pub(super) cancel: &'a AtomicBool,
}

const NONE: &str = "none";

impl Members<'_> {
    /// Runs them on the threads of the current pool.
    pub(super) fn run(&self, model: &Entry) {
        let ensemble = Ensemble::new(self.count, |i| self.prepared(model, i));
        let ensemble = match model.lanes() {
            Some(lanes) => ensemble.side_by_side(lanes),
            None => ensemble,
        };
        let ensemble = ensemble.cancel(self.cancel);
        let ends: Option<Vec<Output>> =
            self.observations.iter().map(|observation| observation.at_end().cloned()).collect();
        match ends {
            Some(outputs) => ensemble.outputs(outputs).each_end(&|i, end| {
                let read = |values: Vec<f64>| values.into_iter().map(Cell::Number).collect();
                self.report(i, end.map(|member| read(member.outputs)));
            }),
            None => ensemble.each_motion(&|i, motion: Motion| {
                let read = |run: &Trajectory| self.observations.iter().map(|o| o.evaluate(run)).collect();
                self.report(i, motion.as_ref().map(read).map_err(Clone::clone));
            }),
        }
    }

    fn report(&self, i: usize, outcome: Result<Vec<Cell>, MemberError>) {
        (self.on_result)(i, outcome.map_err(|error| chain(&error).replace('\n', " ")));
    }

    /// A member that ends as soon as all has been seen that is observed.
    fn prepared(&self, model: &Entry, i: usize) -> Result<Simulation, MemberError> {
        let simulation = model.simulation(&(self.spec)(i));
        let mut simulation = simulation.map_err(|failure| MemberError::Asked(failure.to_string()))?;
        let enough: Option<Vec<EventFilter>> = self.observations.iter().map(Observation::suffices).collect();
        for EventFilter { kind, support } in enough.into_iter().flatten() {
            simulation = simulation.until_event(kind, support)?;
        }
        Ok(simulation)
    }
}

impl Observation {
    fn evaluate(&self, run: &Trajectory) -> Cell {
        let range = |output: &Output| run.range(output);
        let number = |value: Option<f64>| value.map_or(Cell::Missing, Cell::Number);
        // Of conditions that are written in several lines: journals are read line by line.
        let name = |text: String| Cell::Name(text.replace('\n', " "));
        match &self.quantity {
            ObservedQuantity::Ending => name(run.events().last().map_or(NONE.to_owned(), ending)),
            ObservedQuantity::End(output) => Cell::Number(run.value(output, run.end_time())),
            ObservedQuantity::Greatest(output) => number(range(output).map(|[_, greatest]| greatest)),
            ObservedQuantity::Least(output) => number(range(output).map(|[least, _]| least)),
            ObservedQuantity::Count(filter) => {
                Cell::Number(run.events().iter().filter(|event| filter.is(event)).count() as f64)
            }
            ObservedQuantity::Supports(which, filter) => {
                let found = which.find(run.events(), filter).map(|k| &run.events()[k]);
                name(found.map_or(NONE.to_owned(), subject))
            }
            ObservedQuantity::Value(which, filter, output) => {
                let found = which.find(run.events(), filter).map(|k| &run.events()[k]);
                number(found.map(|event| run.value(output, event.t)))
            }
        }
    }
}

/// Which supports, or else what there is to say.
fn subject(event: &Event) -> String {
    match (&event.supports[..], &event.note) {
        ([], Some(note)) => note.to_string(),
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
