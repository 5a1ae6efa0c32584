//! The functions of FMI 3.0, by the names and with the arguments of its headers. None lets a panic
//! pass.
//!
//! - `lifecycle`: instances, their modes and the events of both kinds; `variables`: values;
//!   `exchange`, `co_simulation`: of one kind each; `absent`: what no unit of liftoff has.
//!
//! # Safety
//!
//! Of all functions: an instance is null or one that an instantiating function has returned and
//! that has not been freed; calls for one instance do not overlap; other pointers are as in `c`.

#![allow(unsafe_code, reason = "C finds functions by their names and gives them pointers")]
#![allow(non_snake_case, reason = "names of FMI")]
#![allow(clippy::missing_safety_doc, reason = "the same of all: above")]

mod absent;
mod co_simulation;
mod exchange;
mod lifecycle;
mod variables;

use crate::instance::Instance;
use crate::logger::Logger;
use crate::status::Status;
use core::ffi::c_void;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// `fmi3Instance`.
type Handle = *mut c_void;

/// What a handle points to.
struct Held {
    instance: Instance,
    logger: Logger,
}

/// Calls an instance; what it fails with is told.
///
/// # Safety
/// The handle is that of an instance, as above.
unsafe fn call(handle: Handle, body: impl FnOnce(&mut Instance) -> Result<(), String>) -> Status {
    // SAFETY: the importer vouches for the handle, and for no other call meanwhile.
    let Some(held) = (unsafe { handle.cast::<Held>().as_mut() }) else { return Status::Error };
    let Held { instance, logger } = held;
    let (status, message) = match catch_unwind(AssertUnwindSafe(|| body(instance))) {
        Ok(Ok(())) => return Status::Ok,
        Ok(Err(message)) => (Status::Error, message),
        Err(_) => (Status::Fatal, PANIC.to_owned()),
    };
    logger.tell(status, &message);
    status
}

/// What is told of a panic.
const PANIC: &str = "the library has failed: this is a mistake of liftoff";
