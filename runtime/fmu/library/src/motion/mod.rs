//! A run of the engine in progress, for co-simulation. It is computed on a thread of its own, as
//! far as it has been asked for, and is the run that the engine makes without being stopped on the
//! way: the same steps, the same events, bit by bit.

mod observer;

use crate::place::Instant;
use liftoff::{RunError, Simulation};
use liftoff_studio::registry::chain;
use observer::Paced;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::{Builder, JoinHandle};

/// What the run is asked for.
#[derive(Debug, Clone, Copy)]
enum Request {
    /// The motion at a time, or at the first event before.
    To(f64),
    /// The motion after what happens where it is.
    After,
}

/// What it has come to.
#[derive(Debug)]
enum Reply {
    /// What was asked for.
    Reached(Instant),
    /// An event, before it.
    Event(Instant),
}

/// Where a motion has come to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arrival {
    /// To the time that was asked for.
    Reached,
    /// To an event, which has not been passed.
    Event,
    /// To its end, which is before the time that was asked for: a stop was reached.
    Ended,
}

/// A run in progress.
pub(crate) struct Motion {
    simulation: Simulation,
    place: Instant,
    /// Whether it is before an event that has not been passed.
    waits: bool,
    requests: Option<Sender<Request>>,
    replies: Receiver<Reply>,
    cancel: Arc<AtomicBool>,
    thread: Option<JoinHandle<Result<(), RunError>>>,
    /// Why it came no further.
    failure: Option<String>,
}

/// The engine recurses as deep as expressions are.
const STACK: usize = 16 << 20;

impl Motion {
    /// Begins a run, which ends at a time at the latest.
    ///
    /// # Errors
    /// There is no motion from this start.
    pub(crate) fn begin(simulation: &Simulation, limit: f64) -> Result<Self, String> {
        let (requests, asked) = channel();
        let (answers, replies) = channel();
        let cancel = Arc::new(AtomicBool::new(false));
        let simulation = simulation.clone().limit(limit).cancel(Arc::clone(&cancel));
        let run = simulation.clone();
        let body = move || {
            let mut paced = Paced::new(asked, answers, limit);
            run.observe(&mut paced).map(|_| paced.finish())
        };
        let thread = Builder::new().name("liftoff".to_owned()).stack_size(STACK).spawn(body);
        let mut thread = Some(thread.map_err(|error| error.to_string())?);
        match first(&requests, &replies) {
            Some(place) => Ok(Self {
                simulation,
                place,
                waits: false,
                requests: Some(requests),
                replies,
                cancel,
                thread,
                failure: None,
            }),
            None => Err(reason(&mut thread).unwrap_or_else(|| "the motion ends where it starts".to_owned())),
        }
    }

    pub(crate) fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Where it is.
    pub(crate) fn instant(&self) -> &Instant {
        &self.place
    }

    /// Moves on to a time, or to the first event before.
    ///
    /// # Errors
    /// The run failed on the way.
    pub(crate) fn to(&mut self, t: f64) -> Result<Arrival, String> {
        self.ask(Request::To(t))
    }

    /// Passes the event that it has come to, if it is at one.
    ///
    /// # Errors
    /// The run failed there.
    pub(crate) fn pass(&mut self) -> Result<Arrival, String> {
        if self.waits { self.ask(Request::After) } else { Ok(Arrival::Reached) }
    }

    /// Asks the run; once it has failed it fails the same way again.
    fn ask(&mut self, request: Request) -> Result<Arrival, String> {
        if self.failure.is_none() {
            match self.reply(request) {
                Ok(arrival) => return Ok(arrival),
                Err(failure) => self.failure = Some(failure),
            }
        }
        Err(self.failure.clone().unwrap_or_default())
    }

    fn reply(&mut self, request: Request) -> Result<Arrival, String> {
        let sent = self.requests.as_ref().is_some_and(|requests| requests.send(request).is_ok());
        let reply = if sent { self.replies.recv().ok() } else { None };
        let (place, arrival) = match reply {
            Some(Reply::Reached(place)) => (place, Arrival::Reached),
            Some(Reply::Event(place)) => (place, Arrival::Event),
            None => return reason(&mut self.thread).map_or(Ok(Arrival::Ended), Err),
        };
        refuse_lost(&place)?;
        (self.place, self.waits) = (place, arrival == Arrival::Event);
        Ok(arrival)
    }
}

/// Refuses what is no number: the engine does so at the ends of steps.
fn refuse_lost(place: &Instant) -> Result<(), String> {
    match place.state.iter().all(|x| x.is_finite()) {
        true => Ok(()),
        false => Err(format!("the motion is no number at t = {}", place.t)),
    }
}

/// The place of the start, after what happens there.
fn first(requests: &Sender<Request>, replies: &Receiver<Reply>) -> Option<Instant> {
    requests.send(Request::After).ok()?;
    match replies.recv().ok()? {
        Reply::Reached(place) | Reply::Event(place) => Some(place),
    }
}

/// Why a run has come to its end, if that was no stop.
fn reason(thread: &mut Option<JoinHandle<Result<(), RunError>>>) -> Option<String> {
    match thread.take()?.join() {
        Ok(Ok(())) => None,
        Ok(Err(error)) => Some(chain(&error)),
        Err(_) => Some("the engine has failed: this is a mistake of liftoff".to_owned()),
    }
}

impl Drop for Motion {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
        self.requests = None;
        reason(&mut self.thread);
    }
}
