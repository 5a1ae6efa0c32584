//! Random impacts: conditions of each stage, and the energy.

use nalgebra::{DMatrix, DVector};

use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::friction::{FrictionError, FrictionProblem, Frictional, SlipVelocity};
use crate::contact::impulse::{Collision, CollisionError, ImpulseMethod, Outcome, Row};
use crate::model::Law;

/// Contacts of one body or two that all approach, each with friction.
pub(super) fn collision(random: &mut Random, contacts: usize, (e, law): (f64, Law)) -> Collision {
    let n = 3 * (1 + random.below(2));
    let mut jacobian = DMatrix::zeros(2 * contacts, n);
    for k in 0..contacts {
        let body = random.below(n as u64 / 3);
        let (sine, cosine) = random.between(0.0, 6.3).sin_cos();
        let arm = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        for (row, [x, y]) in [(k, [cosine, sine]), (contacts + k, [-sine, cosine])] {
            jacobian[(row, 3 * body)] = x;
            jacobian[(row, 3 * body + 1)] = y;
            jacobian[(row, 3 * body + 2)] = arm[0] * y - arm[1] * x;
        }
    }
    let mut rates = DVector::from_fn(n, |_, _| random.between(-1.0, 1.0));
    while (&jacobian * &rates).rows(0, contacts).max() >= 0.0 {
        rates = DVector::from_fn(n, |_, _| random.between(-1.0, 1.0));
        if random.below(1000) == 0 {
            return collision(random, contacts, (e, law));
        }
    }
    let mut rows = vec![Row::Contact { restitution: e, law }; contacts];
    rows.extend((0..contacts).map(|of| Row::Friction { of, mu: random.between(0.0, 1.5), restitution: 0.0 }));
    let mass = DVector::from_fn(n, |k, _| if k % 3 == 2 { random.between(0.05, 1.0) } else { 1.0 });
    Collision {
        mass: DMatrix::from_diagonal(&mass),
        prescribed_gap_rate: DVector::zeros(2 * contacts),
        applied: DVector::zeros(n),
        jacobian,
        rates,
        rows,
    }
}

/// The largest violation of one stage: M Δu = Jᵀ P, Coulomb's law of its own impulses, and ġ ⟂ P.
fn stage(
    it: &Collision,
    (before, after): (&DVector<f64>, &DVector<f64>),
    impulses: &DVector<f64>,
    target: impl Fn(usize) -> (f64, f64),
) -> f64 {
    let balance = &it.mass * (after - before) - it.jacobian.tr_mul(impulses);
    let speed = &it.jacobian * after;
    let contacts = it.rows.len() / 2;
    let mut worst = balance.amax();
    for k in 0..contacts {
        let Row::Friction { mu, .. } = it.rows[contacts + k] else { unreachable!() };
        let (least, offset) = target(k);
        let (normal, opening) = (impulses[k] - least, speed[k] + offset);
        worst = worst.max(-normal).max(-opening).max(normal.abs().min(opening.abs()));
        let (friction, most, slip) = (impulses[contacts + k], mu * impulses[k], speed[contacts + k]);
        worst = worst.max(friction.abs() - most);
        worst = worst.max((friction + most * slip.signum()).abs().min(slip.abs()));
    }
    worst
}

fn examine(it: &Collision, outcome: &Outcome) -> f64 {
    let approach = it.approach();
    let e = |k: usize| if let Row::Contact { restitution, .. } = it.rows[k] { restitution } else { 0.0 };
    match &outcome.compression {
        None => stage(it, (&it.rates, &outcome.rates), &outcome.impulses, |k| (0.0, e(k) * approach[k])),
        Some((rates, impulses)) => {
            let first = stage(it, (&it.rates, rates), impulses, |_| (0.0, 0.0));
            let rest = &outcome.impulses - impulses;
            first.max(stage(it, (rates, &outcome.rates), &rest, |k| (e(k) * impulses[k], 0.0)))
        }
    }
}

fn change(it: &Collision, outcome: &Outcome) -> f64 {
    let kinetic = |u: &DVector<f64>| 0.5 * u.dot(&(&it.mass * u));
    kinetic(&outcome.rates) - kinetic(&it.rates)
}

