//! Ctrl-C while nothing holds the interpreter.

use liftoff::{Observer, Step};
use pyo3::prelude::*;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How often is asked whether Ctrl-C was pressed.
const PERIOD: Duration = Duration::from_millis(50);

/// Keeps a motion and stops it on Ctrl-C.
pub struct Watch {
    asked: Instant,
    stop: Arc<AtomicBool>,
    signal: Option<PyErr>,
}

impl Watch {
    /// Sets this where the motion is to stop.
    pub fn new(stop: Arc<AtomicBool>) -> Self {
        Self { asked: Instant::now(), stop, signal: None }
    }

    /// What a signal has raised.
    pub fn signal(self) -> Option<PyErr> {
        self.signal
    }
}

impl Observer for Watch {
    fn records(&self) -> bool {
        true
    }

    fn step(&mut self, _: &dyn Step) {
        if self.signal.is_none() && self.asked.elapsed() > PERIOD {
            self.signal = Python::attach(|py| py.check_signals()).err();
            self.stop.store(self.signal.is_some(), Ordering::Relaxed);
            self.asked = Instant::now();
        }
    }
}

/// Does a work on a thread of its own, without the interpreter; on Ctrl-C tells it to stop.
pub fn watched<T: Send>(py: Python<'_>, work: impl FnOnce(&Arc<AtomicBool>) -> T + Send) -> PyResult<T> {
    let stop = Arc::default();
    py.detach(|| {
        thread::scope(|scope| {
            let (ended, end) = channel::<()>();
            let worker = scope.spawn(|| {
                let _ended = ended;
                work(&stop)
            });
            let mut signal = None;
            while end.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                if signal.is_none() {
                    signal = Python::attach(|py| py.check_signals()).err();
                    stop.store(signal.is_some(), Ordering::Relaxed);
                }
            }
            let done = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            signal.map_or(Ok(done), Err)
        })
    })
}
