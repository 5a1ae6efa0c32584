//! The limit of loads against the vertices of its linear program.

use nalgebra::{DMatrix, DVector};

use super::{Limit, find_limit, limit_by, row_space};
use crate::contact::friction::tests::random::{Random, cases};

/// Orthonormal vectors with the span of some.
fn basis(vectors: impl IntoIterator<Item = DVector<f64>>) -> Vec<DVector<f64>> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for vector in vectors {
        let rest = without(&basis, &without(&basis, &vector));
        if rest.norm() > 1e-9 {
            basis.push(rest.normalize());
        }
    }
    basis
}

fn without(basis: &[DVector<f64>], vector: &DVector<f64>) -> DVector<f64> {
    basis.iter().fold(vector.clone(), |rest, unit| &rest - unit * unit.dot(&rest))
}

/// Combinations of edges' loads that the motion determines, Σ aₑ xₑ with what other rows bear taken
/// away.
fn determined(edges: &[DVector<f64>], others: &[DVector<f64>]) -> DMatrix<f64> {
    let held = basis(others.iter().cloned());
    DMatrix::from_columns(&edges.iter().map(|edge| without(&held, edge)).collect::<Vec<_>>())
}

/// The vertices `x ≥ 0` with so many columns of A x + c s = r; s free, or zero.
fn vertices(
    a: &DMatrix<f64>,
    shift: Option<&DVector<f64>>,
    right: &DVector<f64>,
) -> Vec<(f64, DVector<f64>)> {
    let m = a.ncols();
    let of = |set: usize| {
        let basis: Vec<usize> = (0..m).filter(|k| set >> k & 1 == 1).collect();
        let mut columns: Vec<DVector<f64>> = basis.iter().map(|&k| a.column(k).into_owned()).collect();
        columns.extend(shift.cloned());
        if columns.is_empty() {
            return (right.amax() <= 1e-9).then(|| (0.0, DVector::zeros(m)));
        }
        let part = DMatrix::from_columns(&columns);
        let svd = part.clone().svd(true, true);
        if columns.len() > part.nrows() || svd.singular_values.min() < 1e-7 {
            return None;
        }
        let y = svd.solve(right, 0.0).ok()?;
        let mut x = DVector::zeros(m);
        basis.iter().zip(y.iter()).for_each(|(&k, y)| x[k] = *y);
        let meets = (&part * &y - right).amax() <= 1e-9 && x.min() >= -1e-9;
        meets.then(|| (shift.map_or(0.0, |_| y[basis.len()]), x))
    };
    (0..1usize << m).filter_map(of).collect()
}

/// The dual: the power of the loads at the velocities of the edges in a motion, whose sum is one.
fn is_of_a_motion(a: &DMatrix<f64>, loads: &DVector<f64>, (value, v): (f64, &DVector<f64>), label: usize) {
    assert!(v.min() >= -1e-9 && (v.sum() - 1.0).abs() <= 1e-9, "{label}: {v}");
    assert!((v.dot(loads) - value).abs() <= 1e-9, "{label}");
    let motions = basis(a.row_iter().map(|row| row.transpose()));
    assert!(without(&motions, v).amax() <= 1e-8, "{label}: no motion has {v}");
}

/// The farthest loads hold the same motion, and none of them is below the margin.
fn is_held(
    a: &DMatrix<f64>,
    (loads, farthest): (&DVector<f64>, &DVector<f64>),
    (margin, label): (f64, usize),
) {
    assert!((a * (farthest - loads)).amax() <= 1e-9 * a.amax(), "{label}: {farthest}");
    assert!((farthest.min() - margin).abs() <= 1e-9, "{label}: {margin} of {farthest}");
}

/// One edge of six bears, of a motion with three components: the others that vanish at the vertex
/// belong to edges that bear nothing.
#[test]
fn edges_without_loads_move_forward() {
    let columns = [
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [-1.0, 0.0, -1.0],
        [1.0, 1.0, -1.0],
        [1.0, 1.0, -1.0],
        [-1.0, -1.0, 0.0],
    ];
    let edges = columns.map(|column| DVector::from_row_slice(&column));
    let a = determined(&edges, &[]);
    for bearing in 0..edges.len() {
        let loads = DVector::from_fn(edges.len(), |k, _| if k == bearing { 0.4 } else { 0.0 });
        let Limit { margin: value, velocities, loads: found } =
            find_limit(&row_space(&edges, &[]), &loads).unwrap();
        is_held(&a, (&loads, &found), (value, bearing));
        is_of_a_motion(&a, &loads, (value, &velocities), bearing);
    }
}