/// How far the groups of an outcome differ from what each does alone, relative to the rates.
fn apart_from_each_other(it: &Collision, outcome: &Outcome) -> f64 {
    let mut rates = it.rates.clone();
    for group in &outcome.groups {
        let alone = |(row, part): (usize, &Row)| match part {
            Row::Contact { .. } if !group.contacts.contains(&row) => Row::Open,
            part => *part,
        };
        let rows = it.rows.iter().enumerate().map(alone).collect();
        rates += Collision { rows, ..it.clone() }.solve().unwrap().rates - &it.rates;
    }
    (rates - &outcome.rates).amax() / outcome.rates.amax()
}

/// Several contacts at once: the conditions to 1e-10, Poisson's law never gains, Newton's tells
/// what it gains.
#[test]
fn contacts_at_once_satisfy_the_law() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let (mut worst, mut most) = (0.0f64, f64::NEG_INFINITY);
    let (mut gains, mut several, mut wedged, mut apart) = (0, 0, 0, 0);
    for k in 0..cases(1_000) {
        let law = [Law::Newton, Law::Poisson, Law::Moreau][k % 3];
        let e = random.between(0.0, 1.0);
        let least = if law == Law::Moreau { 1 } else { 2 };
        let it = collision(&mut random, least + k / 3 % 3, (e, law));
        let outcome = it.solve().unwrap();
        if !outcome.groups.is_empty() {
            apart += 1;
            worst = worst.max(it.residual(&outcome)).max(apart_from_each_other(&it, &outcome));
            continue;
        }
        assert_eq!(outcome.method, ImpulseMethod::AtOnce);
        assert!(outcome.law == law || law != Law::Poisson);
        wedged += usize::from(outcome.law != law);
        let size = it.rates.amax() + outcome.impulses.amax();
        worst = worst.max(examine(&it, &outcome) / size).max(it.residual(&outcome));
        let change = change(&it, &outcome);
        assert!((change - outcome.gained).abs() <= 1e-12 * size * size, "{k}");
        several += usize::from(outcome.solutions > 1);
        match outcome.law {
            Law::Newton | Law::Moreau => gains += usize::from(change > 1e-12),
            _ => most = most.max(change),
        }
    }
    println!("residual {worst:e}, Newton and Moreau gain {gains}, Poisson at most {most:e}");
    println!("several outcomes {several}, wedged {wedged}, apart {apart}");
    assert!(worst <= 1e-10 && most <= 1e-12 && gains > 0 && apart > 0, "{worst:e} {most:e} {gains} {apart}");
}

/// The same in other units of mass, length and velocity.
fn in_units(it: &Collision, (mass, length, rate): (f64, f64, f64)) -> Collision {
    let unit = |j: usize| if j % 3 == 2 { 1.0 } else { length };
    let (n, rows) = (it.rates.len(), it.rows.len());
    Collision {
        mass: DMatrix::from_fn(n, n, |i, j| it.mass[(i, j)] * mass * length * length / (unit(i) * unit(j))),
        jacobian: DMatrix::from_fn(rows, n, |i, j| it.jacobian[(i, j)] * length / unit(j)),
        rates: DVector::from_fn(n, |j, _| it.rates[j] * unit(j) * rate),
        ..it.clone()
    }
}

/// Contacts with friction, of which some are rough or guides or give back slip.
fn of_all_kinds(random: &mut Random, k: usize) -> Collision {
    let law = [Law::Newton, Law::Poisson, Law::Stronge][k % 3];
    let contacts = 1 + random.below(3);
    let mut it = collision(random, contacts, ((k % 7) as f64 / 6.0, law));
    match (random.below(4), &mut it.rows[2 * contacts - 1]) {
        (0, row) => *row = Row::Tangent { of: contacts - 1 },
        (1, Row::Friction { restitution, .. }) => *restitution = 0.6,
        (2, _) if contacts > 1 => it.rows[0] = Row::Guide,
        _ => {}
    }
    it
}

