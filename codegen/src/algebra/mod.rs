//! Exact algebra of Poisson series and their quotients. It knows no mechanics.
//!
//! A [`Series`] is Σ rational · monomial · sin|cos(integer combination of symbols). Products of
//! waves are turned into sums, so two series are equal exactly if their terms are. A [`Quotient`]
//! has a factored denominator; quotients are compared by cross-multiplication.

mod angle;
mod calculus;
mod collect;
mod content;
mod divide;
mod evaluate;
mod exponential;
mod gaussian;
mod modular;
mod ops;
mod powers;
mod product;
mod quotient;
mod quotient_ops;
mod quotient_substitute;
mod rational;
mod series;
mod split;
mod substitute;
mod symbol;
mod term;
mod text;
pub mod work;

#[cfg(test)]
pub(crate) mod tests;

pub use angle::Angle;
pub use powers::Powers;
pub use quotient::Quotient;
pub use rational::Rational;
pub use series::Series;
pub use symbol::Symbol;
pub use term::{Monomial, Term, Wave};
pub use text::{Shorthand, SymbolNames, lead, lettered, printed, rank};