#[test]
fn the_margin_is_that_of_the_best_vertex() {
    let mut random = Random(0x5104_7C3A_88E1_D2F9);
    let (mut bounded, mut unbounded, mut negative) = (0, 0, 0);
    for k in 0..cases(800) {
        let (n, m) = (2 + random.below(2), 2 + k % 5);
        let whole = k % 3 == 0;
        let entry = |random: &mut Random| match whole {
            true => random.below(3) as f64 - 1.0,
            false => random.between(-1.0, 1.0),
        };
        let column = |random: &mut Random| DVector::from_fn(n, |_, _| entry(random));
        let edges: Vec<DVector<f64>> = (0..m).map(|_| column(&mut random)).collect();
        let others: Vec<DVector<f64>> = (0..random.below(2)).map(|_| column(&mut random)).collect();
        let a = determined(&edges, &others);
        // Edges that the others take whole have no part in the motion.
        if a.column_iter().any(|column| column.norm() < 1e-6) {
            continue;
        }
        let loads = DVector::from_fn(m, |_, _| random.between(-0.3, 1.0) * [0.0, 1.0, 1.0][random.below(3)]);
        let shift = a.column_sum();
        let found = find_limit(&row_space(&edges, &others), &loads);
        // s grows for ever where x ≥ 0 can make up for it.
        if !vertices(&a, None, &-&shift).is_empty() {
            unbounded += 1;
            assert!(found.is_none() || loads.amax() == 0.0, "{k}");
            continue;
        }
        let Limit { margin: value, velocities, loads: farthest } = found.unwrap();
        let best = vertices(&a, Some(&shift), &(&a * &loads)).into_iter().map(|(s, _)| s);
        let best = best.fold(f64::NEG_INFINITY, f64::max);
        if loads.amax() == 0.0 {
            assert_eq!(value, 0.0);
            assert!(velocities.iter().all(|v| *v > 0.0));
            continue;
        }
        bounded += 1;
        negative += usize::from(best < -1e-6);
        assert!((value - best).abs() <= 1e-9, "{k}: {value} {best}");
        is_of_a_motion(&a, &loads, (value, &velocities), k);
        is_held(&a, (&loads, &farthest), (value, k));
        for unit in [1e-12, 1e12] {
            let other = find_limit(&row_space(&edges, &others), &(&loads * unit)).unwrap();
            assert!((other.margin / unit - value).abs() <= 1e-9, "{k}");
            assert!((other.velocities - &velocities).amax() <= 1e-9, "{k}");
        }
    }
    assert!(bounded > 250 && unbounded > 100 && negative > 20, "{bounded} {unbounded} {negative}");
}

/// Of many edges those that are asked first leave the same margin and motion as all of them at
/// once.
#[test]
fn many_edges_are_bounded_by_few() {
    let mut random = Random(0x1357_9BDF_0246_8ACE);
    let (mut bounded, mut unbounded) = (0, 0);
    for k in 0..cases(300) {
        let (n, m) = (2 + k % 3, 20 + random.below(60));
        // Edges that lean to one side are bounded, others hold each other.
        let lean = [0.0, 0.9, 1.2][random.below(3)];
        let entry =
            |random: &mut Random, i: usize| random.between(-1.0, 1.0) + if i == 0 { lean } else { 0.0 };
        let edges: Vec<DVector<f64>> =
            (0..m).map(|_| DVector::from_fn(n, |i, _| entry(&mut random, i))).collect();
        let loads = DVector::from_fn(m, |_, _| random.between(0.1, 1.0));
        let space = row_space(&edges, &[]);
        let all: Vec<usize> = (0..m).collect();
        let expected = limit_by(&space, &all, &space.tr_mul(&(&loads / loads.amax()).add_scalar(1.0)));
        let found = find_limit(&space, &loads);
        assert_eq!(found.is_some(), expected.is_some(), "{k}");
        let (Some(found), Some(expected)) = (found, expected) else {
            unbounded += 1;
            continue;
        };
        bounded += 1;
        assert!((found.margin / loads.amax() - (expected.margin - 1.0)).abs() <= 1e-10, "{k}");
        assert!((found.velocities - expected.velocities).amax() <= 1e-8, "{k}");
        is_held(&space.transpose(), (&loads, &found.loads), (found.margin, k));
    }
    assert!(bounded > 50 && unbounded > 50, "{bounded} {unbounded}");
}