#[test]
fn units_do_not_matter() {
    let mut random = Random(0x0F1E_2D3C_4B5A_6978);
    let (mut answered, mut rough) = (0, 0);
    let examined = cases(500);
    for k in 0..examined {
        let it = of_all_kinds(&mut random, k);
        let is_answered = have_no_units(&it, k);
        answered += usize::from(is_answered);
        let is_rough = it.rows.iter().any(|row| matches!(row, Row::Tangent { .. }));
        rough += usize::from(is_answered && is_rough);
    }
    assert!(3 * answered > 2 * examined && 10 * rough > examined, "{answered} {rough}");
}

/// Impulses that are not unique, where the search for the shortest ones was lost in rounding in
/// some units.
#[test]
fn shared_impulses_have_no_units() {
    for (k, state) in [(7567, 0x7058_FE49_CEB6_3245), (9742, 0xBBB9_0FAC_0BBE_492C)] {
        assert!(have_no_units(&of_all_kinds(&mut Random(state), k), k));
    }
}

/// Impulses and rates in other units are those in these, and satisfy the law; whether there are
/// any.
fn have_no_units(it: &Collision, k: usize) -> bool {
    let found = it.solve();
    for units in [(1e7, 1e-4, 3e3), (2e-9, 7e3, 1e-5)] {
        let other = in_units(it, units).solve();
        let (one, other) = match (&found, other) {
            (Ok(one), Ok(other)) => (one, other),
            (one, other) => {
                assert_eq!(one.as_ref().err(), other.as_ref().err(), "{k}");
                continue;
            }
        };
        assert_eq!((&one.acting, one.law, one.method), (&other.acting, other.law, other.method), "{k}");
        assert_eq!((one.unique, one.solutions), (other.unique, other.solutions), "{k}");
        let (mass, length, rate) = units;
        let size = it.rates.amax() + one.impulses.amax();
        let back = in_units(&Collision { rates: one.rates.clone(), ..it.clone() }, units).rates;
        let moved = back.zip_map(&other.rates, |x, y| (x - y).abs() / (length.max(1.0) * rate)).amax();
        let impulses = (&one.impulses - &other.impulses / (mass * length * rate)).amax();
        assert!(moved <= 1e-9 * size && impulses <= 1e-9 * size, "{k} {moved:e} {impulses:e}");
    }
    if let Ok(outcome) = &found {
        assert!(it.residual(outcome) <= 1e-10, "{k} {:e}", it.residual(outcome));
    }
    found.is_ok()
}

/// The largest violation of a stage's laws by a guide, the first of the rows.
fn guided(it: &Collision, rates: &DVector<f64>, impulses: &DVector<f64>) -> f64 {
    let tangent = it.rows.len() / 2;
    let Row::Friction { mu, .. } = it.rows[tangent] else { unreachable!() };
    let speed = &it.jacobian * rates;
    let (friction, most, slip) = (impulses[tangent], mu * impulses[0].abs(), speed[tangent]);
    let against = (friction + most * slip.signum()).abs().min(slip.abs());
    speed[0].abs().max(friction.abs() - most).max(against)
}

/// What Poisson's law may gain by the guide, (P_tᵉ − e P_tᶜ) v⁺. With one e, Λ the impulses of all
/// rows, γ their speeds and W their Delassus matrix
///
/// ```text
/// T⁺ − Tᶜ = Λᵉ·γ⁺ − ½ Λᵉ·W Λᵉ,    Λᵉ·γ⁺ = e Λᶜ·(γᶜ + W Λᵉ) + Σ (P_tᵉ − e P_tᶜ) v⁺
/// T⁺ − T⁻ ≤ (1 + e) Λᶜ·γᶜ − ½ (1 − e²) Λᶜ·W Λᶜ + Σ (P_tᵉ − e P_tᶜ) v⁺
/// ```
///
/// where Λᶜ·γᶜ ≤ 0, and the sum is ≤ 0 of contacts: Pᵉ ≥ e Pᶜ. Of a guide |Pᵉ| may be less, and
/// with it the friction.
fn gained_by_guide(it: &Collision, e: f64, outcome: &Outcome) -> f64 {
    let Some((_, first)) = &outcome.compression else { return 0.0 };
    let tangent = it.rows.len() / 2;
    let slip = (&it.jacobian * &outcome.rates)[tangent];
    (outcome.impulses[tangent] - (1.0 + e) * first[tangent]) * slip
}

