//! The law of friction against brute force, closed forms and Lemke against enumeration.

mod closed_forms;
mod oracle;
pub(in crate::contact) mod random;
mod single;
