//! A case judged.

use super::case::Case;
use crate::judgement::found;
use serde::Serialize;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// A case with its outcome.
#[derive(Serialize, Clone, PartialEq, Debug)]
pub struct Verdict {
    /// Id of the case: group, `.`, name and method.
    pub id: String,
    /// Model, parameters and start in a few words.
    pub scene: String,
    /// Expected text and numbers, with their largest errors.
    pub expected: String,
    /// Where the expected outcome comes from: `energy`, `closed form`, `double-double`.
    pub source: &'static str,
    /// Measured text and numbers, or the error.
    pub measured: String,
    /// Name of the method of integration.
    pub method: &'static str,
    /// What an independent judge finds of the last run of the case; none if no run was shown to it.
    pub judge: Option<String>,
    /// Whether what was measured is what is expected.
    pub pass: bool,
    /// Wall time of the case, s.
    pub seconds: f64,
}

impl Case {
    /// Measures it on a thread of its own, so that a panic or a run without end within `limit` is an outcome too.
    pub fn judge(self, limit: Duration) -> Verdict {
        let Self { id, scene, method, source, expected, measure } = self;
        let (sender, receiver) = channel();
        let (opinion, opinions) = channel();
        let begun = Instant::now();
        let wanted = expected.clone();
        let measured = move || {
            let outcome = measure(method).map_err(|failure| failure.to_string());
            let pass = wanted.is_met(outcome.as_ref().map_err(String::as_str));
            let text = outcome.map_or_else(|error| error, |answer| answer.text(&wanted));
            // No one listens any longer once the time is over.
            if sender.send((text, pass)).is_ok() {
                let _ = opinion.send(found().map(|verdict| verdict.to_string()));
            }
        };
        // A thread that cannot be started drops the sender.
        let started = thread::Builder::new().spawn(measured);
        let answer = receiver.recv_timeout(limit);
        let seconds = begun.elapsed().as_secs_f64();
        let judge = if answer.is_ok() { opinions.recv_timeout(limit).ok().flatten() } else { None };
        let (measured, pass) = match answer {
            Ok(outcome) => outcome,
            Err(RecvTimeoutError::Timeout) => (format!("no answer after {} s", limit.as_secs()), false),
            Err(RecvTimeoutError::Disconnected) => ("panicked".to_owned(), false),
        };
        drop(started);
        Verdict {
            id,
            scene,
            expected: expected.text(),
            source,
            measured,
            method: method.name(),
            judge,
            pass,
            seconds,
        }
    }
}
