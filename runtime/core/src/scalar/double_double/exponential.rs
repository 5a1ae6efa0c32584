//! Exponentials: x = k ln 2 + r with |r| ≤ ½ ln 2, then eʳ − 1 from r/2⁸ by its series and eight
//! times p ← p (p + 2), so that small arguments keep their digits.
//!
//! The relative error is below 1e-29 + |x|·1e-32 of eˣ and tanh x, the absolute one of log x too,
//! and that of atan x below 1e-30.

use super::{DoubleDouble, two_product};
use crate::scalar::Real;
use crate::scalar::library::Library;

/// ln 2 = Σ, 159 bits.
const LN_2: [f64; 3] = [core::f64::consts::LN_2, 2.3190468138462996e-17, 5.707708438416212e-34];
const HALVINGS: i32 = 8;
/// Terms of the series: (ln 2/2⁹)¹²/12! < 1e-43.
const TERMS: u32 = 12;

pub(super) fn exp(x: DoubleDouble) -> DoubleDouble {
    // Where the result overflows or vanishes, and of what is no number.
    let nearest = Library::exp(x.hi);
    if nearest == 0.0 || !nearest.is_finite() {
        return DoubleDouble::from_f64(nearest);
    }
    let doublings = (x.hi * core::f64::consts::LOG2_E) as i32;
    let r = LN_2.iter().fold(x, |rest, &part| rest - two_product(f64::from(doublings), part));
    let value = less_one(r) + DoubleDouble::from_f64(1.0);
    // Twice, so that no power of two leaves the doubles.
    [doublings / 2, doublings - doublings / 2].into_iter().fold(value, |value, k| value.scale(two_to(k)))
}

/// eʳ − 1 for |r| < 1.
fn less_one(r: DoubleDouble) -> DoubleDouble {
    let r = r.scale(two_to(-HALVINGS));
    let one = DoubleDouble::from_f64(1.0);
    let tail = (2..=TERMS).rev().fold(one, |tail, n| one + (r * tail).divide_by(f64::from(n)));
    (0..HALVINGS).fold(r * tail, |p, _| p * (p + DoubleDouble::from_f64(2.0)))
}

/// 2ᵏ for |k| < 1023.
fn two_to(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// One step of Halley's method for eʸ = x from the logarithm of a double.
pub(super) fn ln(x: DoubleDouble) -> DoubleDouble {
    let y = DoubleDouble::from_f64(Library::ln(x.hi));
    if !y.hi.is_finite() {
        return y;
    }
    let power = exp(y);
    y + ((x - power) / (x + power)).scale(2.0)
}

/// One correction of the angle φ of a double: tan (y − φ) = (x cos φ − sin φ)/(cos φ + x sin φ),
/// whose cube is below the last digit.
pub(super) fn atan(x: DoubleDouble) -> DoubleDouble {
    let y = DoubleDouble::from_f64(Library::atan(x.hi));
    if !x.hi.is_finite() {
        return y;
    }
    let (sin, cos) = y.sin_cos();
    y + (x * cos - sin) / (cos + x * sin)
}

/// (e²ˣ − 1)/(e²ˣ + 1).
pub(super) fn tanh(x: DoubleDouble) -> DoubleDouble {
    let (one, two) = (DoubleDouble::from_f64(1.0), DoubleDouble::from_f64(2.0));
    let size = if x.hi < 0.0 { -x } else { x };
    let value = match size.hi {
        // e⁻⁷⁶ is below the last digit.
        38.0.. => one,
        0.4.. => one - two / (exp(size.scale(2.0)) + one),
        _ => {
            let p = less_one(size.scale(2.0));
            p / (p + two)
        }
    };
    if x.hi < 0.0 { -value } else { value }
}
