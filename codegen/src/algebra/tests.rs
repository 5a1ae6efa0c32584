//! Tests of the algebra against ordinary numbers, against itself by other routes, and in print.

mod calculus;
mod canonical;
mod chain;
mod division;
mod laws;
mod quotients;
pub(crate) mod random;
mod rationals;
mod ring;
mod substitution;
mod text;
