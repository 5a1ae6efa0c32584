//! Against double-double arithmetic, whose reduction and series are its own.

use super::{BOUND, sin_cos, sin_cos_each};
use crate::scalar::{DoubleDouble, Real, Scalar};

/// |value − reference| in units of the last place of the double nearest to the reference.
fn ulps(value: f64, reference: DoubleDouble) -> f64 {
    let nearest = reference.hi().abs();
    let ulp = nearest.next_up() - nearest;
    (DoubleDouble::from_f64(value) - reference).abs().to_f64() / ulp
}

/// The larger error of sine and cosine, with and without fused products.
fn error(x: f64) -> f64 {
    let (sin, cos) = DoubleDouble::from_f64(x).sin_cos();
    [sin_cos::<true, f64>(x), sin_cos::<false, f64>(x)]
        .into_iter()
        .flat_map(|(s, c)| [ulps(s, sin), ulps(c, cos)])
        .fold(0.0, f64::max)
}

/// Low-discrepancy points of 0…1: multiples of the golden section.
fn points(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(|i| (f64::from(i) * 0.618_033_988_749_894_9).fract())
}

/// The doubles next to each multiple of π/2.
fn near_multiples(multiples: impl Iterator<Item = i64>) -> impl Iterator<Item = f64> {
    multiples.flat_map(|k| {
        let x = (DoubleDouble::pi() * DoubleDouble::ratio(k, 2)).hi();
        [x.next_down(), x, x.next_up()]
    })
}

/// The doubles up to 2²⁰ that are nearest to multiples of π/2, by search through all of them: 6e-19
/// … 6e-17.
const NEAREST: [f64; 4] = [45.553093477052, 91.106186954104, 321_307.959_442_222_9, 642_615.918_884_445_8];

/// One ulp: what is promised.
#[test]
fn error_is_below_an_ulp_where_angles_are() {
    let small = points(40_000).map(|x| 8.0 * (x - 0.5));
    let uniform = points(40_000).map(|x| BOUND * (2.0 * x - 1.0));
    let logarithmic = points(40_000).map(|x| (x * 41.0 - 21.0).exp2());
    let first = near_multiples(0..20_000);
    // Every 23rd up to 2²⁰.
    let later = near_multiples((20_000..667_544).step_by(23));
    let worst = small
        .chain(uniform)
        .chain(logarithmic)
        .chain(first)
        .chain(later)
        .chain(NEAREST)
        .map(|x| (error(x), x))
        .fold((0.0, 0.0), |worst, at| if at.0 > worst.0 { at } else { worst });
    assert!(worst.0 > 0.5, "rounding alone is half an ulp: {worst:?}");
    assert!(worst.0 < 1.0, "{worst:?}");
}

#[test]
fn beyond_the_bound_the_library_answers() {
    for x in [BOUND.next_up(), -3e9, 1e22, 1e300] {
        assert_eq!(sin_cos::<true, f64>(x), x.sin_cos());
    }
    for x in [f64::INFINITY, f64::NAN] {
        let (sin, cos) = sin_cos::<true, f64>(x);
        assert!(sin.is_nan() && cos.is_nan());
    }
}

#[test]
fn sine_is_odd_and_cosine_even() {
    for x in points(1000).map(|x| 100.0 * x).chain([0.0]) {
        let ((sin, cos), (minus_sin, same)) = (sin_cos::<true, f64>(x), sin_cos::<true, f64>(-x));
        assert_eq!((minus_sin.to_bits(), same), ((-sin).to_bits(), cos));
    }
    assert!(sin_cos::<true, f64>(-0.0).0.is_sign_negative());
}

/// Within the bound, and with one of them beyond; for each number of them that is taken together in
/// its own way.
#[test]
fn each_has_the_bits_that_it_has_alone() {
    alike::<1>();
    alike::<2>();
    alike::<3>();
    alike::<5>();
    alike::<16>();
}

/// What is side by side is fused where the target fuses.
fn alike<const K: usize>() {
    const FUSED: bool = cfg!(target_feature = "fma");
    for first in points(300).map(|x| 50.0 * (x - 0.5)) {
        for last in [first + 7.0, 2.0 * BOUND] {
            let angle = |i: usize| if i == K - 1 { last } else { first * (i as f64 + 0.1) };
            let angles: [f64; K] = core::array::from_fn(angle);
            let (sin, cos) = sin_cos_each::<FUSED, K>(angles);
            for i in 0..K {
                assert_eq!((sin[i], cos[i]), sin_cos::<FUSED, f64>(angles[i]));
            }
        }
    }
}
