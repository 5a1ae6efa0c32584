//! How far something is, on a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// What is done sooner shows no progress.
const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// A bar on standard error, if that is a terminal, from one second on until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    /// Its end tells the thread that would show the bar not to.
    _done: Sender<()>,
}

impl Progress {
    /// Of `total` items, called so: `cases`.
    pub fn new(total: usize, items: &'static str) -> Self {
        let form = "{elapsed_precise} {bar:32} {human_pos} of {human_len} {prefix} {msg} {eta}";
        Self::shown(
            ProgressBar::with_draw_target(Some(total as u64), ProgressDrawTarget::hidden()),
            form,
            items,
        )
    }

    /// Of something whose length is not known: `running ladder`.
    pub fn endless(doing: impl Into<String>) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self::shown(bar, "{elapsed_precise} {spinner} {prefix}", doing)
    }

    fn shown(bar: ProgressBar, form: &str, prefix: impl Into<String>) -> Self {
        let style = ProgressStyle::with_template(form).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = bar.with_style(style).with_prefix(prefix.into());
        let (sender, done) = channel::<()>();
        let later = bar.clone();
        thread::spawn(move || {
            if done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                later.set_draw_target(ProgressDrawTarget::stderr());
                later.enable_steady_tick(TICK);
            }
        });
        Self { bar, _done: sender }
    }

    /// One more item is done.
    pub fn advance(&self) {
        self.bar.inc(1);
    }

    /// There are so many items.
    pub fn extend(&self, total: usize) {
        self.bar.set_length(total as u64);
    }

    /// So many items are done.
    pub fn reach(&self, done: usize) {
        self.bar.set_position(done as u64);
    }

    /// What is being done.
    pub fn doing(&self, what: impl Into<String>) {
        self.bar.set_message(what.into());
    }

    /// Prints without leaving parts of the bar between the lines.
    pub fn aside<T>(&self, print: impl FnOnce() -> T) -> T {
        self.bar.suspend(print)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
