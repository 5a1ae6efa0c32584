//! Catalogue 20 and other impacts that are known.

use nalgebra::{DMatrix, DVector};

use crate::contact::impact::Stages;
use crate::contact::impulse::{Collision, CollisionError, ImpulseMethod, Outcome, Row};
use crate::contact::trials::Trials;
use crate::model::Law;

fn kinetic(collision: &Collision, u: &DVector<f64>) -> f64 {
    0.5 * u.dot(&(&collision.mass * u))
}

/// A uniform rod of unit length and mass, its lower end on the floor at θ, with the end's
/// velocities (v, ġ).
fn rod(degrees: f64, (slip, normal): (f64, f64), mu: f64, (e, law): (f64, Law)) -> Collision {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 1.0 / 12.0])),
        jacobian: DMatrix::from_row_slice(2, 3, &[0.0, 1.0, -0.5 * cosine, 1.0, 0.0, 0.5 * sine]),
        rates: DVector::from_row_slice(&[slip, normal, 0.0]),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(3),
        rows: vec![Row::Contact { restitution: e, law }, Row::Friction { of: 0, mu, restitution: 0.0 }],
    }
}

/// With little inertia the rates after an impact are known to few digits; that the tip stays closed
/// and sticks is known from its law.
#[test]
fn rest_after_impact_is_exact_with_ill_conditioned_mass() {
    for inertia in [1e-3, 1e-7, 1e-11] {
        for law in [Law::Newton, Law::Poisson, Law::Stronge] {
            let mut rod = rod(52.7, (0.3, -1.0), 0.999, (0.0, law));
            rod.mass[(2, 2)] = inertia;
            rod.rates[2] = 0.7;
            let outcome = rod.solve().unwrap();
            assert!(outcome.impulses[0] > 0.0, "{inertia} {law:?}");
            assert_eq!(outcome.opening.as_slice(), [0.0, 0.0], "{inertia} {law:?}");
        }
    }
}

/// Catalogue 20: (θ, v, μ, e), and (v⁺, ġ⁺, gained) by Newton, Poisson, Stronge; to all printed
/// digits.
#[test]
fn a_rod_strikes_a_rough_floor() {
    let laws = [Law::Newton, Law::Poisson, Law::Stronge];
    for ((degrees, slip, mu, e), expected) in [
        (
            (60.0, 0.5, 0.3, 0.6),
            [
                (-0.2690696197, 0.6, -0.188900327),
                (-0.2445755080, 0.4971754878, -0.224544213),
                (-0.2489165043, 0.5153986768, -0.218753372),
            ],
        ),
        (
            (70.0, -0.4, 0.5, 0.9),
            [
                (0.0, 0.9, -0.2101021414),
                (0.0, 0.9951216684, -0.1278762924),
                (0.0, 0.9729528532, -0.1477773351),
            ],
        ),
        (
            (75.0, 1.0, 0.8, 0.9),
            [
                (0.0, 0.9, -0.0528473918),
                (0.0, 0.7223234458, -0.1897309325),
                (0.0, 0.7524522557, -0.1686304875),
            ],
        ),
        (
            (55.0, 0.75, 0.5, 1.0),
            [
                (0.0, 1.0, 0.1245797366),
                (0.0, 0.6491391978, -0.0933445667),
                (0.0, 0.7356505710, -0.0482244150),
            ],
        ),
    ] {
        for (law, (v, normal, gained)) in laws.into_iter().zip(expected) {
            let collision = rod(degrees, (slip, -1.0), mu, (e, law));
            let outcome = collision.solve().unwrap();
            let told = (outcome.opening[1], outcome.opening[0], outcome.gained);
            assert!((told.0 - v).abs() < 6e-11 && (told.1 - normal).abs() < 6e-11, "{law:?} {told:?}");
            // The first energy is printed with nine digits.
            assert!((told.2 - gained).abs() < 6e-10, "{law:?} {told:?}");
            let change = kinetic(&collision, &outcome.rates) - kinetic(&collision, &collision.rates);
            assert!((told.2 - change).abs() < 1e-14);
            assert_eq!((outcome.law, outcome.method, outcome.factor), (law, ImpulseMethod::Path, 1.0));
            assert!(v != 0.0 || told.0 == 0.0);
        }
    }
}

