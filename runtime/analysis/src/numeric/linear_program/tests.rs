use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::*;

fn solve(g: &[f64], a: &[&[f64]], b: &[f64]) -> Option<f64> {
    let a = DMatrix::from_fn(a.len(), g.len(), |i, k| a[i][k]);
    solve_linear_program(&DVector::from_row_slice(g), &a, &DVector::from_row_slice(b))
}

/// x + y → max with x, y ≥ 0 and x + 2y ≤ 4, 3x + y ≤ 6: at (8/5, 6/5).
#[test]
fn a_corner_is_found() {
    let a: [&[f64]; 4] = [&[1.0, 0.0], &[0.0, 1.0], &[-1.0, -2.0], &[-3.0, -1.0]];
    let b = [0.0, 0.0, -4.0, -6.0];
    assert!((solve(&[-1.0, -1.0], &a, &b).unwrap() + 2.8).abs() < 1e-14);
    assert_eq!(solve(&[1.0, 1.0], &a, &b), Some(0.0));
    assert_eq!(solve(&[0.0, 0.0], &a, &b), Some(0.0));
}

#[test]
fn unbounded_and_infeasible_programs_are_detected() {
    assert_eq!(solve(&[1.0], &[&[1.0], &[-1.0]], &[1.0, 0.0]), None);
    assert_eq!(solve(&[1.0], &[&[-1.0]], &[1.0]), Some(f64::NEG_INFINITY));
    // Along a line that no bound crosses.
    assert_eq!(solve(&[1.0, 0.0], &[&[0.0, 1.0]], &[1.0]), Some(f64::NEG_INFINITY));
    assert_eq!(solve(&[0.0, 2.0], &[&[0.0, 1.0]], &[1.0]), Some(2.0));
    assert_eq!(solve(&[1.0, 0.0], &[&[0.0, 1.0], &[0.0, -1.0]], &[1.0, 0.0]), None);
    // Without bounds, and with one that says nothing or never holds.
    assert_eq!(solve(&[1.0], &[], &[]), Some(f64::NEG_INFINITY));
    assert_eq!(solve(&[0.0], &[], &[]), Some(0.0));
    assert_eq!(solve(&[0.0], &[&[0.0]], &[-1.0]), Some(0.0));
    assert_eq!(solve(&[0.0], &[&[0.0]], &[1.0]), None);
    assert_eq!(solve(&[], &[&[]], &[-1.0]), Some(0.0));
    assert_eq!(solve(&[1.0], &[&[1.0]], &[f64::NAN]), None);
}

/// The examples of Beale and of Marshall and Suurballe, on which the rule of the steepest descent
/// turns in a cycle (Chvátal, chapter 3).
#[test]
fn degenerate_corners_are_left() {
    let beale: [&[f64]; 7] = [
        &[-0.25, 60.0, 1.0 / 25.0, -9.0],
        &[-0.5, 90.0, 1.0 / 50.0, -3.0],
        &[0.0, 0.0, -1.0, 0.0],
        &[1.0, 0.0, 0.0, 0.0],
        &[0.0, 1.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.0],
        &[0.0, 0.0, 0.0, 1.0],
    ];
    let found = solve(&[-0.75, 150.0, -0.02, 6.0], &beale, &[0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0]);
    assert!((found.unwrap() + 0.05).abs() < 1e-14, "{found:?}");
    let marshall: [&[f64]; 7] = [
        &[-0.5, 5.5, 2.5, -9.0],
        &[-0.5, 1.5, 0.5, -1.0],
        &[-1.0, 0.0, 0.0, 0.0],
        &[1.0, 0.0, 0.0, 0.0],
        &[0.0, 1.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.0],
        &[0.0, 0.0, 0.0, 1.0],
    ];
    let found = solve(&[-10.0, 57.0, 9.0, 24.0], &marshall, &[0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0]);
    assert!((found.unwrap() + 1.0).abs() < 1e-13, "{found:?}");
}

/// All sets of n of some numbers.
fn choices(m: usize, n: usize) -> Vec<Vec<usize>> {
    let sets = (0..1usize << m).filter(|set| set.count_ones() as usize == n);
    sets.map(|set| (0..m).filter(|i| set >> i & 1 == 1).collect()).collect()
}

/// The least value at a corner inside |x| ≤ far, of all that n bounds have; none if there is no
/// corner.
fn enumerate(g: &DVector<f64>, a: &DMatrix<f64>, b: &DVector<f64>, far: f64) -> Option<f64> {
    let (m, n) = a.shape();
    let mut rows = a.clone().resize_vertically(m + 2 * n, 0.0);
    let mut right = b.clone().resize_vertically(m + 2 * n, -far);
    for k in 0..n {
        (rows[(m + 2 * k, k)], rows[(m + 2 * k + 1, k)]) = (1.0, -1.0);
        right[m + 2 * k] = -far;
    }
    let corner = |set: Vec<usize>| rows.select_rows(&set).full_piv_lu().solve(&right.select_rows(&set));
    let corners = choices(m + 2 * n, n).into_iter().filter_map(corner);
    let inside = corners.filter(|x| (&rows * x - &right).min() > -1e-9 * far.sqrt());
    inside.map(|x| x.dot(g)).reduce(f64::min)
}

/// Small whole numbers, so that corners meet, bounds repeat each other and directions are free:
/// corners lie within 1e4, so that what changes with a bound beyond is unbounded. Bounds, x and
/// values in other units, over 24 orders, give the same.
#[test]
fn random_problems_are_solved_as_by_enumeration() {
    let mut source = ChaCha8Rng::seed_from_u64(3);
    let mut below = |count: u64| source.next_u64() % count;
    let mut kinds = [0; 3];
    for trial in 0..3000 {
        let (n, m) = (1 + below(3) as usize, below(6) as usize);
        let most = 1 + below(3) as i64;
        let mut entry = |size: i64| (below(2 * size as u64 + 1) as i64 - size) as f64;
        let a = DMatrix::from_fn(m, n, |_, _| entry(most));
        let b = DVector::from_fn(m, |_, _| entry(most) * if trial % 3 == 0 { 0.0 } else { 1.0 });
        let g = DVector::from_fn(n, |_, _| entry(most));
        let [near, far] = [1e4, 2e4].map(|far| enumerate(&g, &a, &b, far));
        let expected = match near.zip(far) {
            None => None,
            Some((near, far)) if near - far > 1e-3 => Some(f64::NEG_INFINITY),
            Some((near, _)) => Some(near),
        };
        let is_same = |found: Option<f64>, size: f64| match (found, expected) {
            (Some(found), Some(expected)) if expected.is_finite() => (found / size - expected).abs() < 1e-9,
            _ => found == expected,
        };
        let found = solve_linear_program(&g, &a, &b);
        assert!(is_same(found, 1.0), "{found:?} {expected:?} {g} {a} {b}");
        let mut unit = || 10f64.powi(below(25) as i32 - 12);
        let (rows, x, size) = (DVector::from_fn(m, |_, _| unit()), unit(), unit());
        let scaled = DMatrix::from_fn(m, n, |i, k| a[(i, k)] * rows[i] / x);
        let found = solve_linear_program(&(&g * (size / x)), &scaled, &b.component_mul(&rows));
        assert!(is_same(found, size), "{found:?} {expected:?} {size} {rows} {x} {g} {a} {b}");
        kinds[expected.map_or(0, |value| if value.is_finite() { 1 } else { 2 })] += 1;
    }
    assert!(kinds.iter().all(|&count| count > 300), "{kinds:?}");
}
