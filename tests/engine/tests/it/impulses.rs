//! The impulse problem in plain numbers: random collisions against their conditions, and closed
//! forms.

use liftoff::__private::impulse::{Collision, CollisionError, Outcome, Row};
use liftoff_core::model::Law;
use nalgebra::{DMatrix, DVector};

fn kinetic(collision: &Collision, u: &DVector<f64>) -> f64 {
    0.5 * u.dot(&(&collision.mass * u))
}

/// Five coordinates, one joint, three contacts; the first `rough` of them with a tangent.
fn collision(
    root: &[f64],
    jacobian: &[f64],
    rates: &[f64],
    (e, law): (&[f64], Law),
    rough: usize,
) -> Collision {
    let root = DMatrix::from_row_slice(5, 5, root);
    let jacobian = DMatrix::from_row_slice(7, 5, jacobian);
    let mut rows: Vec<Row> = e.iter().map(|&restitution| Row::Contact { restitution, law }).collect();
    rows.push(Row::TwoSided);
    rows.extend((0..3).map(|k| if k < rough { Row::Tangent { of: k } } else { Row::Open }));
    let mut u = DVector::from_row_slice(rates);
    let joint = jacobian.row(3).transpose();
    u -= &joint * (joint.dot(&u) / joint.dot(&joint));
    Collision {
        mass: &root * root.transpose() + DMatrix::identity(5, 5) * 0.1,
        jacobian,
        rates: u,
        prescribed_gap_rate: DVector::zeros(7),
        applied: DVector::zeros(5),
        rows,
    }
}

fn examine(collision: &Collision, outcome: &Outcome) {
    let residual = collision.residual(outcome);
    assert!(residual <= 1e-12, "residual {residual:e}");
    let (before, after) = (kinetic(collision, &collision.rates), kinetic(collision, &outcome.rates));
    assert!(after <= before * (1.0 + 1e-12), "{before} {after}");
}

/// Uniform numbers in (−1, 1): Steele, Lea and Flood's SplitMix64.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ z >> 31) as f64 / (1u64 << 63) as f64 - 1.0
    }

    fn some(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }

    fn collision(&mut self, law: Law, rough: usize) -> Collision {
        let e: Vec<f64> = self.some(3).iter().map(|x| x.abs()).collect();
        collision(&self.some(25), &self.some(35), &self.some(5), (&e, law), rough)
    }
}

#[test]
fn smooth_collisions_meet_their_conditions() {
    let mut numbers = Numbers(1);
    for law in [Law::Newton, Law::Poisson] {
        for _ in 0..1000 {
            let collision = numbers.collision(law, 0);
            let outcome = collision.solve().unwrap();
            examine(&collision, &outcome);
            let departs = collision.approach().iter().take(3).any(|speed| *speed > 0.0);
            assert!(!departs || outcome.law == Law::Poisson);
            // Without friction the work Σ P (ġ⁺ + ġ⁻)/2 is never positive, whatever the
            // coefficients.
            assert_eq!(outcome.factor, 1.0);
        }
    }
}

/// No slip may leave no admissible impulse at all, as a wedge does; where there is one, nothing is
/// gained.
#[test]
fn rough_collisions_gain_nothing() {
    let mut numbers = Numbers(2);
    let (mut jammed, mut reduced) = (0, 0);
    for k in 0..600 {
        let law = if k % 2 == 0 { Law::Newton } else { Law::Poisson };
        let collision = numbers.collision(law, 1 + k % 2);
        match collision.solve() {
            Ok(outcome) => {
                examine(&collision, &outcome);
                reduced += usize::from(outcome.factor < 1.0);
            }
            Err(error) => {
                assert_eq!(error, CollisionError::Jammed);
                jammed += 1;
            }
        }
    }
    assert!(jammed < 200 && reduced > 10, "{jammed} {reduced}");
}