/// Moreau's law of the same rod, by hand: of sticking, W (P, P_t) = ((1 + e) , −v), and of a slide
/// that goes on or has turned the one whose friction opposes the slip velocity after it. Routh's
/// path turns back at 60°, and Moreau's law stays at rest there.
#[test]
fn moreau_relates_the_whole_impulse_to_the_slip_after_it() {
    for (degrees, slip, mu, e) in [
        (60.0, 0.5, 0.3, 0.6),
        (70.0, -0.4, 0.5, 0.9),
        (75.0, 1.0, 0.8, 0.9),
        (20.0, 2.0, 0.1, 0.3),
        (55.0, 0.3, 0.1, 0.5),
    ] {
        let collision = rod(degrees, (slip, -1.0), mu, (e, Law::Moreau));
        let (sine, cosine) = f64::to_radians(degrees).sin_cos();
        let [nn, nt, tt] = [1.0 + 3.0 * cosine * cosine, -3.0 * cosine * sine, 1.0 + 3.0 * sine * sine];
        let returned = 1.0 + e;
        let determinant = nn * tt - nt * nt;
        let stick = ((tt * returned + nt * slip) / determinant, (-nt * returned - nn * slip) / determinant);
        let slides = [1.0, -1.0].map(|sense| {
            let normal = returned / (nn - sense * mu * nt);
            let friction = -sense * mu * normal;
            (sense, [normal, friction, slip + nt * normal + tt * friction])
        });
        let sliding = slides.into_iter().find(|(sense, [_, _, v])| sense * v > 0.0);
        let [normal, friction, v] = sliding.map_or([stick.0, stick.1, 0.0], |(_, found)| found);
        assert!(friction.abs() <= mu * normal + 1e-15);
        let outcome = collision.solve().unwrap();
        assert_eq!((outcome.law, outcome.method), (Law::Moreau, ImpulseMethod::AtOnce));
        for (found, expected) in [
            (outcome.impulses[0], normal),
            (outcome.impulses[1], friction),
            (outcome.opening[0], e),
            (outcome.opening[1], v),
        ] {
            assert!((found - expected).abs() < 1e-14, "{degrees}: {found} {expected}");
        }
    }
}

/// Without friction the three laws are one, and so are the ways to them.
#[test]
fn a_smooth_contact_has_one_law() {
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        let mut collision = rod(50.0, (0.4, -1.0), 0.0, (0.7, law));
        let along = collision.solve().unwrap();
        collision.rows[1] = Row::Open;
        let smooth = collision.solve().unwrap();
        assert_eq!((along.law, smooth.law, smooth.method), (law, law, ImpulseMethod::AtOnce));
        assert!((along.rates - &smooth.rates).amax() < 1e-15);
        assert!((along.gained - smooth.gained).abs() < 1e-15);
        assert!((smooth.opening[0] - 0.7).abs() < 1e-15);
    }
}

/// Newton's cradle: one ball against n − 1 at rest that touch, by Poisson's law.
#[test]
fn newton_s_cradle() {
    for balls in 1..=7usize {
        let contacts = balls - 1;
        let jacobian = DMatrix::from_fn(contacts, balls, |k, j| match j {
            _ if j == k => -1.0,
            _ if j == k + 1 => 1.0,
            _ => 0.0,
        });
        for law in [Law::Newton, Law::Poisson] {
            let collision = Collision {
                mass: DMatrix::identity(balls, balls),
                jacobian: jacobian.clone(),
                rates: DVector::from_fn(balls, |k, _| if k == 0 { 1.0 } else { 0.0 }),
                prescribed_gap_rate: DVector::zeros(contacts),
                applied: DVector::zeros(balls),
                rows: vec![Row::Contact { restitution: 1.0, law }; contacts],
            };
            let outcome = collision.solve().unwrap();
            assert!((outcome.rates.sum() - 1.0).abs() < 1e-14);
            let change = kinetic(&collision, &outcome.rates) - 0.5;
            assert!((outcome.gained - change).abs() < 1e-14 && change < 1e-14);
            if balls == 2 {
                assert!((outcome.rates - DVector::from_row_slice(&[0.0, 1.0])).amax() < 1e-15);
            }
        }
    }
}

