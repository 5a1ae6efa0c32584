//! Sine and cosine of doubles, inlined and without branches, so that several are computed side by
//! side.
//!
//! x = q π/2 + r + ρ with |r| ≤ π/4, q an integer, ρ below the last place of r: π/2 is subtracted
//! in parts (W. J. Cody and W. Waite, *Software Manual for the Elementary Functions*, 1980, ch. 8).
//! Then, with z = r²,
//!
//! ```text
//! sin(r + ρ) = r + (r z S(z) + ρ (1 − z/2))
//! cos(r + ρ) = (1 − z/2) + (z² C(z) − r ρ)
//! ```
//!
//! with the minimax polynomials S and C of fdlibm (Sun Microsystems, 1993, `k_sin.c`, `k_cos.c`).
//! The error is below 1 ulp for
//! |x| ≤ 2²⁰; beyond, and of what is no number, these are the library's functions.

#[cfg(test)]
mod tests;

mod doubles;

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

pub(super) use doubles::Doubles;
#[cfg(feature = "std")]
use wide::{f64x2, f64x4};

/// Up to here the product of q with the first parts of π/2 is exact, or fused.
const BOUND: f64 = (1 << 20) as f64;

/// 1.5 · 2⁵², beside which a double has no fraction: what is added to it is rounded to an integer,
/// in the last bits.
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

/// `(sin x, cos x)`, elementwise.
#[inline(always)]
pub(super) fn sin_cos<const FUSED: bool, X: Doubles>(x: X) -> (X, X) {
    if x.within(BOUND) { reduced::<FUSED, X>(x) } else { x.singly::<FUSED>() }
}

/// The same of several, each `V` times as many: without a branch between one and the next while all
/// are within the bound. Sixteen states take 9.3 ns each for the angles of eight bars, 17.6 with
/// one.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn sin_cos_all<const FUSED: bool, X: Doubles, const V: usize, const K: usize>(
    angles: [[X; V]; K],
) -> ([[X; V]; K], [[X; V]; K]) {
    let within = angles.as_flattened().iter().fold(true, |within, x| within & x.within(BOUND));
    if within { each(angles, |x| each(x, reduced::<FUSED, X>)) } else { all_beyond::<FUSED, X, V, K>(angles) }
}

/// The same without closures, which are functions of their own: all of it is compiled for the
/// instructions of what it stands in.
#[cfg(all(feature = "std", target_arch = "x86_64", any(test, not(target_feature = "avx512f"))))]
#[inline(always)]
pub(super) fn sin_cos_inlined<const FUSED: bool, X: Doubles, const V: usize, const K: usize>(
    angles: [[X; V]; K],
) -> ([[X; V]; K], [[X; V]; K]) {
    let mut within = true;
    for k in 0..K {
        for v in 0..V {
            within &= angles[k][v].within(BOUND);
        }
    }
    if !within {
        return all_beyond::<FUSED, X, V, K>(angles);
    }
    let (mut sin, mut cos) = (angles, angles);
    for k in 0..K {
        for v in 0..V {
            (sin[k][v], cos[k][v]) = reduced::<FUSED, X>(angles[k][v]);
        }
    }
    (sin, cos)
}

/// Some are beyond the bound.
#[cfg(feature = "std")]
#[cold]
#[inline(never)]
fn all_beyond<const FUSED: bool, X: Doubles, const V: usize, const K: usize>(
    angles: [[X; V]; K],
) -> ([[X; V]; K], [[X; V]; K]) {
    each(angles, |x| each(x, sin_cos::<FUSED, X>))
}

/// Sines and cosines one by one.
#[inline(always)]
pub(super) fn each<X: Copy, const K: usize>(
    angles: [X; K],
    sin_cos: impl Fn(X) -> (X, X),
) -> ([X; K], [X; K]) {
    let (mut sin, mut cos) = (angles, angles);
    for k in 0..K {
        (sin[k], cos[k]) = sin_cos(angles[k]);
    }
    (sin, cos)
}

/// Sines and cosines of several angles, with the bits that each has by itself: side by side while
/// all are within the bound.
///
/// Four at most: what is computed with them afterwards is scalar, and vectors of eight keep one of
/// two scalar units idle meanwhile (the right-hand side of six bars takes 92 ns with them, 63
/// without).
#[inline(always)]
pub(super) fn sin_cos_each<const FUSED: bool, const K: usize>(angles: [f64; K]) -> ([f64; K], [f64; K]) {
    #[cfg(not(feature = "std"))]
    return each(angles, sin_cos::<FUSED, f64>);
    #[cfg(feature = "std")]
    {
        let (fours, rest) = angles.as_chunks::<4>();
        let (twos, last) = rest.as_chunks::<2>();
        let within = fours.iter().fold(true, |within, &four| within & f64x4::from(four).within(BOUND));
        let within = twos.iter().fold(within, |within, &two| within & f64x2::from(two).within(BOUND));
        if !last.iter().fold(within, |within, one| within & one.within(BOUND)) {
            let (mut sin, mut cos) = ([0.0; K], [0.0; K]);
            beyond::<FUSED, K>(angles, &mut sin, &mut cos);
            return (sin, cos);
        }
        let (mut sin, mut cos) = ([0.0; K], [0.0; K]);
        for (i, &four) in fours.iter().enumerate() {
            side_by_side::<FUSED, f64x4, 4, K>(four, 4 * i, &mut sin, &mut cos);
        }
        for &two in twos {
            side_by_side::<FUSED, f64x2, 2, K>(two, K & !3, &mut sin, &mut cos);
        }
        for &one in last {
            (sin[K - 1], cos[K - 1]) = reduced::<FUSED, f64>(one);
        }
        (sin, cos)
    }
}

