//! The law of friction against brute force, closed forms and Lemke against enumeration.

mod apart;
mod borders;
mod closed_forms;
mod coupled;
mod drawn;
mod lcp;
mod oracle;
pub(in crate::contact) mod random;
mod rough;
mod rounding;
mod solutions;
mod twins;