/// A disc with spin: W_Nt = 0, W_tt = 3/m. It gives back e_t of its slip where friction suffices.
#[test]
fn tangential_restitution_reverses_the_slip() {
    let disc = |mu: f64, e_t: f64, law: Law| Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 0.5])),
        jacobian: DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 1.0, 0.0, 1.0]),
        rates: DVector::from_row_slice(&[0.3, -1.0, 0.3]),
        prescribed_gap_rate: DVector::zeros(2),
        applied: DVector::zeros(3),
        rows: vec![Row::Contact { restitution: 0.8, law }, Row::Friction { of: 0, mu, restitution: e_t }],
    };
    let newton = disc(1.0, 0.5, Law::Newton).solve().unwrap();
    assert!((newton.opening[1] + 0.3).abs() < 1e-15 && (newton.opening[0] - 0.8).abs() < 1e-15);
    // Pᵗᶜ = −0.6/3 and e e_t of it again: v⁺ = −e e_t v⁻.
    let poisson = disc(1.0, 0.5, Law::Poisson).solve().unwrap();
    assert!((poisson.opening[1] + 0.4 * 0.6).abs() < 1e-15 && (poisson.opening[0] - 0.8).abs() < 1e-15);
    for law in [Law::Newton, Law::Poisson] {
        let slips = disc(0.05, 0.5, law).solve().unwrap();
        assert!((slips.impulses[1] + 0.05 * 1.8).abs() < 1e-15, "{}", slips.impulses[1]);
    }
    assert_eq!(disc(1.0, 0.5, Law::Stronge).solve().unwrap_err(), CollisionError::Several);
}

/// A plank falls flat on two feet: by symmetry each bears half, and both slip as a block would.
#[test]
fn a_plank_falls_flat() {
    let plank = |law: Law, mu: f64| Collision {
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 1.0 / 3.0])),
        jacobian: DMatrix::from_row_slice(
            4,
            3,
            &[0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        ),
        rates: DVector::from_row_slice(&[0.5, -1.0, 0.0]),
        prescribed_gap_rate: DVector::zeros(4),
        applied: DVector::zeros(3),
        rows: vec![
            Row::Contact { restitution: 0.5, law },
            Row::Contact { restitution: 0.5, law },
            Row::Friction { of: 0, mu, restitution: 0.0 },
            Row::Friction { of: 1, mu, restitution: 0.0 },
        ],
    };
    for law in [Law::Newton, Law::Poisson] {
        let outcome = plank(law, 0.2).solve().unwrap();
        assert!((outcome.rates - DVector::from_row_slice(&[0.2, 0.5, 0.0])).amax() < 1e-14);
        assert!((outcome.impulses[0] - 0.75).abs() < 1e-14 && outcome.method == ImpulseMethod::AtOnce);
        assert!((outcome.gained - (0.5 * (0.04 + 0.25) - 0.625)).abs() < 1e-14);
        let sticks = plank(law, 0.6).solve().unwrap();
        assert!((sticks.rates - DVector::from_row_slice(&[0.0, 0.5, 0.0])).amax() < 1e-14);
        assert!(!sticks.unique && sticks.opening[2] == 0.0 && sticks.opening[3] == 0.0);
    }
    assert_eq!(plank(Law::Stronge, 0.2).solve().unwrap_err(), CollisionError::Several);
}

