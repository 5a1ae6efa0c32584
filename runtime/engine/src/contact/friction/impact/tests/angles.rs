//! Kinetic angles by the Delassus matrix of the rows that hold both ways, taken in one after the
//! other.

use nalgebra::{DMatrix, DVector};

use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::impulse::{Collision, Row};
use crate::model::Law;

/// J M̂⁻¹ Jᵀ: of each held row what it has in common with the others is taken away.
fn delassus(it: &Collision, held: &[usize]) -> DMatrix<f64> {
    let mut w = &it.jacobian * it.mass.clone().try_inverse().unwrap() * it.jacobian.transpose();
    for &row in held {
        let column = w.column(row).into_owned();
        if column[row] > 1e-9 {
            w -= &column * column.transpose() / column[row];
        }
    }
    w
}

#[test]
fn kinetic_angles_are_those_of_the_delassus_matrix() {
    let mut random = Random(0x9B05_688C_2B3E_6C1F);
    let mut right = 0;
    for k in 0..cases(400) {
        let (n, held, contacts) = (4, random.below(3), 2 + random.below(2));
        let r = held + contacts;
        // Whole numbers now and then, for right angles.
        let mut entry = || if k % 2 == 0 { random.between(-1.0, 1.0) } else { random.below(3) as f64 - 1.0 };
        let jacobian = DMatrix::from_fn(r, n, |_, _| entry());
        let root = DMatrix::from_fn(n, n, |_, _| entry());
        let mass = if k % 2 == 0 {
            &root * root.transpose() + DMatrix::identity(n, n)
        } else {
            DMatrix::identity(n, n)
        };
        let contact = Row::Contact { restitution: 0.5, law: Law::Newton };
        let rows = (0..r).map(|row| if row < held { Row::TwoSided } else { contact }).collect();
        let (rates, drift) = (DVector::zeros(n), DVector::zeros(r));
        let it =
            Collision { mass, jacobian, applied: rates.clone(), rates, prescribed_gap_rate: drift, rows };
        let held: Vec<usize> = (0..held).collect();
        let w = delassus(&it, &held);
        let all: Vec<usize> = (held.len()..r).collect();
        for unit in [1.0, 1e-9] {
            let scaled = Collision { jacobian: &it.jacobian * unit, mass: &it.mass / unit, ..it.clone() };
            let told = scaled.kinetic_angles(&all);
            for (at, &a) in all.iter().enumerate() {
                for &b in &all[at + 1..] {
                    let found = scaled.kinetic_angle(a, b);
                    if w[(a, a)] < 1e-9 || w[(b, b)] < 1e-9 {
                        assert_eq!(found, None, "{k}: a contact that cannot move");
                        continue;
                    }
                    let cosine = -w[(a, b)] / (w[(a, a)] * w[(b, b)]).sqrt();
                    if cosine.abs() > 1.0 - 1e-9 {
                        assert_eq!(found, None, "{k}: one depends on the other");
                        continue;
                    }
                    let expected = (cosine.abs() > 1e-9).then(|| cosine.acos());
                    right += usize::from(expected.is_none());
                    assert_eq!(found.is_some(), expected.is_some(), "{k} {cosine}");
                    let apart = found.zip(expected).map_or(0.0, |(x, y)| (x - y).abs());
                    assert!(apart < 1e-9, "{k}: {found:?} {expected:?}");
                    // One that depends on two before it is left out among all.
                    let among = told.iter().find(|(pair, _)| *pair == [a, b]).map(|(_, angle)| *angle);
                    assert!(among.is_none() || among == found, "{k} {among:?} {found:?}");
                }
            }
            assert!(all.len() > 2 || told.len() <= 1);
        }
        assert!(it.kinetic_angles(&all[..1]).is_empty());
    }
    assert!(right > 20, "{right}");
}
