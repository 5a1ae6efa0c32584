//! The balanced equations are the equations in other units, whatever the balance.

use nalgebra::{DMatrix, DVector};

use super::EquilibratedKkt;

const N: usize = 3;
const ROWS: usize = 4;

/// Entries of either sign, of very different sizes.
fn entry(i: usize, j: usize) -> f64 {
    let sign = if (i + 2 * j).is_multiple_of(3) { -1.0 } else { 1.0 };
    sign * (1.0 + 0.37 * i as f64 + 0.11 * j as f64) * 10f64.powi((i * 5 + j * 3) as i32 % 7 - 3)
}

/// M, J whose last row is so many times its normal's, f and −b.
fn equations(weak: f64) -> (DMatrix<f64>, DMatrix<f64>, DVector<f64>, DVector<f64>) {
    let root = DMatrix::from_fn(N, N, |i, j| if i == j { 2.0 + i as f64 } else { 0.1 * (i + j) as f64 });
    let mass = &root * root.transpose();
    let mut jacobian = DMatrix::from_fn(ROWS, N, entry);
    let scaled = jacobian.row(1) * weak;
    jacobian.set_row(3, &scaled);
    (mass, jacobian, DVector::from_fn(N, |i, _| entry(i, 9)), DVector::from_fn(ROWS, |i, _| entry(i, 8)))
}

#[test]
fn balanced_equations_are_the_equations_in_other_units() {
    for (weak, is_limited) in [(1.0, false), (0.9e-3, true), (1e-9, true), (1.1e-3, false)] {
        let (mass, jacobian, force, bias) = equations(weak);
        let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias.abs()));
        let before = kkt.scale.clone();
        kkt.limit_tangents([(0, 2), (1, 3)].into_iter());
        let mut whole = DMatrix::zeros(N + ROWS, N + ROWS);
        whole.view_mut((0, 0), (N, N)).copy_from(&mass);
        whole.view_mut((N, 0), (ROWS, N)).copy_from(&jacobian);
        whole.view_mut((0, N), (N, ROWS)).copy_from(&-jacobian.transpose());
        let right = DVector::from_fn(N + ROWS, |i, _| if i < N { force[i] } else { -bias[i - N] });
        let mut largest = 0.0_f64;
        for i in 0..N + ROWS {
            for j in 0..N + ROWS {
                let expected = kkt.scale[i] * kkt.scale[j] * whole[(i, j)];
                assert!((kkt.matrix[(i, j)] - expected).abs() <= 1e-14 * expected.abs(), "{weak} {i} {j}");
            }
            let expected = kkt.scale[i] * right[i];
            assert!((kkt.right[i] - expected).abs() <= 1e-14 * expected.abs(), "{weak} {i}");
            largest = largest.max(expected.abs());
        }
        // All are connected.
        assert!(kkt.tolerance.iter().all(|it| (it / (1e-12 * largest) - 1.0).abs() < 1e-12), "{weak}");
        // The tangent's own scale is the normal's over `weak`.
        let most = 1e3 * kkt.scale[N + 1];
        let expected = if is_limited { most } else { before[N + 3] };
        assert!((kkt.scale[N + 3] / expected - 1.0).abs() < 1e-12, "{weak}");
        let others = (0..N + ROWS).filter(|i| *i != N + 3);
        assert!(others.into_iter().all(|i| kkt.scale[i] == before[i]), "{weak}");
    }
}

/// 1/√M of coordinates with mass, by J of others; rows to a largest entry of one.
#[test]
fn scales_follow_from_the_masses() {
    let (mut mass, jacobian, force, bias) = equations(0.5);
    mass.row_mut(2).fill(0.0);
    mass.column_mut(2).fill(0.0);
    let kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias.abs()));
    for j in 0..2 {
        assert!((kkt.scale[j] * mass[(j, j)].sqrt() - 1.0).abs() < 1e-14);
    }
    assert!((kkt.scale[2] * jacobian.column(2).amax() - 1.0).abs() < 1e-14);
    for row in 0..ROWS {
        let largest = (0..N).map(|j| kkt.matrix[(N + row, j)].abs()).fold(0.0, f64::max);
        assert!((largest - 1.0).abs() < 1e-14, "{row}");
    }
}
