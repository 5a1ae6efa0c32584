//! Dense systems, complementarity and roots in any scalar.

pub(crate) mod complementarity;
pub(crate) mod linear;
pub(crate) mod root;
