//! Loads that are shared, inside their bounds wherever they can be.

use nalgebra::{DMatrix, DVector};

use super::move_loads;
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::friction::{ContactMode, FrictionProblem, FrictionSolution, Frictional, SlipVelocity};
use crate::numerics::decomposition::range;

/// A plank of unit mass and weight on feet at 0, 1, 2 … with μ = 0.3, its centre at `centre`,
/// pulled along.
fn plank(feet: usize, centre: f64, pull: f64) -> FrictionSolution {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 2.0]));
    let jacobian = DMatrix::from_fn(2 * feet, 3, |row, j| match (row % 2, j) {
        (0, 1) | (1, 0) => 1.0,
        (0, 2) => (row / 2) as f64 - centre,
        _ => 0.0,
    });
    let (force, bias) = (DVector::from_row_slice(&[pull, -1.0, 0.0]), DVector::zeros(2 * feet));
    let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
    let contact =
        |foot: usize| Frictional::touching((2 * foot, 2 * foot + 1), (0.3, 0.3), SlipVelocity::Rest);
    let contacts: Vec<Frictional> = (0..feet).map(contact).collect();
    kkt.solve_with_friction(&FrictionProblem { rows: LcpRows::default(), contacts: &contacts }).unwrap()
}

/// Short of the limit nothing is left to the next order, however many feet there are; at the
/// limit, and where the weight is over the last foot, something is.
#[test]
fn a_plank_at_rest_is_decided() {
    for feet in [3, 4, 5, 6, 10, 17, 60] {
        let last = (feet - 1) as f64;
        for (centre, pull, decided) in [
            (0.3 * last, 0.0, true),
            (0.3 * last, 0.2, true),
            (0.01, -0.29, true),
            (0.5 * last, 0.3, false),
            (last, 0.0, false),
        ] {
            let found = plank(feet, centre, pull);
            assert!(found.solution.accelerations.amax() < 1e-12, "{feet} {centre} {pull}");
            assert!(found.modes.iter().all(|mode| *mode == ContactMode::Stick), "{feet} {centre} {pull}");
            assert_eq!(found.next.iter().all(Frictional::is_decided), decided, "{feet} {centre} {pull}");
        }
    }
}

/// Moved loads are positive, hold what the others held, and exist where positive loads do.
#[test]
fn moved_loads_hold_the_same() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let (mut moved, mut none) = (0, 0);
    for k in 0..cases(2_000) {
        let (m, n) = (2 + random.below(7), 1 + random.below(3));
        let columns = DMatrix::from_fn(n, m, |_, _| random.between(-1.0, 1.0));
        let determined = range(&columns.transpose());
        // Some loads that are positive, or a vertex of such, or any.
        let positive = random.below(3) > 0;
        let load = |random: &mut Random| random.between(if positive { 0.01 } else { -1.0 }, 1.0);
        let inner = DVector::from_fn(m, |_, _| load(&mut random));
        let along =
            &inner - &determined * determined.tr_mul(&DVector::from_fn(m, |_, _| random.between(-1.0, 1.0)));
        let loads = &inner + (&along - &determined * determined.tr_mul(&along)) * 3.0;
        match move_loads(&determined, &loads) {
            Some(found) => {
                moved += 1;
                assert!(determined.tr_mul(&(&found - &loads)).amax() < 1e-9, "{k}");
                assert!(found.min() > 0.0 && found.min() <= loads.amax() * (1.0 + 1e-9), "{k}");
            }
            None => {
                none += 1;
                assert!(!positive, "{k}: {inner}");
            }
        }
    }
    assert!(moved > 800 && none > 100, "{moved} {none}");
}

/// Loads of which the motion determines nothing are moved to where the largest was.
#[test]
fn free_loads_are_bounded() {
    let moved = move_loads(&DMatrix::zeros(2, 0), &DVector::from_row_slice(&[0.0, 3.0])).unwrap();
    assert_eq!(moved.as_slice(), [3.0, 3.0]);
    assert_eq!(range(&DMatrix::zeros(2, 0)).shape(), (2, 0));
}