/// A guide beside contacts that strike: it stays closed, and each stage obeys the law with |P|.
/// Nothing is gained but by its friction.
#[test]
fn guides_rub_where_contacts_strike() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (mut worst, mut most, mut several, mut seen) = (0.0f64, f64::NEG_INFINITY, 0, 0);
    let (mut gained, mut gains) = (f64::NEG_INFINITY, 0);
    let examined = cases(1_000);
    for k in 0..examined {
        let law = [Law::Newton, Law::Poisson][k % 2];
        let e = random.between(0.0, 1.0);
        let mut it = collision(&mut random, 2 + k % 2, (e, law));
        it.rows[0] = Row::Guide;
        let across = it.jacobian.row(0).transpose();
        it.rates -= &across * (across.dot(&it.rates) / across.norm_squared());
        let tangent = it.rows.len() / 2;
        if (&it.jacobian * &it.rates).rows(1, tangent - 1).max() >= 0.0 {
            continue;
        }
        let outcome = it.solve().unwrap_or_else(|error| panic!("{k}: {error}"));
        let size = it.rates.amax() + outcome.impulses.amax();
        worst = worst.max(it.residual(&outcome));
        if !outcome.groups.is_empty() {
            continue;
        }
        let violation = match &outcome.compression {
            None => guided(&it, &outcome.rates, &outcome.impulses),
            Some((rates, impulses)) => {
                let rest = &outcome.impulses - impulses;
                guided(&it, rates, impulses).max(guided(&it, &outcome.rates, &rest))
            }
        };
        worst = worst.max(violation / size);
        let change = change(&it, &outcome);
        assert!((change - outcome.gained).abs() <= 1e-12 * size * size, "{k}");
        if outcome.law == Law::Poisson || e == 0.0 {
            gained = gained.max(change);
            gains += usize::from(change > 1e-12);
            most = most.max(change - gained_by_guide(&it, e, &outcome).max(0.0));
        }
        several += usize::from(outcome.solutions > 1);
        seen += 1;
    }
    println!("{seen} impacts, residual {worst:e}, several outcomes {several}");
    println!("Poisson gains {gains} times, {gained:e} at most, {most:e} beyond the guide's");
    assert!(worst <= 1e-10 && most <= 1e-12 && 4 * seen > examined, "{worst:e} {most:e} {seen}");
}

/// Single contacts: all three laws along the path; by Poisson and Stronge no energy is gained.
#[test]
fn a_single_contact_never_gains_but_by_newton() {
    let mut random = Random(0x1234_5678_9ABC_DEF1);
    let (mut gains, mut most, mut worst) = (0, f64::NEG_INFINITY, 0.0f64);
    for k in 0..10_000 {
        let law = [Law::Newton, Law::Poisson, Law::Stronge][k % 3];
        let e = random.between(0.0, 1.0);
        let it = collision(&mut random, 1, (e, law));
        let outcome = it.solve().unwrap();
        assert_eq!((outcome.method, outcome.law), (ImpulseMethod::Path, law));
        let Row::Friction { mu, .. } = it.rows[1] else { unreachable!() };
        let size = it.rates.amax() + outcome.impulses.amax();
        let balance = &it.mass * (&outcome.rates - &it.rates) - it.jacobian.tr_mul(&outcome.impulses);
        worst = worst.max(balance.amax() / size).max(it.residual(&outcome));
        worst = worst.max((outcome.impulses[1].abs() - mu * outcome.impulses[0]) / size);
        worst = worst.max((outcome.gained - change(&it, &outcome)).abs() / (size * size));
        assert!(outcome.impulses[0] > 0.0 && outcome.opening[0] >= 0.0);
        match law {
            Law::Newton => {
                gains += usize::from(outcome.gained > 1e-12);
                worst = worst.max((outcome.opening[0] + e * it.approach()[0]).abs() / size);
            }
            _ => most = most.max(outcome.gained),
        }
    }
    println!("residual {worst:e}, Newton gains {gains}, others at most {most:e}");
    assert!(worst <= 1e-12 && most <= 1e-12 && gains > 0);
}

