//! What functions return.

/// `fmi3Status`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(C)]
pub enum Status {
    /// All went well.
    Ok = 0,
    /// The call failed; a message says why.
    Error = 3,
    /// The instance cannot be used any more.
    Fatal = 4,
}
