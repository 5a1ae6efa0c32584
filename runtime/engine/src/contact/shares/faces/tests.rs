//! Planes of cones, and how well reactions are known.

use nalgebra::{DMatrix, DVector};

use super::super::{Factor, Shares};
use super::known;
use crate::contact::friction::tests::random::{Random, cases};

/// What is above all planes, and on those that hold it, is in the cone.
#[test]
fn planes_bound_the_cones() {
    let mut random = Random(0x5104_7C3A_88E1_D2F9);
    let (normal, tangent) = (2, 0);
    for k in 0..cases(600) {
        let slope = random.between(-1.5, 1.5) * [0.0, 1.0, 1.0][k % 3];
        let bears = random.between(-1.0, 1.0);
        let mut x = DVector::from_row_slice(&[random.between(-1.0, 1.0), random.between(-1.0, 1.0), bears]);
        let (factor, is_within) = match (k / 3) % 4 {
            0 => (Factor::Pressing(normal), bears >= 0.0),
            1 => (
                Factor::Cone { normal, tangent, limit: slope.abs() },
                x[tangent].abs() <= slope.abs() * bears,
            ),
            2 => (Factor::Edge { normal, tangent, slope }, false),
            _ => {
                x[tangent] = slope * bears;
                (Factor::Edge { normal, tangent, slope }, bears >= 0.0)
            }
        };
        let shares =
            Shares { jacobian: DMatrix::zeros(3, 1), load: DVector::zeros(1), factors: vec![factor] };
        let [held, above] = shares.planes();
        let unit = |plane: &nalgebra::RowDVector<f64>| (plane.norm() - 1.0).abs() < 1e-15;
        assert!(held.iter().chain(&above).all(unit), "{k}");
        let on = held.iter().all(|plane| (plane * &x)[0].abs() < 1e-14);
        let over = above.iter().all(|plane| (plane * &x)[0] >= -1e-15);
        assert_eq!(on && over, is_within, "{k} {factor:?} {x}");
    }
    // Without friction nothing is borne across, nor drawn.
    let cone = Factor::Cone { normal: 0, tangent: 1, limit: 0.0 };
    let shares = Shares { jacobian: DMatrix::zeros(2, 1), load: DVector::zeros(1), factors: vec![cone] };
    let [_, above] = shares.planes();
    for (x, is_within) in
        [([1.0, 0.0], true), ([-1.0, 0.0], false), ([1.0, 0.1], false), ([1.0, -0.1], false)]
    {
        let x = DVector::from_row_slice(&x);
        assert_eq!(above.iter().all(|plane| (plane * &x)[0] >= 0.0), is_within, "{x}");
    }
}

/// Rows of any lengths at an angle with the cosine c have the condition number √((1 + c)/(1 − c));
/// one that repeats another or is zero changes it little.
#[test]
fn reactions_are_known_by_the_angles_of_their_rows() {
    let rounding = 16.0 * f64::EPSILON;
    for c in [0.0, 0.5, -0.9, 1.0 - 1e-6, 1.0 - 1e-10] {
        let rows = |lengths: [f64; 2]| {
            DMatrix::from_row_slice(
                2,
                3,
                &[lengths[0], 0.0, 0.0, lengths[1] * c, 0.0, lengths[1] * (1.0 - c * c).sqrt()],
            )
        };
        let condition = ((1.0 + f64::abs(c)) / (1.0 - f64::abs(c))).sqrt();
        for lengths in [[1.0, 1.0], [1e-9, 1e5], [1e9, 1e-6]] {
            let found = known(&rows(lengths)) / rounding;
            assert!((found / condition - 1.0).abs() < 1e-4, "{c} {lengths:?}: {found} {condition}");
            let with_zero = known(&rows(lengths).insert_row(1, 0.0)) / rounding;
            assert!((with_zero / condition - 1.0).abs() < 1e-4, "{c} {lengths:?}: {with_zero}");
        }
    }
    // What rounding leaves of a row that repeats another does not count.
    let twice = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 2.0, 1e-17]);
    assert!((known(&twice) / rounding - 1.0).abs() < 1e-12);
    // At the angle θ the singular values are √2 and θ/√2, of which the ratio counts down to 64
    // times the unit roundoff.
    for (angle, condition) in [(2.2e-14, 1.0), (3.6e-14, 2.0 / 3.6e-14)] {
        let close = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 1.0, angle]);
        assert!((known(&close) / rounding / condition - 1.0).abs() < 0.1, "{angle}");
    }
}

/// Reactions hold a load, and are within their cones, up to 1e-12 of themselves.
#[test]
fn conditions_are_met_up_to_rounding() {
    for unit in [1e-15, 1.0, 1e15] {
        // Two contacts without friction and one that slides, of which the first bears all.
        let factors = vec![
            Factor::Pressing(0),
            Factor::Pressing(1),
            Factor::Edge { normal: 2, tangent: 3, slope: 0.5 },
        ];
        let jacobian = DMatrix::from_row_slice(4, 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        let load = DVector::from_row_slice(&[1.0, 0.0]) * unit;
        let conditions = Shares { jacobian, load, factors }.conditions();
        let met = |x: [f64; 4]| conditions.are_met(&(DVector::from_row_slice(&x) * unit));
        assert!(met([1.0, 0.0, 0.0, 0.0]) && met([0.5, 0.0, 0.5, 0.25]), "{unit}");
        let sides = [(0.8e-12, true), (1.2e-12, false)];
        for (part, expected) in sides {
            // The load is missed, to either side, by a part of the row's length; a contact draws;
            // what slides is off its edge.
            let missed = part * f64::sqrt(2.0);
            assert_eq!(met([1.0 + missed, 0.0, 0.0, 0.0]), expected, "{unit} {part}");
            assert_eq!(met([1.0 - missed, 0.0, 0.0, 0.0]), expected, "{unit} {part}");
            assert_eq!(met([1.0, -part, 0.0, 0.0]), expected, "{unit} {part}");
            assert_eq!(met([1.0, part, 0.0, 0.0]), expected, "{unit} {part}");
            assert_eq!(met([1.0 + part, 0.0, -part, -0.5 * part]), expected, "{unit} {part}");
            let off = part * f64::hypot(1.0, 0.5);
            assert_eq!(met([1.0, 0.0, 0.0, off]), expected, "{unit} {part}");
        }
        assert!(!met([1.1, 0.0, -0.1, -0.05]) && !met([0.9, 0.0, 0.1, 0.1]) && !met([0.0; 4]), "{unit}");
    }
}
