//! Of model exchange.

use super::{Handle, call};
use crate::c;
use crate::instance::Instance;
use crate::status::Status;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterContinuousTimeMode(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, Instance::enter_continuous) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3CompletedIntegratorStep(
    instance: Handle,
    _no_setting_back: bool,
    enter_event_mode: *mut bool,
    terminate: *mut bool,
) -> Status {
    let body = |instance: &mut Instance| {
        instance.completed_step()?;
        // SAFETY: the importer vouches for the places.
        unsafe {
            c::write(enter_event_mode, false);
            c::write(terminate, false);
        }
        Ok(())
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetTime(instance: Handle, t: f64) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |instance| instance.set_time(t)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetContinuousStates(
    instance: Handle,
    states: *const f64,
    count: usize,
) -> Status {
    // SAFETY: the importer vouches for the values.
    let states = unsafe { c::values(states, count) };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |instance| instance.set_states(states)) }
}

/// Writes what an instance has as many of as there is room for.
///
/// # Safety
/// As of all exports.
unsafe fn write_values(
    instance: Handle,
    (values, count): (*mut f64, usize),
    of: impl FnOnce(&mut Instance, usize) -> Result<Vec<f64>, String>,
) -> Status {
    // SAFETY: the importer vouches for the handle and for the room.
    unsafe { call(instance, |instance| c::write_all(values, count, &of(instance, count)?)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStates(instance: Handle, states: *mut f64, count: usize) -> Status {
    // SAFETY: the importer vouches for all.
    unsafe { write_values(instance, (states, count), Instance::states) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStateDerivatives(
    instance: Handle,
    derivatives: *mut f64,
    count: usize,
) -> Status {
    // SAFETY: the importer vouches for all.
    unsafe { write_values(instance, (derivatives, count), Instance::derivatives) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNominalsOfContinuousStates(
    instance: Handle,
    nominals: *mut f64,
    count: usize,
) -> Status {
    // SAFETY: the importer vouches for all.
    unsafe { write_values(instance, (nominals, count), Instance::nominals) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetEventIndicators(
    instance: Handle,
    indicators: *mut f64,
    count: usize,
) -> Status {
    // SAFETY: the importer vouches for all.
    unsafe { write_values(instance, (indicators, count), Instance::event_indicators) }
}

/// Writes a count.
///
/// # Safety
/// As of all exports.
unsafe fn count(instance: Handle, place: *mut usize, of: fn(&Instance) -> usize) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: the importer vouches for the place.
        unsafe { c::write(place, of(instance)) };
        Ok(())
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfEventIndicators(instance: Handle, indicators: *mut usize) -> Status {
    // SAFETY: the importer vouches for both.
    unsafe { count(instance, indicators, Instance::count_of_indicators) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfContinuousStates(instance: Handle, states: *mut usize) -> Status {
    // SAFETY: the importer vouches for both.
    unsafe { count(instance, states, Instance::count_of_states) }
}
