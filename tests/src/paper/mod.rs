//! Equations (3.1)–(3.22) of Rozenblat & Grishakin, Rus. J. Nonlin. Dyn. 19(2), 2023, restated by
//! hand.
//!
//! Misprints corrected; bars uniform, I = m l²/12. Functions of the angle φ alone take the
//! start of the motion from the struct; everything is in the units of its parameters.

mod falling_pair;
mod zigzag;

pub use falling_pair::FallingPair;
pub use zigzag::Zigzag;
