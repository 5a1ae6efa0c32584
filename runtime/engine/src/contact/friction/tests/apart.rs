//! Uncoupled linkages: each moves as it does alone.

use nalgebra::{DMatrix, DVector};

use super::super::decision::FrictionSolution;
use super::super::modes::ContactMode;
use super::borders::beside;
use super::oracle::Linkage;
use super::random::{Random, cases, in_order, linkage, solve};

/// The linkage in other coordinates, `q = T q'`: M becomes full, the Delassus matrix is unchanged.
fn mixed(it: &Linkage, transformation: &DMatrix<f64>) -> Linkage {
    Linkage {
        mass: transformation.tr_mul(&it.mass) * transformation,
        jacobian: &it.jacobian * transformation,
        force: transformation.tr_mul(&it.force),
        ..it.clone()
    }
}

fn modes(linkage: &Linkage, found: &FrictionSolution) -> Vec<ContactMode> {
    in_order(linkage, &found.solutions[found.taken])
}

#[test]
fn uncoupled_linkages_do_what_each_does_alone() {
    let mut random = Random(0x510E_527F_ADE6_82D1);
    let (mut moved, mut refused, mut several) = (0, 0, 0);
    for k in 0..cases(300) {
        let pair = [linkage(&mut random, 1 + k % 3), linkage(&mut random, 1 + (k + 1) % 4)];
        let both = beside(&pair[0], &pair[1]);
        let n = both.mass.nrows();
        let shears = DMatrix::from_fn(n, n, |i, j| {
            if i == j {
                1.0
            } else if i < j {
                random.between(-0.5, 0.5)
            } else {
                0.0
            }
        });
        let alone = [solve(&pair[0]), solve(&pair[1])];
        for transformation in [DMatrix::identity(n, n), shears] {
            let (alone, together) = match (&alone, solve(&mixed(&both, &transformation))) {
                ([Ok(one), Ok(other)], Ok(together)) => ([one, other], together),
                (alone, together) => {
                    assert!(together.is_err() && alone.iter().any(Result::is_err), "{k}");
                    refused += 1;
                    continue;
                }
            };
            let expected: Vec<ContactMode> =
                pair.iter().zip(alone).flat_map(|(linkage, found)| modes(linkage, found)).collect();
            assert_eq!(modes(&both, &together), expected, "{k}");
            assert_eq!(together.complete, alone.iter().all(|it| it.complete), "{k}");
            several += usize::from(together.solutions.len() > 1);
            let accelerations = transformation * &together.solution.accelerations;
            let found = accelerations.iter().chain(together.solution.reactions.iter());
            let parts = |of: fn(&FrictionSolution) -> &DVector<f64>| alone.map(|it| of(it).iter().copied());
            let expected = parts(|it| &it.solution.accelerations).into_iter().flatten();
            let expected = expected.chain(parts(|it| &it.solution.reactions).into_iter().flatten());
            let expected: Vec<f64> = expected.collect();
            let size = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            let unique = alone.iter().all(|it| it.solution.unique);
            let compared = if unique { expected.len() } else { n };
            for (x, y) in found.zip(&expected).take(compared) {
                assert!((x - y).abs() <= 1e-9 * size, "{k}: {x} {y}");
            }
            moved += 1;
        }
    }
    assert!(moved > 200 && refused > 20 && several > 5, "{moved} {refused} {several}");
}
