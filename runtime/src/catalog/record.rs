//! A motion seen through the names of its model.

use super::failure::input;
use super::{Failure, Record, Still};
use crate::model::{BarSystem, Layout};
use crate::moment::state_at;
use crate::{Event, Extremum, LogEntry, Output, Segment, Statistics, Trajectory};

impl<M: BarSystem> Record for Trajectory<M> {
    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn events(&self) -> &[Event] {
        self.events()
    }

    fn interval(&self) -> [f64; 2] {
        [self.start_time(), self.end_time()]
    }

    fn segments(&self) -> Vec<Segment> {
        self.segments()
    }

    fn still(&self, t: f64) -> Still {
        Still::at::<M>(self.parameters(), &self.scene.constants, &state_at::<M>(&self.state(t), t))
    }

    fn times(&self) -> Vec<f64> {
        self.times()
    }

    fn state(&self, t: f64) -> Vec<f64> {
        self.state(t)
    }

    fn output<'a>(&'a self, text: &str) -> Result<Box<dyn Fn(f64) -> f64 + 'a>, Failure> {
        let output = Output::parse::<M>(text).map_err(input)?;
        Ok(Box::new(move |t| self.value(&output, t)))
    }

    fn extrema(&self, text: &str) -> Result<Vec<Extremum>, Failure> {
        Ok(self.extrema(&Output::parse::<M>(text).map_err(input)?))
    }

    fn log(&self) -> &[LogEntry] {
        self.log()
    }

    fn statistics(&self) -> Statistics {
        self.statistics()
    }
}
