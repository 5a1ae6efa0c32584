use super::*;
use crate::scalar::Dual4;

const WIDTH: usize = 7;

/// Numbers in (−1, 1), four derivatives with each.
fn random(seed: &mut u64) -> Dual4 {
    let mut next = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let value = next();
    Dual4::new(value, core::array::from_fn(|_| next()))
}

/// The largest part of r − K x.
fn missed(size: usize, matrix: &[Dual4], right: &[Dual4], x: &[Dual4]) -> f64 {
    let parts = |x: Dual4| x.gradient().iter().fold(x.value().abs(), |most, dx| most.max(dx.abs()));
    let rows = (0..size).map(|i| (0..size).fold(right[i], |left, j| left - matrix[i * WIDTH + j] * x[j]));
    rows.map(parts).fold(0.0, f64::max)
}

/// Value and derivatives satisfy the equations, whatever rows have to be swapped.
#[test]
fn values_and_derivatives_satisfy_the_equations() {
    let (mut seed, mut solved) = (7, 0);
    for size in [1, 2, 3, 5, 7] {
        for case in 0..200 {
            let mut matrix: [Dual4; WIDTH * WIDTH] = core::array::from_fn(|_| random(&mut seed));
            // Zeros on the diagonal, as below constraints.
            (size / 2..size).filter(|i| *i > 0).for_each(|i| matrix[i * WIDTH + i] = Dual4::ZERO);
            let right: [Dual4; WIDTH] = core::array::from_fn(|_| random(&mut seed));
            let (mut left, mut factors, mut swaps, mut x) = (right, matrix, [0; WIDTH], [Dual4::ZERO; WIDTH]);
            let room = (&mut factors[..], &mut swaps[..]);
            if refined(MatrixShape { size, width: WIDTH }, &matrix, &mut left, 1e-2, room, &mut x) {
                let most = missed(size, &matrix, &right, &x);
                solved += 1;
                assert!(most < 1e-8, "{size}, {case}: {most:e}");
            } else {
                assert!(left == right, "{size}, {case}: the right-hand side is kept");
            }
        }
    }
    assert!(solved >= 900, "{solved} of 1000 have no small pivot");
}

/// Rows that are multiples of each other have no pivot, and numbers that are none neither.
#[test]
fn singular_systems_are_left() {
    let solves = |entries: [f64; 4]| {
        let matrix = entries.map(Dual4::constant);
        let (mut right, mut factors, mut swaps, mut x) = ([Dual4::ZERO; 2], matrix, [0; 2], [Dual4::ZERO; 2]);
        let room = (&mut factors[..], &mut swaps[..]);
        refined(MatrixShape { size: 2, width: 2 }, &matrix, &mut right, 1e-14, room, &mut x)
    };
    assert!(solves([0.0, 1.0, 1.0, 0.0]) && solves([1.0, 2.0, 2.0, 1.0]));
    assert!(!solves([1.0, 2.0, 2.0, 4.0]) && !solves([0.0; 4]) && !solves([f64::NAN, 1.0, 1.0, 0.0]));
}
