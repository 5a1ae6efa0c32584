//! Newton's method, step by step.

use nalgebra::{DMatrix, DVector};

use super::super::{Factor, Shares, step};
use crate::contact::friction::tests::random::{Random, cases};

/// The nearest point of a factor to one, of those on each of its faces.
fn nearest(factor: &Factor, x: [f64; 2]) -> [f64; 2] {
    // Along an edge λ (1, slope), λ ≥ 0.
    let on = |slope: f64| {
        let bears = f64::max((x[0] + slope * x[1]) / (1.0 + slope * slope), 0.0);
        [bears, slope * bears]
    };
    match *factor {
        Factor::Pressing(_) => [x[0].max(0.0), x[1]],
        Factor::Edge { slope, .. } => on(slope),
        Factor::Cone { limit, .. } if x[1].abs() <= limit * x[0] => x,
        Factor::Cone { limit, .. } => {
            let far = |p: [f64; 2]| (p[0] - x[0]).hypot(p[1] - x[1]);
            let [one, other] = [on(limit), on(-limit)];
            if far(one) < far(other) { one } else { other }
        }
    }
}

/// What is projected is the nearest point, and its derivative that of small differences.
#[test]
fn projections_are_the_nearest_points() {
    let mut random = Random(0x1F83_D9AB_FB41_BD6B);
    let (normal, tangent) = (2, 0);
    for k in 0..cases(600) {
        let slope = random.between(-1.5, 1.5);
        let factor = match k % 3 {
            0 => Factor::Pressing(normal),
            1 => Factor::Edge { normal, tangent, slope },
            _ => Factor::Cone { normal, tangent, limit: slope.abs() },
        };
        let x = DVector::from_fn(3, |_, _| random.between(-1.0, 1.0));
        let projected = |x: &DVector<f64>| {
            let [n, t] = nearest(&factor, [x[normal], x[tangent]]);
            DVector::from_row_slice(&[t, x[1], n])
        };
        let (mut found, mut rows) = (x.clone(), DMatrix::identity(3, 3));
        factor.project(&mut found, &mut rows);
        assert!((&found - projected(&x)).amax() < 1e-14, "{k} {factor:?} {x} {found}");
        for j in 0..3 {
            let small = DVector::from_fn(3, |i, _| if i == j { 1e-6 } else { 0.0 });
            let [ahead, behind] = [&x + &small, &x - &small].map(|x| projected(&x));
            // The two sides of a corner of the cone differ.
            let middle = (&ahead + &behind - projected(&x) * 2.0).amax();
            let slope = (ahead - behind) / 2e-6;
            assert!(middle > 1e-10 || (rows.column(j) - slope).amax() < 1e-8, "{k} {factor:?} {x} {rows}");
        }
    }
}

/// Without conditions the dual is quadratic: c times Newton's step Δ from y lowers it by (c p − ½
/// (c p)²) of Δ·r at the part p, which is enough while c p < 2 − 2e-4.
#[test]
fn steps_are_halved_until_the_dual_falls() {
    let mut random = Random(0xCBBB_9D5D_C105_9ED8);
    for k in 0..cases(200) {
        let unit = [1.0, 1e-9, 1e9][k % 3];
        let jacobian = DMatrix::from_fn(4, 2, |_, _| random.between(-1.0, 1.0));
        let load = DVector::from_fn(2, |_, _| random.between(-1.0, 1.0)) * unit;
        let y = DVector::from_fn(2, |_, _| random.between(-3.0, 3.0)) * unit;
        let rest = &load - jacobian.tr_mul(&(&jacobian * &y));
        let newton = step(&jacobian, &jacobian, &rest).unwrap();
        assert!((jacobian.tr_mul(&(&jacobian * &newton)) - &rest).amax() < 1e-9 * unit);
        let shares = Shares { jacobian, load, factors: Vec::new() };
        for (times, part) in [
            (1.0, 1.0),
            (1.99, 1.0),
            (2.01, 0.5),
            (3.9, 0.5),
            (4.1, 0.25),
            (30.0, 0.0625),
            (1e4, 1.0 / 8192.0),
        ] {
            let long = &newton * times;
            let found = shares.descend(&y, &long, rest.dot(&long));
            let expected = &y + &long * part;
            assert!((&found - expected).amax() < 1e-12 * unit * times, "{k} {times} {part}");
        }
        // Against the slope nothing falls, and the step is taken whole.
        let back = &newton * -1.0;
        let found = shares.descend(&y, &back, rest.dot(&newton));
        assert!((found - (&y + back)).amax() < 1e-12 * unit, "{k}");
    }
}

/// Newton's step is the shortest one that meets what is left, in any units, where rows leave some
/// of the motion out too.
#[test]
fn steps_are_the_shortest_that_meet_what_is_left() {
    let mut random = Random(0x7137_4491_23EF_65CD);
    for k in 0..cases(200) {
        let unit = [1.0, 1e-9, 1e9][k % 3];
        let along = DVector::from_fn(3, |_, _| random.between(-1.0, 1.0)).normalize();
        let parts = DVector::from_fn(4, |_, _| random.between(0.2, 1.0) * unit);
        // All rows are along one motion.
        let jacobian = &parts * along.transpose();
        let rest = &along * random.between(-1.0, 1.0);
        let found = step(&jacobian, &jacobian, &rest).unwrap();
        let expected = &rest / parts.norm_squared();
        assert!((&found - &expected).amax() < 1e-12 * expected.amax(), "{k} {found} {expected}");
    }
}
