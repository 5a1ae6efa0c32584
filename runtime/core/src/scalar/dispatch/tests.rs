//! Each set of instructions that this processor has against doubles one by one.

use proptest::prelude::*;

use super::found::{Avx2, Avx512};
use super::fused::Fused;
use super::{Double, Inside, Vector, has_fma};
use crate::chain::Chain;
use crate::scalar::{LANES, Lanes, Real};

/// Some use of every operation.
#[inline(always)]
fn formula<S: Real>([x, y, z]: [S; 3]) -> [S; 5] {
    let ([sin, shifted], [cos, _]) = S::sin_cos_each([x * y, z - x]);
    let root = x.mul_add(x, y * y).sqrt();
    let chain = Chain::new(x, y, S::ratio(1, 5), [z, S::from_f64(9.81)]).articulated(&[x, y, z], &[z, x, y]);
    let ratio = (x - y) / (z + S::from_f64(0.1));
    [sin / root, -cos - S::ratio(2, 7) * shifted, root.mul_add(y, S::pi()), ratio * x.sign(), chain[1]]
}

struct Formula<'a, X: Vector>(&'a [Lanes<2, X>; 3]);

impl<X: Vector> Inside for Formula<'_, X> {
    type Output = [Lanes<2, X>; 5];

    #[inline(always)]
    fn run(self) -> Self::Output {
        formula(*self.0)
    }
}

/// The bits of each lane; not fused one by one where the target cannot, so that they differ by some
/// roundings there.
fn as_one_by_one<X: Vector>(values: &[[f64; 3]]) {
    let lanes = core::array::from_fn(|i| Lanes::<2, X>::from_fn(|lane| values[lane][i]));
    let found = X::inside(Formula(&lanes));
    for (lane, alone) in values.iter().enumerate() {
        for (found, one) in found.iter().zip(formula(*alone)) {
            let found = found.lane(lane);
            if cfg!(target_feature = "fma") {
                assert_eq!(found.to_bits(), one.to_bits(), "{alone:?}");
            } else {
                assert!((found - one).abs() <= 1e-9 * one.abs().max(1.0), "{found} for {one} at {alone:?}");
            }
        }
    }
}

struct Alone<'a, S>(&'a [S; 3]);

impl<S: Double> Inside for Alone<'_, S> {
    type Output = [f64; 5];

    #[inline(always)]
    fn run(self) -> [f64; 5] {
        formula(*self.0).map(S::value)
    }
}

/// The bits of doubles that are fused, or nearly the values of those that are not.
fn fused_is_as_plain(values: &[[f64; 3]]) {
    for value in values {
        let (fused, plain) = (Fused::inside(Alone(&value.map(Fused::from_f64))), f64::inside(Alone(value)));
        for (fused, plain) in fused.into_iter().zip(plain) {
            if cfg!(target_feature = "fma") {
                assert_eq!(fused.to_bits(), plain.to_bits(), "{value:?}");
            } else {
                assert!(
                    (fused - plain).abs() <= 1e-9 * plain.abs().max(1.0),
                    "{fused} for {plain} at {value:?}"
                );
            }
        }
    }
}

fn views_agree<X: Vector>(values: &[[f64; 3]]) {
    let mut lanes: [Lanes<2>; 3] = core::array::from_fn(|i| Lanes::from_fn(|lane| values[lane][i]));
    for (i, own) in X::view_mut(&mut lanes).iter_mut().enumerate() {
        assert!((0..2 * LANES).all(|lane| own.lane(lane) == values[lane][i]));
        own.set(LANES + 1, -0.5);
    }
    assert!(
        X::view(&lanes)
            .iter()
            .zip(&lanes)
            .all(|(x, own)| x.lane(LANES + 1) == -0.5 && own.lane(LANES + 1) == -0.5)
    );
}

/// The bounds that are told: the parabola's distance from log₂ and 2ˣ between powers of two.
fn rough<X: Vector>() {
    for k in 0..4000 {
        let x = f64::from(k) * 0.17 - 340.0;
        let power = Lanes::<1, X>::splat(x).rough_exp2().lane(0);
        assert!((power / x.exp2() - 1.0).abs() < 0.003, "{x}: {power}");
        let log = Lanes::<1, X>::splat(x.exp2()).rough_log2().lane(0);
        assert!((log - x).abs() < 0.01, "{x}: {log}");
    }
    let [low, high] = [-1.5, 2.0].map(Lanes::<1, X>::splat);
    assert_eq!([low.max(high), low.min(high), low.abs()].map(|x| x.lane(7)), [2.0, -1.5, 1.5]);
}

/// Those of several angles, for which vectors are taken, as those of each.
fn angles_are_as_each_alone<const K: usize>(angles: [f64; K]) {
    let (sin, cos) = Fused::inside(All(angles));
    for (k, angle) in angles.into_iter().enumerate() {
        let (one_sin, one_cos) = Fused::inside(All([angle]));
        assert_eq!([sin[k], cos[k]].map(f64::to_bits), [one_sin[0], one_cos[0]].map(f64::to_bits), "{angle}");
        assert!((sin[k] - angle.sin()).abs() <= f64::EPSILON && (cos[k] - angle.cos()).abs() <= f64::EPSILON);
    }
}

struct All<const K: usize>([f64; K]);

impl<const K: usize> Inside for All<K> {
    type Output = ([f64; K], [f64; K]);

    #[inline(always)]
    fn run(self) -> Self::Output {
        let (sin, cos) = Fused::sin_cos_each(self.0.map(Fused::from_f64));
        (sin.map(Fused::value), cos.map(Fused::value))
    }
}

proptest! {
    #[test]
    fn angles_by_vectors_are_those_of_each(angles in [-1e3..1e3, -1e7..1e7, -4.0..4.0]) {
        if has_fma() {
            let at = |k: usize| angles[k % 3] / (1 + k / 3) as f64;
            angles_are_as_each_alone::<7>(core::array::from_fn(at));
            angles_are_as_each_alone::<8>(core::array::from_fn(at));
            angles_are_as_each_alone::<19>(core::array::from_fn(at));
        }
    }

    /// Beyond what is reduced by parts of π too.
    #[test]
    fn every_set_has_the_bits_of_doubles(
        values in proptest::collection::vec([-1e3..1e3, -1e5..1e5, 0.1..9.0], 2 * LANES),
    ) {
        if std::arch::is_x86_feature_detected!("avx512f") {
            as_one_by_one::<Avx512>(&values);
            views_agree::<Avx512>(&values);
        }
        if has_fma() {
            fused_is_as_plain(&values);
            as_one_by_one::<Avx2>(&values);
            views_agree::<Avx2>(&values);
        }
    }
}

#[test]
fn rough_functions_of_every_set() {
    rough::<wide::f64x8>();
    if std::arch::is_x86_feature_detected!("avx512f") {
        rough::<Avx512>();
    }
    if has_fma() {
        rough::<Avx2>();
    }
}
