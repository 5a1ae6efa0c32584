//! Tests of the algebra against ordinary numbers, against itself by other routes, and in print.

mod calculus;
mod canonical;
mod chain;
mod division;
mod laws;
mod limits;
mod products;
mod quotients;
pub(crate) mod random;
mod rationals;
mod refutation;
mod ring;
mod substitution;
mod text;
