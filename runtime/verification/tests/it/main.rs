//! References and measurements of small models, in one program.

mod precision;
mod references;
