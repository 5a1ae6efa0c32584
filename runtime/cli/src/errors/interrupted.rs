//! Ctrl-C: once, to stop with what is done; twice, to stop at once.

use std::panic::resume_unwind;
use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, LazyLock, Once};
use std::thread;
use std::time::Duration;

/// How often it is asked whether Ctrl-C has been pressed.
const TICK: Duration = Duration::from_millis(50);

/// Exit code of a program that a person stopped: 128 and the number of the signal.
pub const CODE: i32 = 130;

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Whether Ctrl-C has been pressed.
///
/// From the first call on, Ctrl-C only makes this true, and a second one ends the program. Commands that never ask end at
/// once, as programs do.
pub fn interrupted() -> &'static Arc<AtomicBool> {
    static LISTENING: Once = Once::new();
    LISTENING.call_once(|| {
        // Where a handler cannot be set, Ctrl-C ends the program as ever.
        let _ = ctrlc::set_handler(note);
    });
    &INTERRUPTED
}

/// Whether Ctrl-C has been pressed by now.
pub fn is_interrupted() -> bool {
    interrupted().load(Ordering::Relaxed)
}

/// What `work` returns; none from Ctrl-C on, when it is left to itself. What it tells goes to `told`.
pub fn unless_interrupted<T: Send + 'static>(
    work: impl FnOnce(&dyn Fn(usize)) -> Option<T> + Send + 'static,
    told: impl Fn(usize),
) -> Option<T> {
    let (sender, receiver) = channel();
    let worker = thread::spawn(move || {
        // Nobody listens any longer after Ctrl-C.
        work(&|part| {
            let _ = sender.send(part);
        })
    });
    loop {
        match receiver.recv_timeout(TICK) {
            Ok(part) => told(part),
            Err(RecvTimeoutError::Disconnected) => break,
            Err(RecvTimeoutError::Timeout) if is_interrupted() => return None,
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
    worker.join().unwrap_or_else(|panic| resume_unwind(panic))
}

fn note() {
    if INTERRUPTED.swap(true, Ordering::Relaxed) {
        exit(CODE);
    }
}
