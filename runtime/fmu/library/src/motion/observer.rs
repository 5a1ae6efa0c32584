//! The engine's side: an observer that lets the run go on as far as it is asked for.
//!
//! Events between steps are told before the next step begins; the state before them is that at the
//! end of the last step. Touches, which change nothing, are told before the step that they are in.

use super::{Reply, Request};
use crate::place::Instant;
use liftoff::{Observer, Step};
use std::sync::mpsc::{Receiver, Sender};

pub(super) struct Paced {
    requests: Receiver<Request>,
    replies: Sender<Reply>,
    /// What is asked for; none once nobody asks any more.
    asked: Option<Request>,
    /// The end of the last step.
    last: Option<Instant>,
    /// The event that was told last.
    told: Option<f64>,
    /// Touches within the step that comes.
    touches: Vec<f64>,
    events: i32,
    limit: f64,
}

impl Paced {
    pub(super) fn new(requests: Receiver<Request>, replies: Sender<Reply>, limit: f64) -> Self {
        let (last, told, touches) = (None, None, Vec::new());
        let mut paced = Self { requests, replies, asked: None, last, told, touches, events: 0, limit };
        paced.wait();
        paced
    }

    fn wait(&mut self) {
        self.asked = self.requests.recv().ok();
    }

    fn answer(&mut self, reply: Reply) {
        self.asked = match self.replies.send(reply) {
            Ok(()) => self.requests.recv().ok(),
            Err(_) => None,
        };
    }

    /// Where a step is at a time.
    fn interpolate(&self, step: &dyn Step, t: f64) -> Instant {
        Instant { t, state: step.state(t), phase: step.phase(), events: self.events }
    }

    /// The first touch of this step up to a time.
    fn touch(&mut self, until: f64) -> Option<f64> {
        let first = self.touches.iter().position(|touch| *touch <= until)?;
        Some(self.touches.remove(first))
    }

    /// The end of a run that reached its limit: nothing happens there but that.
    pub(super) fn finish(mut self) {
        while let Some(last) = self.last.clone().filter(|last| self.asked.is_some() && last.t >= self.limit) {
            self.answer(Reply::Reached(last));
        }
    }
}

impl Observer for Paced {
    fn event(&mut self, t: f64) {
        let Some(last) = &self.last else { return };
        if t >= self.limit {
            return;
        }
        if t > last.t {
            self.touches.push(t);
            return;
        }
        self.events = self.events.saturating_add(1);
        if self.told != Some(t) {
            self.told = Some(t);
            let before = last.clone();
            if let Some(Request::To(_)) = self.asked {
                self.answer(Reply::Event(before));
            }
        }
    }

    fn step(&mut self, step: &dyn Step) {
        let [begin, end] = step.times();
        loop {
            match self.asked {
                None => return,
                Some(Request::After) => {
                    let t = self.told.map_or(begin, |told| told.max(begin));
                    let place = self.interpolate(step, t);
                    self.answer(Reply::Reached(place));
                }
                Some(Request::To(t)) => {
                    if let Some(touch) = self.touch(t) {
                        let before = self.interpolate(step, touch);
                        (self.events, self.told) = (self.events.saturating_add(1), Some(touch));
                        self.answer(Reply::Event(before));
                    } else if t < end {
                        let place = self.interpolate(step, t.max(begin));
                        self.answer(Reply::Reached(place));
                    } else {
                        break;
                    }
                }
            }
        }
        self.last = Some(self.interpolate(step, end));
    }
}
