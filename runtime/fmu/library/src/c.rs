//! Pointers of C as slices and texts. The callers, functions of FMI, are given them by an importer,
//! who vouches for them: they point to as many values as are said, which live until the function
//! returns, and which nobody else writes meanwhile.

#![allow(unsafe_code, reason = "pointers of C")]

use crate::logger::Callback;
use crate::status::Status;
use core::ffi::{CStr, c_char, c_void};
use std::ffi::CString;

/// A text; none where it is absent or no UTF-8.
///
/// # Safety
/// The pointer is null or that of a text that ends with a zero and lives long enough.
pub(crate) unsafe fn text<'a>(pointer: *const c_char) -> Option<&'a str> {
    if pointer.is_null() {
        return None;
    }
    // SAFETY: it is not null, and the caller vouches for the text.
    unsafe { CStr::from_ptr(pointer) }.to_str().ok()
}

/// Values; none where they are absent.
///
/// # Safety
/// The pointer is null or that of so many values, which live long enough and are not written
/// meanwhile.
pub(crate) unsafe fn values<'a, T>(pointer: *const T, count: usize) -> &'a [T] {
    if pointer.is_null() || count == 0 {
        return &[];
    }
    // SAFETY: it is not null, and the caller vouches for the values.
    unsafe { core::slice::from_raw_parts(pointer, count) }
}

/// Writes values.
///
/// # Errors
/// There is no place for them, or not so much.
///
/// # Safety
/// The pointer is null or that of room for `count` values.
pub(crate) unsafe fn write_all<T: Copy>(pointer: *mut T, count: usize, values: &[T]) -> Result<(), String> {
    if values.len() != count || pointer.is_null() && count > 0 {
        return Err(format!("there is room for {count} values, and there are {}", values.len()));
    }
    if count > 0 {
        // SAFETY: the caller vouches for the room, and `values` are none of it.
        unsafe { core::ptr::copy_nonoverlapping(values.as_ptr(), pointer, count) };
    }
    Ok(())
}

/// Writes a value, if there is a place for it.
///
/// # Safety
/// The pointer is null or that of room for a value.
pub(crate) unsafe fn write<T>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: it is not null, and the caller vouches for the room.
        unsafe { pointer.write(value) };
    }
}

/// Calls the importer back with a message of a category.
pub(crate) fn log(
    callback: Callback,
    environment: *mut c_void,
    status: Status,
    (category, message): (&str, &str),
) {
    let without_zeros = |text: &str| CString::new(text.replace('\0', " ")).unwrap_or_default();
    let (category, message) = (without_zeros(category), without_zeros(message));
    // SAFETY: the importer has given both for each other, and the texts live until it returns.
    unsafe { callback(environment, status, category.as_ptr(), message.as_ptr()) };
}
