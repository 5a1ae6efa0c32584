//! References and measurements of small models, in one program.

mod judgement;
mod precision;
mod references;
