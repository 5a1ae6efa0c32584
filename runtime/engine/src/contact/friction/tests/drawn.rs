//! Motions at the borders of their modes: a motion is drawn first, with reserves, slips and
//! openings that vanish here and there, and the loads follow from it. What vanishes is left to the
//! next order, and nothing else.

use nalgebra::{DMatrix, DVector};

use super::super::decision::FrictionSolution;
use super::super::modes::{ContactMode, Frictional, ModeCondition, SlipDirection, SlipVelocity};
use super::oracle::{Contact, Linkage, Motion};
use super::random::{Random, Sorted, linkage};
use crate::contact::complementarity::Solution;
use crate::model::Side;

/// What is clearly not zero beside terms of one: the rounding of the balanced problem and four
/// digits more.
pub(super) const LITTLE: f64 = 1e-8;

/// Zero, little or much.
fn amount(random: &mut Random) -> f64 {
    [0.0, LITTLE, random.between(0.2, 1.0)][random.below(3)]
}

fn sign(random: &mut Random) -> f64 {
    [-1.0, 1.0][random.below(2)]
}

/// λ_N, R, g̈ and v̇ of a contact that obeys its law.
fn drawn(it: &Contact, random: &mut Random) -> [f64; 4] {
    let side = if it.is_guide { sign(random) } else { 1.0 };
    if !it.is_guide && random.below(3) == 0 {
        let opening = amount(random);
        let slip = match it.slip {
            // One that was located at its limit need not slide by less than the error of that.
            SlipVelocity::Leaves(sense) => {
                sense.sign() * [amount(random), random.between(-1.0, -0.2)][random.below(2)]
            }
            _ => amount(random) * sign(random),
        };
        return [0.0, 0.0, opening, if it.has_friction() || opening > 0.0 { slip } else { 0.0 }];
    }
    let normal = amount(random);
    let slides = |sense: f64, slip: f64| [side * normal, -sense * it.mu * normal, 0.0, slip];
    match it.slip {
        _ if it.tangent.is_none() => [normal, 0.0, 0.0, 0.0],
        _ if !it.has_friction() => [0.5 + normal, random.between(-1.0, 1.0), 0.0, 0.0],
        SlipVelocity::Forward => slides(1.0, random.between(-1.0, 1.0)),
        SlipVelocity::Backward => slides(-1.0, random.between(-1.0, 1.0)),
        SlipVelocity::Leaves(sense) => slides(sense.sign(), sense.sign() * amount(random)),
        SlipVelocity::Rest if random.below(2) == 0 => {
            let sense = sign(random);
            slides(sense, sense * amount(random))
        }
        SlipVelocity::Rest => {
            let most = it.limit * normal;
            let less = [0.0, LITTLE.min(0.5 * most), random.between(0.1, 0.9) * most][random.below(3)];
            [side * normal, sign(random) * (most - less), 0.0, 0.0]
        }
    }
}

/// Loads of a linkage that move it as drawn.
pub(super) fn load(linkage: &mut Linkage, random: &mut Random) -> Motion {
    let (r, n) = linkage.jacobian.shape();
    let a = DVector::from_fn(n, |_, _| random.between(-1.0, 1.0));
    let (mut multipliers, mut openings) = (DVector::zeros(r), DVector::zeros(r));
    for &row in &linkage.joints {
        multipliers[row] = sign(random) * amount(random);
    }
    for contact in &linkage.contacts {
        let [normal, friction, opening, slip] = drawn(contact, random);
        (multipliers[contact.normal], openings[contact.normal]) = (normal, opening);
        if let Some(tangent) = contact.tangent {
            (multipliers[tangent], openings[tangent]) = (friction, slip);
        }
    }
    linkage.force = &linkage.mass * &a - linkage.jacobian.tr_mul(&multipliers);
    linkage.bias = openings - &linkage.jacobian * &a;
    Motion { a, multipliers }
}

/// The modes that a motion is one of, each with the conditions that it meets with zero.
fn left(it: &Contact, [normal, friction, opening, slip]: [f64; 4]) -> Vec<(ContactMode, Vec<ModeCondition>)> {
    let mut modes = Vec::new();
    let met = |asked: &[(ModeCondition, f64)]| {
        let zero = |(condition, value): &(ModeCondition, f64)| (*value == 0.0).then_some(*condition);
        let holds = asked.iter().all(|(_, value)| *value >= 0.0);
        holds.then(|| asked.iter().filter_map(zero).collect::<Vec<_>>())
    };
    let sides: &[f64] = if it.is_guide { &[1.0, -1.0] } else { &[1.0] };
    let senses = match it.slip {
        SlipVelocity::Forward | SlipVelocity::Leaves(SlipDirection::Forward) => vec![SlipDirection::Forward],
        SlipVelocity::Backward | SlipVelocity::Leaves(SlipDirection::Backward) => {
            vec![SlipDirection::Backward]
        }
        SlipVelocity::Rest => vec![SlipDirection::Forward, SlipDirection::Backward],
    };
    for &s in sides {
        let side = if s > 0.0 { Side::Positive } else { Side::Negative };
        let mode = |sense: Option<SlipDirection>| match sense {
            _ if it.is_guide => ContactMode::Guide { side, sense },
            None => ContactMode::Stick,
            Some(sense) => ContactMode::Slide(sense),
        };
        let (presses, most) = ((ModeCondition::Presses, s * normal), it.limit * s * normal);
        let reserves = [(ModeCondition::Below, most - friction), (ModeCondition::Above, most + friction)];
        if it.slip == SlipVelocity::Rest && opening == 0.0 && slip == 0.0 {
            modes.extend(met(&[presses, reserves[0], reserves[1]]).map(|met| (mode(None), met)));
        }
        for &sense in &senses {
            let asked = [presses, (ModeCondition::Slips, sense.sign() * slip)];
            let asked = &asked[..if it.slip == SlipVelocity::Rest { 2 } else { 1 }];
            let leaves = it.slip != SlipVelocity::Leaves(sense) || sense.sign() * slip >= 0.0;
            if leaves && opening == 0.0 && friction == -sense.sign() * it.mu * s * normal {
                modes.extend(met(asked).map(|met| (mode(Some(sense)), met)));
            }
        }
    }
    if !it.is_guide && normal == 0.0 && friction == 0.0 {
        modes.extend(met(&[(ModeCondition::Opens, opening)]).map(|met| (ContactMode::Open, met)));
    }
    modes
}