/// Those from `first` on.
#[cfg(feature = "std")]
#[inline(always)]
fn side_by_side<const FUSED: bool, X, const W: usize, const K: usize>(
    angles: [f64; W],
    first: usize,
    sin: &mut [f64; K],
    cos: &mut [f64; K],
) where
    X: Doubles + From<[f64; W]> + Into<[f64; W]>,
{
    let (s, c) = reduced::<FUSED, X>(angles.into());
    sin[first..first + W].copy_from_slice(&s.into());
    cos[first..first + W].copy_from_slice(&c.into());
}

/// Some are beyond the bound. Two arrays apart: of one, a vector of eight would be made where all
/// are within.
#[cfg(feature = "std")]
#[cold]
fn beyond<const FUSED: bool, const K: usize>(angles: [f64; K], sin: &mut [f64; K], cos: &mut [f64; K]) {
    (*sin, *cos) = each(angles, sin_cos::<FUSED, f64>);
}

/// For |x| ≤ [`BOUND`]. The sine of −x is that of x with its sign, that of −0 too.
#[inline(always)]
fn reduced<const FUSED: bool, X: Doubles>(x: X) -> (X, X) {
    let angle = x.abs();
    let shifted = angle.mul_add::<FUSED>(X::splat(FRAC_2_PI), X::splat(ROUND));
    let q = shifted - X::splat(ROUND);
    let (sin, cos) = near_zero::<FUSED, X>(if FUSED { fused_rest(angle, q) } else { plain_rest(angle, q) });
    let quarter = shifted.to_bits();
    let (odd, sign) = (X::lowest_bit_everywhere(quarter), X::bits(1 << 63));
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    let changed = (sin ^ cos) & odd;
    let below = (quarter << 62 ^ x.to_bits()) & sign;
    let left = (quarter + X::bits(1)) << 62 & sign;
    (X::from_bits(sin ^ changed ^ below), X::from_bits(cos ^ changed ^ left))
}

/// x − q π/2 = r + ρ; the first difference is exact.
#[inline(always)]
fn fused_rest<X: Doubles>(x: X, q: X) -> (X, X) {
    let (high, middle, low) = (X::splat(FUSED_PARTS[0]), X::splat(FUSED_PARTS[1]), X::splat(FUSED_PARTS[2]));
    let q = -q;
    let first = q.mul_add::<true>(high, x);
    let rest = q.mul_add::<true>(middle, first);
    let error = q.mul_add::<true>(middle, first - rest);
    (rest, q.mul_add::<true>(low, error))
}

/// The same by exact products and differences that keep their rounding.
#[inline(always)]
fn plain_rest<X: Doubles>(x: X, q: X) -> (X, X) {
    let product = |part: usize| q * X::splat(PLAIN_PARTS[part]);
    let (rest, first) = difference(x - product(0), product(1));
    let (rest, second) = difference(rest, product(2));
    (rest, first + second - product(3))
}

/// a − b and its rounding (D. E. Knuth, *The Art of Computer Programming* 2, § 4.2.2, theorem B).
#[inline(always)]
fn difference<X: Doubles>(a: X, b: X) -> (X, X) {
    let difference = a - b;
    let minus_b = difference - a;
    (difference, (a - (difference - minus_b)) - (b + minus_b))
}

#[inline(always)]
fn near_zero<const FUSED: bool, X: Doubles>((r, rho): (X, X)) -> (X, X) {
    let z = r * r;
    let (square, half) = (z * z, X::splat(0.5) * z);
    let one = X::splat(1.0) - half;
    let lost = (X::splat(1.0) - one) - half;
    let sine = polynomial::<FUSED, X>(&SINE, z, square);
    let cosine = polynomial::<FUSED, X>(&COSINE, z, square);
    let sin = r + (r * z).mul_add::<FUSED>(sine, rho * one);
    let cos = one + square.mul_add::<FUSED>(cosine, (-r).mul_add::<FUSED>(rho, lost));
    (sin, cos)
}

/// Even and odd powers side by side.
#[inline(always)]
fn polynomial<const FUSED: bool, X: Doubles>(c: &[f64; 6], z: X, square: X) -> X {
    let fold = |[low, middle, high]: [f64; 3]| {
        let upper = X::splat(high).mul_add::<FUSED>(square, X::splat(middle));
        upper.mul_add::<FUSED>(square, X::splat(low))
    };
    fold([c[1], c[3], c[5]]).mul_add::<FUSED>(z, fold([c[0], c[2], c[4]]))
}