/// Impact without collision at θ = 60°, μ = 2, slip backward: the path runs down while it slips,
/// and up once it sticks.
#[test]
fn a_slip_in_the_paradox_ends_in_an_impact() {
    let (w_nn, w_nt, w_tt) = (1.75, -3.0 * 0.75f64.sqrt() * 0.5, 3.25);
    let impact = |e: f64, law: Law| -> Outcome {
        rod(60.0, (-1.0, 0.0), 2.0, (e, law)).tangential_impact(usize::MAX).unwrap()
    };
    // Slip r = μ ends after P₁, ġ₁ < 0; then r = −W_Nt / W_tt raises ġ to zero.
    let first = 1.0 / (w_nt + 2.0 * w_tt);
    let down = (w_nn + 2.0 * w_nt) * first;
    let rise = w_nn - w_nt * w_nt / w_tt;
    assert!(down < 0.0);
    let compressed = first - down / rise;
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        let outcome = impact(0.0, law);
        assert!((outcome.impulses[0] - compressed).abs() < 1e-14 && outcome.gained < 0.0);
        assert_eq!((outcome.opening[0], outcome.opening[1]), (0.0, 0.0));
    }
    let poisson = impact(0.5, Law::Poisson);
    assert!((poisson.opening[0] - 0.5 * compressed * rise).abs() < 1e-14);
    // ∫ ġ dP = ġ₁ P₁ / 2 − ġ₁² / 2 rise in compression, ġ⁺² / 2 rise in restitution.
    let stronge = impact(0.5, Law::Stronge);
    let taken = 0.5 * down * first - 0.5 * down * down / rise;
    assert!((stronge.opening[0] - (-0.25 * taken * 2.0 * rise).sqrt()).abs() < 1e-14);
    assert!(stronge.opening[0] < poisson.opening[0]);
    let outside = rod(60.0, (1.0, 0.0), 2.0, (0.5, Law::Poisson));
    assert_eq!(outside.tangential_impact(usize::MAX).unwrap_err(), CollisionError::Jammed);
}

/// Of two rods that slide into the paradox the one deeper in it strikes first: by W_NN − σ μ W_Nt
/// relative to W_NN, whatever the masses.
#[test]
fn the_slip_deepest_in_the_paradox_ends_first() {
    let rods = |mu: [f64; 2], masses: [f64; 2]| {
        let [one, other] = mu.map(|mu| rod(60.0, (-1.0, 0.0), mu, (0.0, Law::Poisson)));
        let (mut mass, mut jacobian) = (DMatrix::zeros(6, 6), DMatrix::zeros(4, 6));
        mass.view_mut((0, 0), (3, 3)).copy_from(&(&one.mass * masses[0]));
        mass.view_mut((3, 3), (3, 3)).copy_from(&(&other.mass * masses[1]));
        for (row, k) in [(0, 0), (1, 2)] {
            jacobian.view_mut((k, 0), (1, 3)).copy_from(&one.jacobian.row(row));
            jacobian.view_mut((k + 1, 3), (1, 3)).copy_from(&other.jacobian.row(row));
        }
        let contact = Row::Contact { restitution: 0.0, law: Law::Poisson };
        let friction = |of: usize| Row::Friction { of, mu: mu[of], restitution: 0.0 };
        let rates = DVector::from_iterator(6, one.rates.iter().chain(other.rates.iter()).copied());
        let (drift, applied) = (DVector::zeros(4), DVector::zeros(6));
        let rows = vec![contact, contact, friction(0), friction(1)];
        Collision { mass, jacobian, rates, prescribed_gap_rate: drift, applied, rows }
    };
    for masses in [[1.0, 1.0], [1.0, 50.0], [50.0, 1.0]] {
        for (mu, deeper) in [([2.0, 3.0], 1), ([3.0, 2.0], 0)] {
            let outcome = rods(mu, masses).tangential_impact(usize::MAX).unwrap();
            assert_eq!(outcome.acting, [deeper], "{mu:?} {masses:?}");
        }
    }
}

