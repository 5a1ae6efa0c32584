//! Sine and cosine of doubles, inlined and without branches, so that several are computed side by side.
//!
//! x = q π/2 + r + ρ with |r| ≤ π/4, q an integer, ρ below the last place of r: π/2 is subtracted in parts (W. J. Cody and
//! W. Waite, *Software Manual for the Elementary Functions*, 1980, ch. 8). Then, with z = r²,
//!
//! ```text
//! sin(r + ρ) = r + (r z S(z) + ρ (1 − z/2))
//! cos(r + ρ) = (1 − z/2) + (z² C(z) − r ρ)
//! ```
//!
//! with the minimax polynomials S and C of fdlibm (Sun Microsystems, 1993, `k_sin.c`, `k_cos.c`). The error is below 1 ulp for
//! |x| ≤ 2²⁰; beyond, and of what is no number, these are the library's functions.

#[cfg(test)]
mod tests;

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use super::library::Library;

/// Up to here the product of q with the first parts of π/2 is exact, or fused.
const BOUND: f64 = (1 << 20) as f64;

/// 1.5 · 2⁵², beside which a double has no fraction: what is added to it is rounded to an integer, in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// π/2 = Σ where products are fused: 53, 33 and 53 bits.
const FUSED_PARTS: [f64; 3] = [FRAC_PI_2, 6.12323399538461e-17, 3.5215598651832e-27];

/// π/2 = Σ where they are not: thrice 33 bits, whose products with q are exact, and 53.
const PLAIN_PARTS: [f64; 4] =
    [1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.4784276603689e-32];

const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-6,
    -2.5050760253406863e-8,
    1.58969099521155e-10,
];

const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-5,
    -2.7557314351390663e-7,
    2.087572321298175e-9,
    -1.1359647557788195e-11,
];

/// `(sin x, cos x)`.
#[inline(always)]
pub(super) fn sin_cos<const FUSED: bool>(x: f64) -> (f64, f64) {
    if x.abs() <= BOUND { reduced::<FUSED>(x) } else { Library::sin_cos(x) }
}

/// Sines and cosines of several angles, with the bits that each has by itself.
#[inline(always)]
pub(super) fn sin_cos_each<const FUSED: bool, const K: usize>(angles: [f64; K]) -> ([f64; K], [f64; K]) {
    let (mut sin, mut cos) = ([0.0; K], [0.0; K]);
    if angles.iter().fold(true, |within, x| within & (x.abs() <= BOUND)) {
        for i in 0..K {
            (sin[i], cos[i]) = reduced::<FUSED>(angles[i]);
        }
    } else {
        for i in 0..K {
            (sin[i], cos[i]) = sin_cos::<FUSED>(angles[i]);
        }
    }
    (sin, cos)
}

/// For |x| ≤ [`BOUND`]. The sine of −x is that of x with its sign, that of −0 too.
#[inline(always)]
fn reduced<const FUSED: bool>(x: f64) -> (f64, f64) {
    const SIGN: u64 = 1 << 63;
    let angle = x.abs();
    let shifted = mul_add::<FUSED>(angle, FRAC_2_PI, ROUND);
    let rest = if FUSED { fused_rest } else { plain_rest };
    let (sin, cos) = near_zero::<FUSED>(rest(angle, shifted - ROUND));
    let quarter = shifted.to_bits();
    let odd = (quarter & 1).wrapping_neg();
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    let (first, second) = (sin & !odd | cos & odd, cos & !odd | sin & odd);
    let (down, left) = (quarter << 62, quarter.wrapping_add(1) << 62);
    let sign = (down ^ x.to_bits()) & SIGN;
    (f64::from_bits(first ^ sign), f64::from_bits(second ^ left & SIGN))
}

/// x − q π/2 = r + ρ; the first difference is exact.
#[inline(always)]
fn fused_rest(x: f64, q: f64) -> (f64, f64) {
    let [high, middle, low] = FUSED_PARTS;
    let first = Library::mul_add(-q, high, x);
    let rest = Library::mul_add(-q, middle, first);
    let error = Library::mul_add(-q, middle, first - rest);
    (rest, Library::mul_add(-q, low, error))
}

/// The same by exact products and differences that keep their rounding.
#[inline(always)]
fn plain_rest(x: f64, q: f64) -> (f64, f64) {
    let [high, middle, low, lowest] = PLAIN_PARTS;
    let (rest, first) = difference(x - q * high, q * middle);
    let (rest, second) = difference(rest, q * low);
    (rest, first + second - q * lowest)
}

/// a − b and its rounding (D. E. Knuth, *The Art of Computer Programming* 2, § 4.2.2, theorem B).
#[inline(always)]
fn difference(a: f64, b: f64) -> (f64, f64) {
    let difference = a - b;
    let minus_b = difference - a;
    (difference, (a - (difference - minus_b)) - (b + minus_b))
}

#[inline(always)]
fn near_zero<const FUSED: bool>((r, rho): (f64, f64)) -> (f64, f64) {
    let z = r * r;
    let square = z * z;
    let one = 1.0 - 0.5 * z;
    let lost = (1.0 - one) - 0.5 * z;
    let sine = polynomial::<FUSED>(&SINE, z, square);
    let cosine = polynomial::<FUSED>(&COSINE, z, square);
    let sin = r + mul_add::<FUSED>(r * z, sine, rho * one);
    let cos = one + mul_add::<FUSED>(square, cosine, mul_add::<FUSED>(-r, rho, lost));
    (sin, cos)
}

/// Even and odd powers side by side.
#[inline(always)]
fn polynomial<const FUSED: bool>(c: &[f64; 6], z: f64, square: f64) -> f64 {
    let fold =
        |[low, middle, high]: [f64; 3]| mul_add::<FUSED>(mul_add::<FUSED>(high, square, middle), square, low);
    mul_add::<FUSED>(fold([c[1], c[3], c[5]]), z, fold([c[0], c[2], c[4]]))
}

#[inline(always)]
fn mul_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { Library::mul_add(a, b, c) } else { a * b + c }
}
