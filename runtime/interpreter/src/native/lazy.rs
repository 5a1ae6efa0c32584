//! What is compiled once it has been run often: most functions of a model are called a few times in
//! a run.

use core::sync::atomic::{AtomicU32, Ordering};
use std::sync::OnceLock;

/// Runs that take as long as compiling.
const OFTEN: u32 = 256;

/// A function that is compiled when it is due, if it can be.
#[derive(Debug)]
pub(crate) struct Lazy<F> {
    runs: AtomicU32,
    compiled: OnceLock<Option<F>>,
}

impl<F> Default for Lazy<F> {
    fn default() -> Self {
        Self { runs: AtomicU32::new(0), compiled: OnceLock::new() }
    }
}

impl<F> Lazy<F> {
    /// The function, once it is due.
    pub fn get(&self, compile: impl FnOnce() -> Option<F>) -> Option<&F> {
        if let Some(known) = self.compiled.get() {
            return known.as_ref();
        }
        // Lost counts only put it off.
        let runs = self.runs.load(Ordering::Relaxed);
        self.runs.store(runs.saturating_add(1), Ordering::Relaxed);
        if runs < OFTEN { None } else { self.compiled.get_or_init(compile).as_ref() }
    }
}
