//! Impulses of hinges by the balance of their bars.

use core::cell::Cell;

use nalgebra::{DMatrix, DVector};

use super::{Hinge, HingeCollision, answer};
use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::impulse::{Collision, CollisionError, Row};
use crate::model::Law;
use crate::prelude::*;
use crate::system::Model;

/// A bar on a pin, whose end strikes a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[support(B = wall(0), facing = right)]
#[coordinate(phi = angle(AB), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5))]
struct Gate {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    g: f64,
}

/// Two of them on each other.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = mu, radius = r)]
#[hinge(B, friction = mu, radius = r)]
#[support(C = wall(0), facing = right)]
#[coordinate(phi = angle(AB), from = down)]
#[coordinate(psi = angle(BC), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5), C = (2 * l / 5, -2 * l * sqrt(24) / 5))]
struct Double {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    g: f64,
}

/// The collision of a model at a state, with what its support is.
fn collision(model: &Model, state: &[f64], mu: f64, support: Row) -> Collision {
    let (layout, equations) = (model.layout(), model.system.equations(state));
    let (n, r) = (layout.coordinates.len(), layout.rows());
    let friction = |row: usize| layout.frictions.iter().find(|friction| friction.row == row);
    let part = |row: usize| match friction(row) {
        Some(friction) => Row::Friction { of: friction.contact, mu, restitution: 0.0 },
        None if layout.contacts[row].is_hinge() => Row::Open,
        None => support,
    };
    Collision {
        mass: DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j]),
        jacobian: DMatrix::from_fn(r, n, |i, j| equations.jacobian(i)[j]),
        rates: DVector::from_row_slice(&state[n..]),
        prescribed_gap_rate: DVector::zeros(r),
        applied: DVector::zeros(n),
        rows: (0..r).map(part).collect(),
    }
}

/// `J Δω = l cos φ P_B ± r Q` with ω⁺ = −e ω⁻, the pin's impulse
/// `P = m (l/2) Δω (cos φ, sin φ) − P_B (1, 0)`, and Q = −μ |P| against ω⁺; one that comes to rest
/// is held by less.
#[test]
fn a_journal_rubs_by_the_impulse_of_its_pin() {
    for (m, l, r) in [(1.5, 0.7, 0.06), (2e5, 3e-4, 2e-5)] {
        for mu in [0.2, 0.5, 1.7] {
            for (phi, rate) in [(0.0, -1.3), (0.4, -0.8), (-0.3, -2.1)] {
                for (e, law) in
                    [(0.6, Law::Newton), (0.6, Law::Poisson), (1.0, Law::Newton), (0.0, Law::Newton)]
                {
                    let model = Model::new(&Gate { m, l, mu, r, g: 9.81 });
                    let state = [phi, rate];
                    let contact = Row::Contact { restitution: e, law };
                    let it = collision(&model, &state, mu, contact);
                    let found = answer(&*model.system, &state, &it, 1000).unwrap();
                    let (_, friction, _) = model.layout().hinges().next().unwrap();
                    let support = (0..2).find(|row| *row != friction.contact).unwrap();
                    let [wall, pin, rubs] =
                        [support, friction.contact, friction.row].map(|row| found.impulses[row]);
                    let after = found.rates[0];
                    let change = after - rate;
                    let size = m * l * (1.0 + e) * f64::abs(rate);
                    let note = format!("{m} {mu} {phi} {e} {law:?}: {}", found.impulses);
                    // Poisson's law with friction in the journal gives back e P_B.
                    assert!(law != Law::Newton || (after + e * rate).abs() < 1e-12 * rate.abs(), "{note}");
                    let journal = it.jacobian[(friction.row, 0)];
                    assert!((journal.abs() - r).abs() < 1e-15 * r.max(1.0), "{note}");
                    let balance = m * l * l / 3.0 * change - l * phi.cos() * wall - journal * rubs;
                    assert!(balance.abs() < 1e-11 * size * l, "{note}");
                    let across = 0.5 * m * l * change;
                    let expected = (across * phi.cos() - wall).hypot(across * phi.sin());
                    assert!((pin - expected).abs() < 1e-11 * size, "{note} {expected}");
                    if e > 0.0 {
                        let against = -mu * pin * (journal * after).signum();
                        assert!((rubs - against).abs() < 1e-11 * size, "{note}");
                    } else {
                        assert!(rubs.abs() <= mu * pin + 1e-11 * size, "{note}");
                    }
                }
            }
        }
    }
}

/// Improved senses and those of all modes have one outcome, which balances and rubs by its law.
#[test]
fn all_modes_have_the_improved_outcome() {
    let mut random = Random(0x452B_21E6_38D0_1377);
    let (mut compared, mut sliding, mut sticking) = (0, 0, 0);
    for k in 0..cases(120) {
        let (mu, r, l) = (random.between(0.1, 1.5), random.between(0.01, 0.1) * [1.0, 4.0][k % 2], 0.8);
        let model = Model::new(&Double { m: 1.2, l, mu, r, g: 9.81 });
        let [phi, psi] = [0.0; 2].map(|_| random.between(-0.5, 0.5));
        let [rate, other] = [0.0; 2].map(|_| random.between(-2.0, 2.0) * [0.0, 1.0, 1.0][random.below(3)]);
        let state = [phi, psi, rate, other];
        let contact =
            Row::Contact { restitution: random.between(0.0, 1.0) * [0.0, 1.0][k % 2], law: Law::Newton };
        let it = collision(&model, &state, mu, contact);
        let layout = model.layout();
        let support = (0..3).find(|row| matches!(it.rows[*row], Row::Contact { .. })).unwrap();
        if it.approach()[support] >= 0.0 {
            continue;
        }
        let hinges = || layout.hinges().map(|(_, friction, force)| Hinge { friction, force, mu }).collect();
        let struck = |most: usize| HingeCollision {
            system: &*model.system,
            state: &state,
            collision: &it,
            hinges: hinges(),
            left: Cell::new(most),
        };
        let (Some(one), Ok(all)) = (struck(10_000).improved(), struck(10_000).searched()) else { continue };
        compared += 1;
        let size = 1.0 + one.impulses.amax();
        assert!((&one.rates - &all.rates).amax() < 1e-9 * size, "{k} {} {}", one.rates, all.rates);
        assert!((&one.impulses - &all.impulses).amax() < 1e-9 * size, "{k}");
        let change = &it.mass * (&one.rates - &it.rates);
        let mut acting = one.impulses.clone();
        let speed = it.speed(&one.rates);
        for (_, friction, _) in layout.hinges() {
            // The force of a hinge moves nothing along its bars.
            acting[friction.contact] = 0.0;
            let (normal, rubs) = (one.impulses[friction.contact], one.impulses[friction.row]);
            if speed[friction.row].abs() > 1e-9 {
                sliding += 1;
                let against = -mu * normal * speed[friction.row].signum();
                assert!((rubs - against).abs() < 1e-9 * size, "{k}");
            } else {
                sticking += 1;
                assert!(rubs.abs() <= mu * normal + 1e-9 * size, "{k}");
            }
        }
        assert!((change - it.jacobian.tr_mul(&acting)).amax() < 1e-9 * size, "{k}");
        // No more collisions are solved than are allowed.
        assert_eq!(struck(0).with(&[0.0; 2]).unwrap_err(), CollisionError::Exhausted);
    }
    assert!(compared > 30 && sliding > 20, "{compared} {sliding} {sticking}");
}
