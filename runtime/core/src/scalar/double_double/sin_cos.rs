//! Sine and cosine: x = k π/2 + r with |r| ≤ π/4 (Cody and Waite, π/2 as three doubles), then
//! sin r = r (1 − r²/(2·3) (1 − r²/(4·5) (…))), cos r = 1 − r²/(1·2) (1 − r²/(3·4) (…)).
//!
//! Absolute error below 1e-31 + |x|·1e-32; not meant for |x| beyond some 10⁶.

use core::f64::consts::FRAC_2_PI;

use super::{DoubleDouble, two_product};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::Real;

/// π/2 = Σ, 159 bits.
pub(super) const HALF_PI: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33];

/// Terms of each series: (π/4)²⁹/29! < 1.1e-34.
const TERMS: u32 = 14;

pub(super) fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let quarter_turns = (x.hi * FRAC_2_PI).round();
    let r = HALF_PI.iter().fold(x, |rest, &part| rest - two_product(quarter_turns, part));
    let square = r * r;
    let (sin, cos) = (r * series(square, 1), series(square, 0));
    match quarter_turns.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// 1 − r²/((first+1)(first+2)) (1 − r²/((first+3)(first+4)) (…)).
fn series(square: DoubleDouble, first: u32) -> DoubleDouble {
    let one = DoubleDouble::from_f64(1.0);
    (0..TERMS).rev().fold(one, |tail, term| {
        let n = 2 * term + first;
        one - (square * tail).divide_by(f64::from((n + 1) * (n + 2)))
    })
}