/// What a motion leaves of every contact with friction.
pub(super) fn all_left(linkage: &Linkage, motion: &Motion) -> Vec<Vec<(ContactMode, Vec<ModeCondition>)>> {
    let openings = &linkage.jacobian * &motion.a + &linkage.bias;
    // What was drawn as zero has the rounding of the loads.
    let exact = |x: f64| if x.abs() < 1e-3 * LITTLE { 0.0 } else { x };
    let of = |it: &Contact| {
        let row = it.tangent.unwrap();
        let (normal, friction) = (motion.multipliers[it.normal], motion.multipliers[row]);
        left(it, [normal, friction, exact(openings[it.normal]), exact(openings[row])])
    };
    linkage.contacts.iter().filter(|it| it.has_friction()).map(of).collect()
}

pub(super) fn list_modes(next: &[Frictional]) -> Vec<Vec<(ContactMode, Vec<ModeCondition>)>> {
    let of = |it: &Frictional| it.choices.iter().map(|it| (it.mode, it.conditions.to_vec())).collect();
    next.iter().map(of).collect()
}

/// Rows with signs of their multipliers: those that are less than zero, zero, and more.
fn by_sign(rows: &[usize], motion: &Motion) -> [Vec<usize>; 3] {
    let of =
        |sign: f64| rows.iter().copied().filter(|&row| sign_of(motion.multipliers[row]) == sign).collect();
    [-1.0, 0.0, 1.0].map(of)
}

fn sign_of(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// What a solution tells of rows without friction.
pub(super) fn examine(linkage: &Linkage, motion: &Motion, found: &Solution, label: usize) {
    let Sorted { candidates, .. } = Sorted::new(linkage);
    let [pulling, _, pushing] = by_sign(&linkage.joints, motion);
    assert_eq!((&found.pulling, &found.pushing), (&pulling, &pushing), "{label}");
    let [_, unloaded, bearing] = by_sign(&candidates, motion);
    let openings = &linkage.jacobian * &motion.a + &linkage.bias;
    let touching = unloaded.into_iter().filter(|&row| openings[row] < 1e-3 * LITTLE).collect::<Vec<_>>();
    assert_eq!((&found.active_basis, &found.degenerate), (&bearing, &touching), "{label}");
}

pub(super) fn is_the_drawn_one(found: &FrictionSolution, motion: &Motion) -> bool {
    let apart = (&found.solution.accelerations - &motion.a).amax();
    let apart = apart.max((&found.solution.reactions - &motion.multipliers).amax());
    found.solution.unique && apart <= 1e-2 * LITTLE
}

/// Whether joints and contacts are so far from depending on each other that rounding stays
/// rounding.
pub(super) fn is_well_conditioned(linkage: &Linkage) -> bool {
    let closed = |it: &Contact| [Some(it.normal), it.tangent];
    let rows = linkage.contacts.iter().flat_map(closed).flatten().chain(linkage.joints.iter().copied());
    let rows: Vec<usize> = rows.collect();
    let unit = |j: usize| 1.0 / linkage.mass[(j, j)].sqrt();
    let natural =
        DMatrix::from_fn(rows.len(), linkage.mass.nrows(), |i, j| linkage.jacobian[(rows[i], j)] * unit(j));
    let values = natural.singular_values();
    rows.len() <= linkage.mass.nrows() && values.min() > 0.1 * values.max()
}

pub(super) fn contacts_of_all_kinds(random: &mut Random, count: usize) -> Linkage {
    let mut linkage = linkage(random, count);
    while !is_well_conditioned(&linkage) {
        linkage = super::random::linkage(random, count);
    }
    for contact in linkage.contacts.iter_mut().filter(|it| it.has_friction()) {
        contact.is_guide = random.below(4) == 0;
        (contact.mu, contact.limit) = (contact.mu.max(0.2), contact.limit.max(0.2));
        if contact.slip != SlipVelocity::Rest && random.below(2) == 0 {
            contact.slip =
                SlipVelocity::Leaves([SlipDirection::Forward, SlipDirection::Backward][random.below(2)]);
        }
    }
    linkage
}