/// An impulse from outside on a rod at rest on the floor, by each law: it sticks, and its end
/// leaves with none.
#[test]
fn an_applied_impulse_is_answered() {
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        let mut collision = rod(60.0, (0.0, 0.0), 2.0, (0.0, law));
        collision.applied = DVector::from_row_slice(&[0.1, -1.0, 0.0]);
        let outcome = collision.solve().unwrap();
        assert!(outcome.impulses[0] > 0.0 && outcome.acting == [0]);
        assert_eq!((outcome.opening[0], outcome.opening[1]), (0.0, 0.0), "{law:?}");
    }
}

/// A rod that stands on a block on the floor, both pushed down from above: the joint passes the
/// impulse on to the floor.
#[test]
fn an_applied_impulse_passes_through_joints() {
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        let collision = Collision {
            mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 3.0])),
            jacobian: DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -1.0]),
            rates: DVector::zeros(3),
            prescribed_gap_rate: DVector::zeros(3),
            applied: DVector::from_row_slice(&[0.0, 0.0, -2.0]),
            rows: vec![
                Row::Contact { restitution: 0.0, law },
                Row::Friction { of: 0, mu: 0.5, restitution: 0.0 },
                Row::TwoSided,
            ],
        };
        let outcome = collision.solve().unwrap();
        assert!(outcome.rates.amax() < 1e-14, "{law:?}");
        let expected = DVector::from_row_slice(&[2.0, 0.0, -2.0]);
        assert!((&outcome.impulses - expected).amax() < 1e-14, "{law:?} {}", outcome.impulses);
    }
}

/// What rests on another contact strikes nothing, whatever the sign of its rounding: q̇ = ±1e-33 of
/// a block that the rod presses on.
#[test]
fn rounding_does_not_strike() {
    let struck = |noise: f64| {
        let alone = rod(60.0, (0.5, -1.0), 0.8, (0.9, Law::Newton));
        let mut mass = alone.mass.resize(4, 4, 0.0);
        (mass[(3, 3)], mass[(1, 3)], mass[(3, 1)]) = (1.0, -0.4, -0.4);
        let mut jacobian = alone.jacobian.resize(4, 4, 0.0);
        (jacobian[(2, 3)], jacobian[(3, 0)]) = (1.0, 1.0);
        let (e, law) = (0.9, Law::Newton);
        let block =
            [Row::Contact { restitution: e, law }, Row::Friction { of: 2, mu: 0.8, restitution: 0.0 }];
        let rows = [&alone.rows[..], &block].concat();
        let (rates, rest) = (alone.rates.resize_vertically(4, noise), DVector::zeros(4));
        let collision =
            Collision { mass, jacobian, rates, rows, prescribed_gap_rate: rest.clone(), applied: rest };
        collision.solve().unwrap()
    };
    let [up, still, down] = [1e-33, 0.0, -1e-33].map(struck);
    for other in [up, down] {
        assert_eq!(other.method, still.method);
        assert!((&other.rates - &still.rates).amax() < 1e-14, "{} {}", other.rates, still.rates);
    }
}

/// The work of contacts, ½ Σ P (ġ⁺ + ġ⁻), and the sum of the sizes of its terms.
#[test]
fn the_work_of_contacts_has_the_size_of_its_terms() {
    for (slip, mu) in [(0.5, 0.3), (-3.0, 0.2)] {
        let collision = rod(60.0, (slip, -1.0), mu, (0.6, Law::Poisson));
        let outcome = collision.solve().unwrap();
        let stages = Stages::new(&collision, Trials::up_to(100));
        let (work, size) = stages.work(&outcome);
        let [[p, g], [q, v]] = [0, 1].map(|row| [outcome.impulses[row], outcome.opening[row]]);
        assert!((work - 0.5 * (p * (g - 1.0) + q * (v + slip))).abs() < 1e-15);
        let expected = 0.5 * (p.abs() * (g.abs() + 1.0) + q.abs() * (v.abs() + slip.abs()));
        assert!((size / expected - 1.0).abs() < 1e-14, "{size} {expected}");
    }
}
