//! Instances and their modes.

use super::{Handle, Held, PANIC, call};
use crate::c;
use crate::experiment::Experiment;
use crate::instance::{Instance, Kind};
use crate::logger::{Callback, Logger};
use crate::status::Status;
use core::ffi::{c_char, c_void};
use core::ptr::null_mut;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// What tells this library from others, so that no other is packed.
#[used]
static LIBRARY: &[u8] = liftoff_fmu::LIBRARY.as_bytes();

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// All errors are told, whatever is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: Handle,
    _on: bool,
    _count: usize,
    _categories: *const *const c_char,
) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |_| Ok(())) }
}

/// # Safety
/// The texts are as in `c`.
unsafe fn instantiate(
    kind: Kind,
    (token, resources): (*const c_char, *const c_char),
    logger: Logger,
) -> Handle {
    // SAFETY: the importer vouches for the texts.
    let (token, resources) = unsafe { (c::text(token), c::text(resources)) };
    let made = catch_unwind(AssertUnwindSafe(|| match (token, resources) {
        (Some(token), Some(resources)) => Instance::new(kind, Path::new(resources), token),
        (None, _) => Err("there is no instantiation token, or it is no UTF-8".to_owned()),
        (_, None) => Err("there is no path of resources, or it is no UTF-8".to_owned()),
    }));
    match made.unwrap_or_else(|_| Err(PANIC.to_owned())) {
        Ok(instance) => Box::into_raw(Box::new(Held { instance, logger })).cast(),
        Err(message) => {
            logger.tell(Status::Error, &message);
            null_mut()
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging_on: bool,
    environment: *mut c_void,
    log: Option<Callback>,
) -> Handle {
    // SAFETY: the importer vouches for the texts.
    unsafe { instantiate(Kind::Exchange, (token, resources), Logger::new(environment, log)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging_on: bool,
    event_mode: bool,
    early_return: bool,
    _required_intermediate: *const u32,
    _count_of_intermediate: usize,
    environment: *mut c_void,
    log: Option<Callback>,
    _intermediate: *const c_void,
) -> Handle {
    let kind = Kind::CoSimulation { event_mode, early_return };
    // SAFETY: the importer vouches for the texts.
    unsafe { instantiate(kind, (token, resources), Logger::new(environment, log)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: Handle) {
    if instance.is_null() {
        return;
    }
    // SAFETY: the importer vouches for the handle, and gives it back.
    let held = unsafe { Box::from_raw(instance.cast::<Held>()) };
    let logger = held.logger;
    if catch_unwind(AssertUnwindSafe(|| drop(held))).is_err() {
        logger.tell(Status::Fatal, PANIC);
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: Handle,
    tolerance_defined: bool,
    tolerance: f64,
    start: f64,
    stop_defined: bool,
    stop: f64,
) -> Status {
    let (stop, tolerance) = (stop_defined.then_some(stop), tolerance_defined.then_some(tolerance));
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |instance| instance.enter_initialization(Experiment { start, stop, tolerance })) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, Instance::exit_initialization) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterEventMode(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, Instance::enter_event) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    instance: Handle,
    needs_update: *mut bool,
    terminate: *mut bool,
    nominals_changed: *mut bool,
    values_changed: *mut bool,
    next_defined: *mut bool,
    next: *mut f64,
) -> Status {
    let body = |instance: &mut Instance| {
        let update = instance.update()?;
        // SAFETY: the importer vouches for the places.
        unsafe {
            c::write(needs_update, false);
            c::write(terminate, update.ended);
            c::write(nominals_changed, false);
            c::write(values_changed, update.moved);
            c::write(next_defined, false);
            c::write(next, 0.0);
        }
        Ok(())
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}

/// Discrete states are those that the last update has decided on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EvaluateDiscreteStates(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |_| Ok(())) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, Instance::terminate) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: Handle) -> Status {
    let body = |instance: &mut Instance| {
        instance.reset();
        Ok(())
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}
