//! What is read of a run on the way, and in which phase: at an event that of the one behind it.

use crate::ReplayError;
use liftoff::EventKind;
use liftoff::{Output, Segment, Trajectory};

/// An output at a moment of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading<'a> {
    /// When.
    pub moment: Moment,
    /// What; none for the time itself.
    pub output: Option<&'a Output>,
}

/// When something is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moment {
    /// At this time, s, whatever is varied.
    Time(f64),
    /// Right behind an event, by its place in the run's list, whenever it is.
    Event(usize),
}

/// Where in a phase something is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Part {
    /// Behind the event that it begins with, at its time.
    Begin,
    /// At a given time.
    Within,
    /// At the event that ends the run, at its time.
    End,
}

/// A reading with its place among all and its place in the run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Located<'a> {
    pub(crate) output: Option<&'a Output>,
    pub(crate) place: usize,
    pub(crate) segment: usize,
    pub(crate) part: Part,
    pub(crate) t: f64,
}

/// All readings in the order of the run.
pub(crate) fn located<'a>(
    run: &Trajectory,
    segments: &[Segment],
    readings: &[Reading<'a>],
) -> Result<Vec<Located<'a>>, ReplayError> {
    let locate = |(place, reading): (usize, &Reading<'a>)| -> Result<Located<'a>, ReplayError> {
        let t = time(run, reading.moment)?;
        let segment = segments.partition_point(|segment| segment.t0 <= t).saturating_sub(1);
        let Segment { t0, t1, .. } = *segments.get(segment).ok_or(ReplayError::Empty)?;
        let part = match reading.moment {
            Moment::Time(_) => Part::Within,
            Moment::Event(_) if t <= t0 => Part::Begin,
            Moment::Event(_) if t >= t1 => Part::End,
            Moment::Event(_) => return Err(ReplayError::Event { t }),
        };
        Ok(Located { output: reading.output, place, segment, part, t })
    };
    let mut all = readings.iter().enumerate().map(locate).collect::<Result<Vec<_>, _>>()?;
    all.sort_by(|a, b| (a.segment, a.part).cmp(&(b.segment, b.part)).then(a.t.total_cmp(&b.t)));
    Ok(all)
}

fn time(run: &Trajectory, moment: Moment) -> Result<f64, ReplayError> {
    let [start, end] = run.interval();
    match moment {
        Moment::Time(t) if start <= t && t <= end => Ok(t),
        Moment::Time(t) => Err(ReplayError::Outside { t }),
        Moment::Event(k) => match run.events().get(k) {
            Some(event) if event.kind == EventKind::Touch => Err(ReplayError::Grazing { t: event.t }),
            Some(event) => Ok(event.t),
            None => Err(ReplayError::Outside { t: end }),
        },
    }
}
