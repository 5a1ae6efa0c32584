//! A case judged.

use super::answer::{Answer, Expected};
use super::case::Case;
use crate::MotionError;
use crate::judgement::{self, Opinion, found};
use serde::Serialize;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How often it is asked whether to wait any longer.
const TICK: Duration = Duration::from_millis(50);

/// How a case ends.
#[derive(Serialize, Clone, Copy, PartialEq, Eq, Debug)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// What was measured is what is expected, and neither the judge nor the audit says otherwise.
    Pass,
    /// It is not, or one of them does.
    Fail,
    /// A typed error where numbers or an error are allowed: nothing was compared.
    Refused,
    /// There was nothing independent to compare with, or it did not finish.
    NotJudged,
}

impl core::fmt::Display for Outcome {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Pass => "pass",
            Self::Fail => "FAIL",
            Self::Refused => "refused",
            Self::NotJudged => "not judged",
        })
    }
}

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
    /// What an independent judge finds of the last run of the case, or why it finds nothing.
    pub judge: String,
    /// What the audit finds in that run; none if it finds nothing or there was no run.
    pub audit: Option<String>,
    /// How it ends.
    pub outcome: Outcome,
    /// Wall time of the case, s.
    pub seconds: f64,
}

impl Verdict {
    /// Whether it passes.
    pub fn passes(&self) -> bool {
        self.outcome == Outcome::Pass
    }

    /// Whether it fails.
    pub fn fails(&self) -> bool {
        self.outcome == Outcome::Fail
    }
}

/// What was measured, and how that compares with what is expected.
type Measured = (String, Outcome);

impl Case {
    /// Measures it on a thread of its own, so that a panic is an outcome too; what does not end
    /// within `limit` is not judged.
    pub fn judge(self, limit: Duration) -> Verdict {
        self.measured(limit, &|| false).1
    }

    /// The same; none where meanwhile `is_enough`, which is asked many times a second. What goes on
    /// is left to itself.
    pub fn judge_unless(self, limit: Duration, is_enough: &dyn Fn() -> bool) -> Option<Verdict> {
        let (is_whole, verdict) = self.measured(limit, is_enough);
        is_whole.then_some(verdict)
    }

    /// Whether it was waited for, and what came of it.
    fn measured(self, limit: Duration, is_enough: &dyn Fn() -> bool) -> (bool, Verdict) {
        let Self { id, scene, method, source, expected, measure } = self;
        let (sender, receiver) = channel();
        let (opinion, opinions) = channel();
        let begun = Instant::now();
        let wanted = expected.clone();
        let measuring = move || {
            // No one listens any longer once the time is over.
            if sender.send(measured(measure(method), &wanted)).is_ok() {
                let _ = opinion.send(found());
            }
        };
        // A thread that cannot be started drops the sender.
        let started = thread::Builder::new().spawn(measuring);
        let answer = awaited(&receiver, limit, is_enough);
        let seconds = begun.elapsed().as_secs_f64();
        let (measured, compared) = match answer {
            Ok(outcome) => outcome,
            Err(RecvTimeoutError::Timeout) => {
                (format!("no answer after {} s", limit.as_secs()), Outcome::NotJudged)
            }
            Err(RecvTimeoutError::Disconnected) => ("panicked".to_owned(), Outcome::Fail),
        };
        let opinion = heard(awaited(&opinions, limit, is_enough));
        drop(started);
        let audit = opinion.audit.filter(|audit| !audit.is_clean());
        let refuted = matches!(opinion.judge, judgement::Verdict::Disagrees { .. }) || audit.is_some();
        let verdict = Verdict {
            id,
            scene,
            expected: expected.text(),
            source,
            measured,
            method: method.name(),
            judge: opinion.judge.to_string(),
            audit: audit.map(|audit| findings(&audit)),
            outcome: if refuted { Outcome::Fail } else { compared },
            seconds,
        };
        (!is_enough(), verdict)
    }
}

/// What a thread sends within a time, or as long as it is not enough.
fn awaited<T>(
    receiver: &Receiver<T>,
    limit: Duration,
    is_enough: &dyn Fn() -> bool,
) -> Result<T, RecvTimeoutError> {
    let begun = Instant::now();
    loop {
        match receiver.recv_timeout(TICK.min(limit)) {
            Err(RecvTimeoutError::Timeout) if begun.elapsed() < limit && !is_enough() => {}
            answer => return answer,
        }
    }
}

fn measured(outcome: Result<Answer, MotionError>, wanted: &Expected) -> Measured {
    let outcome = outcome.map_err(|failure| failure.to_string());
    let told = outcome.as_ref().map_err(String::as_str);
    let compared = match told {
        Err(error) if wanted.excuses(error) => Outcome::NotJudged,
        Err(error) if !error.is_empty() && matches!(wanted, Expected::Either(_)) => Outcome::Refused,
        told if wanted.is_met(told) => Outcome::Pass,
        _ => Outcome::Fail,
    };
    (outcome.map_or_else(|error| error, |answer| answer.text(wanted)), compared)
}

/// What is found of the case's run.
fn heard(opinion: Result<Option<Opinion>, RecvTimeoutError>) -> Opinion {
    let nothing = |why: &str| {
        let judge = judgement::Verdict::NotJudged { why: why.to_owned() };
        Opinion { judge, audit: None }
    };
    match opinion {
        Ok(Some(opinion)) => opinion,
        Ok(None) => nothing("no motion was recorded to its end"),
        Err(RecvTimeoutError::Timeout) => nothing("no answer in time"),
        Err(RecvTimeoutError::Disconnected) => nothing("the case has no answer"),
    }
}

/// What is broken, in a line.
fn findings(audit: &liftoff::Audit) -> String {
    audit.violations().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
