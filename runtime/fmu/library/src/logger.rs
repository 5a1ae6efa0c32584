//! Messages to the importer.

use crate::c;
use crate::status::Status;
use core::ffi::{c_char, c_void};

/// `fmi3LogMessageCallback`.
pub(crate) type Callback = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// Where messages go.
#[derive(Clone, Copy)]
pub(crate) struct Logger {
    environment: *mut c_void,
    callback: Option<Callback>,
}

impl Logger {
    pub(crate) fn new(environment: *mut c_void, callback: Option<Callback>) -> Self {
        Self { environment, callback }
    }

    /// Says why a call has failed, in one line.
    pub(crate) fn tell(&self, status: Status, message: &str) {
        let Some(callback) = self.callback else { return };
        let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
        c::log(callback, self.environment, status, (liftoff_fmu::ERRORS, &line));
    }
}
