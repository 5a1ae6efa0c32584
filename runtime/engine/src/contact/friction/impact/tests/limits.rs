//! Limits between outcomes: of what is pressed, of what gains, of what is unique.

use nalgebra::{DMatrix, DVector};

use super::random::collision;
use crate::contact::friction::tests::random::Random;
use crate::contact::impulse::{Collision, CollisionError, ImpulseMethod, Row};
use crate::model::Law;

/// A contact slips one way all along its path, and another one touches that moves with it: pressed
/// where its velocity at the end falls below zero by more than the rounding of its terms.
#[test]
fn another_contact_is_pressed_beyond_rounding() {
    let mut random = Random(0x1F83_D9AB_FB41_BD6B);
    let mut examined = [0; 2];
    for k in 0..4_000 {
        let mut it = collision(&mut random, 2, (0.5, Law::Poisson));
        it.rows[2] = Row::Friction { of: 0, mu: 0.2, restitution: 0.0 };
        let mut alone = it.clone();
        (alone.rows[1], alone.rows[3]) = (Row::Open, Row::Open);
        let outcome = alone.solve().unwrap();
        if outcome.impulses[2].abs() < 0.2 * outcome.impulses[0] * (1.0 - 1e-9) {
            continue;
        }
        // Velocities of the other contact by the impulses of the one.
        let inverse = it.mass.clone().try_inverse().unwrap();
        let by = |row: usize| {
            (it.jacobian.row(1) * &inverse * it.jacobian.row(row).transpose())[0] * outcome.impulses[row]
        };
        let parts = [by(0), by(2)];
        let change = parts[0] + parts[1];
        if change > -1e-2 {
            continue;
        }
        let size = change.abs() + parts[0].abs() + parts[1].abs();
        for (part, pressed) in [(1e-11, true), (1e-13, false), (-1e-13, false), (-1e-11, false)] {
            it.prescribed_gap_rate[1] = -(&it.jacobian * &it.rates)[1] - change - part * size;
            let method = it.solve().unwrap().method;
            assert_eq!(method == ImpulseMethod::AtOnce, pressed, "{k} {part} {parts:?}");
        }
        examined[usize::from(parts[0] * parts[1] < 0.0)] += 1;
    }
    assert!(examined.iter().all(|count| *count > 50), "{examined:?}");
}

/// Without slip a contact that strikes gains by Newton's law where e is large: e P (ġ⁺ + ġ⁻) + P_t
/// v⁻ = 0 at the largest factor.
#[test]
fn restitution_is_reduced_to_what_gains_nothing() {
    let mut random = Random(0x5BE0_CD19_137E_2179);
    let (mut reduced, mut whole) = (0, 0);
    for k in 0..4_000 {
        let e = random.between(0.5, 1.0);
        let mut it = collision(&mut random, 1, (e, Law::Newton));
        it.rows[1] = Row::Tangent { of: 0 };
        let inverse = it.mass.clone().try_inverse().unwrap();
        let delassus = &it.jacobian * inverse * it.jacobian.transpose();
        let approach = it.approach();
        let compliance = delassus.try_inverse().unwrap();
        let impulses =
            |e: f64| &compliance * DVector::from_row_slice(&[-(1.0 + e) * approach[0], -approach[1]]);
        let gained = |e: f64| {
            let p = impulses(e);
            0.5 * (p[0] * (1.0 - e) * approach[0] + p[1] * approach[1])
        };
        // Quadratic in e: from its values at 0, ½ and 1.
        let [none, half, one] = [0.0, 0.5, 1.0].map(gained);
        let (b, c) = (4.0 * half - 3.0 * none - one, 2.0 * none + 2.0 * one - 4.0 * half);
        if impulses(0.0)[0] <= 0.0 || impulses(e)[0] <= 0.0 {
            continue;
        }
        let outcome = it.solve().unwrap();
        if gained(e) <= 0.0 {
            whole += 1;
            assert_eq!(outcome.factor, 1.0, "{k}");
            continue;
        }
        reduced += 1;
        let root = (-b + (b * b - 4.0 * c * none).sqrt()) / (2.0 * c);
        assert!(
            (outcome.factor * e - root).abs() <= 1e-9 * (1.0 + 1.0 / c.abs()),
            "{k} {} {root}",
            outcome.factor * e
        );
        assert!(outcome.gained <= 0.0 && outcome.gained >= -1e-9, "{k}");
        assert!((&outcome.impulses - impulses(root)).amax() <= 1e-6, "{k}");
    }
    assert!(reduced > 50 && whole > 50, "{reduced} {whole}");
}