/// A contact that touches and is not pressed on the way changes nothing; one that is ends the path,
/// and Stronge's law.
#[test]
fn another_contact_ends_the_path_only_where_it_is_pressed() {
    let mut random = Random(0xABCD_EF01_2345_6789);
    let (mut alone, mut pressed) = (0, 0);
    for _ in 0..2_000 {
        let mut it = collision(&mut random, 2, (0.5, Law::Stronge));
        // The second contact touches at rest.
        let row = it.jacobian.row(1).transpose();
        let inverse = it.mass.clone().try_inverse().unwrap();
        let part = row.dot(&it.rates) / row.dot(&(&inverse * &row));
        it.rates -= &inverse * row * part;
        it.prescribed_gap_rate[1] = -(&it.jacobian * &it.rates)[1];
        if it.approach()[0] >= 0.0 {
            continue;
        }
        let mut single = it.clone();
        (single.rows[1], single.rows[3]) = (Row::Open, Row::Open);
        let single = single.solve().unwrap();
        match it.solve() {
            Ok(outcome) => {
                alone += 1;
                assert!((outcome.rates - single.rates).amax() < 1e-15 && outcome.opening[1] >= 0.0);
            }
            Err(error) => {
                pressed += 1;
                assert_eq!(error, CollisionError::Several);
            }
        }
    }
    println!("alone {alone}, pressed {pressed}");
    assert!(alone > 100 && pressed > 100);
}

/// Whether two contacts that slide or rest with ġ = 0 have no reactions under a force.
fn is_inconsistent(it: &Collision, force: &DVector<f64>) -> bool {
    let bias = DVector::zeros(4);
    let mut kkt = EquilibratedKkt::new(&it.mass, &it.jacobian, (force, &bias), (&force.abs(), &bias));
    let slip = |v: f64| if v > 0.0 { SlipVelocity::Forward } else { SlipVelocity::Backward };
    let contact = |k: usize| {
        let Row::Friction { mu, .. } = it.rows[2 + k] else { unreachable!() };
        Frictional::touching((k, 2 + k), (mu, mu), slip(it.approach()[2 + k]))
    };
    let contacts = [contact(0), contact(1)];
    let question = FrictionProblem { rows: LcpRows::default(), contacts: &contacts };
    kkt.solve_with_friction(&question).is_err_and(|error| error == FrictionError::Inconsistent)
}

/// Two contacts slide and no reactions hold them: an impulse changes the motion, nothing is gained,
/// and the law holds.
#[test]
fn a_paradox_ends_in_an_impact() {
    let mut random = Random(0x0F0F_1234_ABCD_9999);
    let (mut paths, mut together, mut several) = (0, 0, 0);
    for k in 0..20_000 {
        let law = [Law::Newton, Law::Poisson, Law::Stronge][k % 3];
        let mut it = collision(&mut random, 2, (0.4, law));
        for row in 0..2 {
            it.prescribed_gap_rate[row] = -(&it.jacobian * &it.rates)[row];
        }
        let force = DVector::from_fn(it.rates.len(), |_, _| random.between(-1.0, 1.0));
        if !is_inconsistent(&it, &force) {
            continue;
        }
        let outcome = match it.tangential_impact(usize::MAX) {
            Ok(outcome) => outcome,
            Err(error) => {
                several += 1;
                assert!(law == Law::Stronge && error == CollisionError::Several, "{k} {error:?}");
                continue;
            }
        };
        paths += usize::from(outcome.method == ImpulseMethod::Path);
        together += usize::from(outcome.method == ImpulseMethod::AtOnce);
        let size = it.rates.amax() + outcome.impulses.amax();
        assert!(it.residual(&outcome) <= 1e-10, "{k} {:e}", it.residual(&outcome));
        assert!(outcome.gained <= 1e-12 && !outcome.acting.is_empty(), "{k} {}", outcome.gained);
        for contact in 0..2 {
            let Row::Friction { mu, .. } = it.rows[2 + contact] else { unreachable!() };
            let (normal, friction) = (outcome.impulses[contact], outcome.impulses[2 + contact]);
            assert!(normal >= -1e-12 * size && friction.abs() <= mu * normal + 1e-10 * size);
            assert!(outcome.opening[contact] >= -1e-10 * size);
        }
    }
    println!("paths {paths}, together {together}, several {several}");
    assert!(paths > 100 && together > 10 && several > 5);
}