/// Catalogue 6: a uniform bar at θ to the floor falls at v without spin; J = (1 + e) m v / (1 + 3
/// cos² θ).
#[test]
fn a_bar_end_strikes_the_floor() {
    for (theta, e) in [(0.3f64, 0.0), (0.3, 0.5), (1.2, 1.0)] {
        let collision = Collision {
            mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 1.0 / 12.0])),
            jacobian: DMatrix::from_row_slice(1, 3, &[0.0, 1.0, -0.5 * theta.cos()]),
            rates: DVector::from_row_slice(&[0.0, -2.0, 0.0]),
            prescribed_gap_rate: DVector::zeros(1),
            applied: DVector::zeros(3),
            rows: vec![Row::Contact { restitution: e, law: Law::Newton }],
        };
        let impulse = collision.solve().unwrap().impulses[0];
        let expected = (1.0 + e) * 2.0 / (1.0 + 3.0 * theta.cos().powi(2));
        assert!((impulse / expected - 1.0).abs() < 1e-14, "{impulse} {expected}");
    }
}

/// A massless coordinate between a wall and a mass, tied to it: its rate follows.
#[test]
fn massless_coordinates_follow() {
    let collision = Collision {
        mass: DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 0.0]),
        jacobian: DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, -1.0]),
        rates: DVector::from_row_slice(&[-1.0, -1.0]),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(2),
        rows: vec![Row::Contact { restitution: 0.5, law: Law::Newton }, Row::TwoSided],
    };
    let outcome = collision.solve().unwrap();
    assert!((outcome.rates - DVector::from_row_slice(&[0.5, 0.5])).amax() < 1e-14);
    assert!((outcome.impulses[0] - 3.0).abs() < 1e-14);
    let loose = Collision { rows: vec![Row::Open, Row::Open], ..collision.clone() };
    assert_eq!(loose.solve().unwrap_err(), CollisionError::Singular);
    let wedged = Collision { prescribed_gap_rate: DVector::from_row_slice(&[0.0, f64::NAN]), ..collision };
    assert!(wedged.solve().is_err());
}

/// W = [1, −1; −1, 1] pressed from both sides.
#[test]
fn opposed_walls_jam() {
    let contact = Row::Contact { restitution: 0.0, law: Law::Newton };
    let collision = Collision {
        mass: DMatrix::identity(1, 1),
        jacobian: DMatrix::from_row_slice(2, 1, &[1.0, -1.0]),
        rates: DVector::zeros(1),
        prescribed_gap_rate: DVector::from_row_slice(&[-1.0, -0.5]),
        applied: DVector::zeros(1),
        rows: vec![contact, contact],
    };
    assert_eq!(collision.solve().unwrap_err(), CollisionError::Jammed);
}

/// Both ends of a level bar: cos θ = −W₁₂/W₁₁ with W₁₁ = 1/m + l²/4I = 4/m, W₁₂ = −2/m.
#[test]
fn kinetic_angle_of_a_bars_ends() {
    let contact = Row::Contact { restitution: 0.0, law: Law::Newton };
    let bar = |inertia: f64| Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, inertia])),
        jacobian: DMatrix::from_row_slice(2, 2, &[1.0, 0.5, 1.0, -0.5]),
        rates: DVector::from_row_slice(&[-1.0, 0.0]),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(2),
        rows: vec![contact, contact],
    };
    assert!((bar(1.0 / 12.0).kinetic_angle(0, 1).unwrap() - core::f64::consts::FRAC_PI_3).abs() < 1e-14);
    assert_eq!(bar(0.25).kinetic_angle(0, 1), None);
}

/// What is open may have no number; what acts may not.
#[test]
fn only_rows_that_act_must_be_finite() {
    let mut random = Numbers(7);
    let mut collision = random.collision(Law::Newton, 0);
    collision.jacobian[(5, 0)] = f64::NAN;
    let outcome = collision.solve();
    assert!(outcome.is_ok(), "{:?}", outcome.err());
    collision.jacobian[(1, 0)] = f64::NAN;
    assert_eq!(collision.solve().err(), Some(CollisionError::Singular));
}
