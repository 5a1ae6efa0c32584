//! What no unit of liftoff has: variables of other types, clocks, configuration, states to go back
//! to, derivatives of outputs and along directions. The description says so. C passes arguments so
//! that a function may take the first of them alone.

use super::{Handle, call};
use crate::logger::{Callback, Logger};
use crate::status::Status;
use core::ffi::{c_char, c_void};
use core::ptr::null_mut;

macro_rules! absent {
    ($($function:ident),* => $what:literal) => {$(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(instance: Handle) -> Status {
            let what = concat!(stringify!($function), ": ", $what);
            // SAFETY: the importer vouches for the handle.
            unsafe { call(instance, |_| Err(what.to_owned())) }
        }
    )*};
}

absent! {
    fmi3GetFloat32, fmi3GetInt8, fmi3GetUInt8, fmi3GetInt16, fmi3GetUInt16, fmi3GetUInt32, fmi3GetUInt64,
    fmi3GetBoolean, fmi3GetString, fmi3GetBinary, fmi3GetClock, fmi3SetFloat32, fmi3SetInt8, fmi3SetUInt8,
    fmi3SetInt16, fmi3SetUInt16, fmi3SetUInt32, fmi3SetUInt64, fmi3SetBoolean, fmi3SetString, fmi3SetBinary,
    fmi3SetClock
    => "no variable has this type"
}

absent! {
    fmi3SetInt32, fmi3SetInt64
    => "integers follow from the motion"
}

absent! {
    fmi3GetFMUState, fmi3SetFMUState, fmi3FreeFMUState, fmi3SerializedFMUStateSize, fmi3SerializeFMUState,
    fmi3DeserializeFMUState
    => "its state cannot be taken or set"
}

absent! {
    fmi3GetDirectionalDerivative, fmi3GetAdjointDerivative, fmi3GetOutputDerivatives,
    fmi3GetNumberOfVariableDependencies, fmi3GetVariableDependencies
    => "not provided"
}

absent! {
    fmi3EnterConfigurationMode, fmi3ExitConfigurationMode
    => "there are no structural parameters"
}

absent! {
    fmi3GetIntervalDecimal, fmi3GetIntervalFraction, fmi3GetShiftDecimal, fmi3GetShiftFraction,
    fmi3SetIntervalDecimal, fmi3SetIntervalFraction, fmi3SetShiftDecimal, fmi3SetShiftFraction,
    fmi3ActivateModelPartition
    => "there are no clocks"
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging_on: bool,
    environment: *mut c_void,
    log: Option<Callback>,
    _clock_update: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> Handle {
    Logger::new(environment, log).tell(Status::Error, "there is no scheduled execution: there are no clocks");
    null_mut()
}