/// A plank that falls flat on three smooth feet shares its load in many ways, and leaves them; a
/// particle beside it slides.
#[test]
fn impulses_are_not_unique_where_those_of_a_stage_are_not() {
    let jacobian = DMatrix::from_row_slice(
        5,
        4,
        &[
            1.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0,
            0.0,
        ],
    );
    for feet in [2, 3] {
        let foot = Row::Contact { restitution: 0.5, law: Law::Poisson };
        let rows = vec![
            foot,
            if feet == 3 { foot } else { Row::Open },
            foot,
            foot,
            Row::Friction { of: 3, mu: 0.2, restitution: 0.0 },
        ];
        let it = Collision {
            mass: DMatrix::identity(4, 4),
            jacobian: jacobian.clone(),
            rates: DVector::from_row_slice(&[-1.0, 0.0, 1.0, -1.0]),
            prescribed_gap_rate: DVector::zeros(5),
            applied: DVector::zeros(4),
            rows,
        };
        let outcome = it.solve().unwrap();
        assert!((outcome.rates - DVector::from_row_slice(&[0.5, 0.0, 0.7, 0.5])).amax() < 1e-14);
        assert_eq!((outcome.method, outcome.unique), (ImpulseMethod::AtOnce, feet == 2));
    }
}

/// Where nothing moves no impulse changes the motion.
#[test]
fn bodies_at_rest_have_no_impact() {
    let mut random = Random(0xA54F_F53A_5F1D_36F1);
    for law in [Law::Newton, Law::Poisson] {
        for contacts in [1, 2] {
            let mut it = collision(&mut random, contacts, (0.5, law));
            it.rates.fill(0.0);
            assert_eq!(it.tangential_impact(usize::MAX).unwrap_err(), CollisionError::Jammed);
        }
    }
}

/// What is applied acts first, on the joint alone, and the contact strikes after it: all impulses
/// together balance what is applied.
#[test]
fn applied_impulses_act_before_contacts() {
    let mut random = Random(0x3C6E_F372_FE94_F82B);
    let mut struck = 0;
    for k in 0..400 {
        let mut it = collision(&mut random, 1, ((k % 11) as f64 / 10.0, Law::Stronge));
        let n = it.rates.len();
        let joint = DVector::from_fn(n, |_, _| random.between(-1.0, 1.0));
        let drift = -joint.dot(&it.rates);
        it.jacobian = it.jacobian.insert_row(2, 0.0);
        it.jacobian.set_row(2, &joint.transpose());
        it.prescribed_gap_rate = it.prescribed_gap_rate.insert_row(2, drift);
        it.rows.push(Row::TwoSided);
        it.applied = DVector::from_fn(n, |_, _| random.between(-1.0, 1.0));
        let outcome = it.solve().unwrap_or_else(|error| panic!("{k}: {error}"));
        let change = &it.mass * (&outcome.rates - &it.rates);
        let rest = change - &it.applied - it.jacobian.tr_mul(&outcome.impulses);
        let size = 1.0 + outcome.impulses.amax();
        assert!(rest.amax() <= 1e-11 * size, "{k}: {:e}", rest.amax());
        assert!(outcome.opening[0] >= 0.0 && outcome.opening[2].abs() <= 1e-11 * size, "{k}");
        struck += usize::from(outcome.impulses[0] > 1e-3 && outcome.impulses[2].abs() > 1e-3);
    }
    assert!(struck > 100, "{struck}");
}
