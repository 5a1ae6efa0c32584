//! Ctrl-C: once, to stop with what is done; twice, to stop at once.

use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, Once};

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

fn note() {
    if INTERRUPTED.swap(true, Ordering::Relaxed) {
        exit(CODE);
    }
}
