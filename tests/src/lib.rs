//! What the tests of liftoff measure against: none of it uses the generator or the runtime.
//!
//! [`oracle`] knows mechanics only as Newton–Euler equations in maximal coordinates; [`random`]
//! draws bar systems, as the oracle's data and as declarations; [`paper`] and [`catalogue`] restate
//! published closed forms; [`numerics`] has the quadrature and root finding these need.

pub mod catalogue;
pub mod numerics;
pub mod oracle;
pub mod paper;
pub mod random;
