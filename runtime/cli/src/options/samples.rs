//! Outputs at events and at other times, taken while a run goes on, so that the motion need not be kept.

use crate::options::clock::Clock;
use liftoff::{Instant, Observer, Output, Step, Trajectory};
use std::collections::VecDeque;

/// Outputs at one time.
pub struct Row {
    pub t: f64,
    pub values: Vec<f64>,
    /// Whether the clock asked for it, and not an event alone.
    pub is_requested: bool,
    /// Whether something happens then.
    pub is_event: bool,
    /// Whether it is the side before an event at which velocities jump; the row behind it has the side after.
    pub is_before: bool,
    /// Its place among the multiples of the clock.
    place: u64,
}

/// Takes outputs at events and at the times of a clock.
pub struct Samples<'a> {
    outputs: Vec<Output>,
    clock: Clock,
    /// Whether the run has begun.
    begun: bool,
    /// Times of events that are still to be shown.
    events: VecDeque<f64>,
    /// Times at which velocities jump; the last one alone unless all rows are taken at the end.
    jumps: Vec<f64>,
    rows: Vec<Row>,
    /// Whether an output depends on what the motion was before, so that all are taken at its end.
    waits: bool,
    /// What takes the rows, if they are not to be kept.
    sink: Option<&'a mut dyn FnMut(&Row)>,
}

impl Samples<'_> {
    pub fn new(outputs: Vec<Output>, clock: Clock) -> Self {
        let waits = outputs.iter().any(Output::reads_history);
        Self {
            outputs,
            clock,
            begun: false,
            events: VecDeque::new(),
            jumps: Vec::new(),
            rows: Vec::new(),
            waits,
            sink: None,
        }
    }

    /// Gives the rows to a function instead of keeping them; the clock must not be one that grows.
    pub fn into_sink(self, sink: &mut dyn FnMut(&Row)) -> Samples<'_> {
        let Self { outputs, clock, begun, events, jumps, rows, waits, .. } = self;
        Samples { outputs, clock, begun, events, jumps, rows, waits, sink: Some(sink) }
    }

    /// All rows of a run that has ended.
    pub fn finish(mut self, record: &Trajectory) -> Vec<Row> {
        let end = record.end_time();
        self.thin(end);
        let jumps = if self.waits { std::mem::take(&mut self.jumps) } else { Vec::new() };
        while let Some(t) = self.next().filter(|t| *t <= end) {
            let values = |is_before| {
                let instant = Instant { t, is_before };
                self.outputs.iter().map(|output| record.value_at(output, instant)).collect()
            };
            let (before, after) = (jumps.contains(&t).then(|| values(true)), values(false));
            before.into_iter().for_each(|values| self.take_before(t, values));
            self.take(t, after);
        }
        self.rows
    }

    fn next(&self) -> Option<f64> {
        self.events.front().copied().into_iter().chain(self.clock.next()).reduce(f64::min)
    }

    fn take(&mut self, t: f64, values: Vec<f64>) {
        let is_event = self.events.front() == Some(&t);
        let (is_requested, place) = (self.clock.next() == Some(t), self.clock.next_index());
        if is_event {
            self.events.pop_front();
        }
        if is_requested {
            self.clock.pass(t);
        }
        self.add(Row { t, values, is_requested, is_event, is_before: false, place });
    }

    /// The row before an event, asked for where the one after it is.
    fn take_before(&mut self, t: f64, values: Vec<f64>) {
        let (is_requested, place) = (self.clock.next() == Some(t), self.clock.next_index());
        self.add(Row { t, values, is_requested, is_event: true, is_before: true, place });
    }

    fn add(&mut self, row: Row) {
        match &mut self.sink {
            Some(sink) => sink(&row),
            None => self.rows.push(row),
        }
    }

    /// Leaves out rows that the clock asks for no more.
    fn thin(&mut self, end: f64) {
        let every = self.clock.reach(end);
        if every > 1 {
            for row in self.rows.iter_mut().filter(|row| row.is_requested) {
                row.is_requested = row.place % every == 0;
                row.place /= every;
            }
            self.rows.retain(|row| row.is_requested || row.is_event);
        }
    }
}

impl Observer for Samples<'_> {
    fn records(&self) -> bool {
        self.waits
    }

    fn event(&mut self, t: f64) {
        if !core::mem::replace(&mut self.begun, true) {
            self.clock.begin(t);
        }
        if self.events.back() != Some(&t) {
            self.events.push_back(t);
        }
    }

    fn jump(&mut self, before: &dyn Step) {
        let [_, t] = before.times();
        if self.jumps.last() == Some(&t) {
            return;
        }
        if !self.waits {
            self.jumps.clear();
            let values = before.values(&self.outputs, t);
            self.take_before(t, values);
        }
        self.jumps.push(t);
    }

    /// At the end of a step the next one, behind an event perhaps, has the values.
    fn step(&mut self, step: &dyn Step) {
        if self.waits {
            return;
        }
        let [_, end] = step.times();
        self.thin(end);
        while let Some(t) = self.next().filter(|t| *t < end) {
            let values = step.values(&self.outputs, t);
            self.take(t, values);
        }
    }
}

/// What looks at a run.
pub struct Observers<'a> {
    pub samples: Vec<&'a mut dyn Observer>,
    /// Whether the motion is kept too.
    pub keeps: bool,
}

impl Observer for Observers<'_> {
    fn records(&self) -> bool {
        self.keeps || self.samples.iter().any(|samples| samples.records())
    }

    fn is_blind(&self) -> bool {
        self.samples.is_empty()
    }

    fn event(&mut self, t: f64) {
        self.samples.iter_mut().for_each(|samples| samples.event(t));
    }

    fn jump(&mut self, before: &dyn Step) {
        self.samples.iter_mut().for_each(|samples| samples.jump(before));
    }

    fn step(&mut self, step: &dyn Step) {
        self.samples.iter_mut().for_each(|samples| samples.step(step));
    }
}
