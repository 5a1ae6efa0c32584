//! Values of variables.

use super::{Handle, call};
use crate::c;
use crate::instance::Instance;
use crate::status::Status;
use liftoff_fmu::Quantity;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    instance: Handle,
    references: *const u32,
    count: usize,
    values: *mut f64,
    count_of_values: usize,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: the importer vouches for both.
        unsafe {
            let found = instance.floats(c::values(references, count))?;
            c::write_all(values, count_of_values, &found)
        }
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    instance: Handle,
    references: *const u32,
    count: usize,
    values: *const f64,
    count_of_values: usize,
) -> Status {
    // SAFETY: the importer vouches for both.
    let (references, values) = unsafe { (c::values(references, count), c::values(values, count_of_values)) };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, |instance| instance.set(references, values)) }
}

/// The count of events.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt32(
    instance: Handle,
    references: *const u32,
    count: usize,
    values: *mut i32,
    count_of_values: usize,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: the importer vouches for both.
        unsafe {
            let is = |quantity: &Quantity| *quantity == Quantity::Events;
            let found = instance.integers(c::values(references, count), is)?;
            let found: Vec<i32> = found.into_iter().map(|n| i32::try_from(n).unwrap_or(i32::MAX)).collect();
            c::write_all(values, count_of_values, &found)
        }
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}

/// States of contacts: enumerations are read so.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt64(
    instance: Handle,
    references: *const u32,
    count: usize,
    values: *mut i64,
    count_of_values: usize,
) -> Status {
    let body = |instance: &mut Instance| {
        // SAFETY: the importer vouches for both.
        unsafe {
            let is = |quantity: &Quantity| matches!(quantity, Quantity::Contact(_));
            let found = instance.integers(c::values(references, count), is)?;
            c::write_all(values, count_of_values, &found)
        }
    };
    // SAFETY: the importer vouches for the handle.
    unsafe { call(instance, body) }
}
