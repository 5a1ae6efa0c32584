//! Of co-simulation.

use super::{Handle, call};
use crate::c;
use crate::instance::Instance;
use crate::status::Status;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterStepMode(instance: Handle) -> Status {
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, Instance::enter_step) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: Handle,
    from: f64,
    length: f64,
    _no_setting_back: bool,
    event: *mut bool,
    terminate: *mut bool,
    early: *mut bool,
    last: *mut f64,
) -> Status {
    let body = |instance: &mut Instance| {
        let step = instance.step(from, length)?;
        // SAFETY: the importer vouches for the places.
        unsafe {
            c::write(event, step.event);
            c::write(terminate, step.ended);
            c::write(early, step.early);
            c::write(last, step.t);
        }
        Ok(())
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}
