//! Rods, blocks and planks whose motion is known.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::super::decision::{FrictionError, FrictionSolution, Reason};
use super::super::modes::{ContactMode, Frictional, ModeCondition, SlipDirection, SlipVelocity};
use super::super::problem::FrictionProblem;
use super::super::stability::{Sliding, painleve};
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;

const FORWARD: ContactMode = ContactMode::Slide(SlipDirection::Forward);
const BACKWARD: ContactMode = ContactMode::Slide(SlipDirection::Backward);

pub(super) fn solve(
    mass: &[f64],
    jacobian: &DMatrix<f64>,
    (force, bias): (&[f64], &[f64]),
    contacts: &[Frictional],
) -> Result<FrictionSolution, FrictionError> {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(mass));
    let (force, bias) = (DVector::from_row_slice(force), DVector::from_row_slice(bias));
    let mut kkt = EquilibratedKkt::new(&mass, jacobian, (&force, &bias), (&force.abs(), &bias.abs()));
    kkt.solve_with_friction(&FrictionProblem { rows: LcpRows::default(), contacts })
}

/// A block of unit weight pushed along the floor.
fn block(push: f64, (mu, limit): (f64, f64), slip: SlipVelocity) -> FrictionSolution {
    let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
    let contact = Frictional::touching((0, 1), (mu, limit), slip);
    solve(&[1.0, 1.0], &jacobian, (&[push, -1.0], &[0.0, 0.0]), &[contact]).unwrap()
}

#[test]
fn a_block_sticks_up_to_its_limit() {
    for (push, mode, a) in [(0.3, ContactMode::Stick, 0.0), (0.7, FORWARD, 0.2), (-0.7, BACKWARD, -0.2)] {
        let found = block(push, (0.5, 0.5), SlipVelocity::Rest);
        assert_eq!((found.modes[0], found.solutions.len(), found.reason), (mode, 1, Reason::Only));
        assert!((found.solution.accelerations[0] - a).abs() < 1e-15);
        assert!(found.next[0].is_decided() && found.solution.unique);
    }
    // What bears is not open, though nothing is borne across.
    let still = block(0.0, (0.5, 0.5), SlipVelocity::Rest);
    assert!(still.modes == [ContactMode::Stick] && still.next[0].is_decided());
    let slowed = block(0.0, (0.5, 0.5), SlipVelocity::Forward);
    assert!((slowed.solution.accelerations[0] + 0.5).abs() < 1e-15);
    assert!((slowed.solution.reactions[1] + 0.5).abs() < 1e-15);
}

/// Between kinetic friction and the limit of sticking both satisfy the law; what rests stays.
#[test]
fn contacts_below_their_limit_stick() {
    let found = block(0.6, (0.5, 0.7), SlipVelocity::Rest);
    assert_eq!((found.modes[0], found.reason), (ContactMode::Stick, Reason::Sticks));
    assert_eq!(found.solutions, [[ContactMode::Stick], [FORWARD]]);
    let left = block(0.7, (0.5, 0.7), SlipVelocity::Leaves(SlipDirection::Forward));
    assert_eq!(left.modes, [FORWARD]);
    assert!((left.solution.accelerations[0] - 0.2).abs() < 1e-15);
}

/// At its limit exactly order 0 leaves two modes, of which the rate of the push decides.
#[test]
fn the_next_order_decides_at_the_limit() {
    let found = block(0.5, (0.5, 0.5), SlipVelocity::Rest);
    let left = &found.next[0];
    let told: Vec<_> = left.choices.iter().map(|it| (it.mode, it.conditions.to_vec())).collect();
    assert_eq!(
        told,
        [(ContactMode::Stick, vec![ModeCondition::Above]), (FORWARD, vec![ModeCondition::Slips])]
    );
    let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
    for (rate, mode) in [(0.1, FORWARD), (-0.1, ContactMode::Stick)] {
        let next = solve(&[1.0, 1.0], &jacobian, (&[rate, 0.0], &[0.0, 0.0]), &found.next).unwrap();
        assert_eq!((next.modes[0], next.solutions.len()), (mode, 1));
        assert!(next.next[0].is_decided());
    }
}

/// A contact without force, at rest: order 1 decides among all modes.
#[test]
fn a_contact_without_force_is_left_open() {
    let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
    let contact = Frictional::touching((0, 1), (0.5, 0.5), SlipVelocity::Rest);
    let found = solve(&[1.0, 1.0], &jacobian, (&[0.0, 0.0], &[0.0, 0.0]), &[contact]).unwrap();
    assert_eq!((found.solutions.len(), found.next[0].choices.len()), (1, 4));
    for (rates, mode) in [
        ([0.1, 1.0], ContactMode::Open),
        ([0.1, -1.0], ContactMode::Stick),
        ([0.6, -1.0], FORWARD),
        ([-0.6, -1.0], BACKWARD),
    ] {
        let next = solve(&[1.0, 1.0], &jacobian, (&rates, &[0.0, 0.0]), &found.next).unwrap();
        assert_eq!((next.modes[0], next.solutions.len()), (mode, 1));
    }
}

/// Catalogue 19: a uniform rod of unit length, its lower end on the floor at θ, x to the right.
fn rod(angle: f64) -> DMatrix<f64> {
    let (sine, cosine) = angle.sin_cos();
    DMatrix::from_row_slice(2, 3, &[0.0, 1.0, -0.5 * cosine, 1.0, 0.0, 0.5 * sine])
}

const ROD: [f64; 3] = [1.0, 1.0, 1.0 / 12.0];

fn border(angle: f64, mu: f64) -> f64 {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&ROD));
    let sliding = Sliding { normal: 0, tangent: 1, signed_mu: -mu };
    painleve(&mass, &rod(angle), sliding, &[], &[]).unwrap()
}

/// 1 + 3 cos²θ − 3 μ sin θ cos θ of the rod that slides backward touches zero at tan θ = 2 for μ =
/// 4/3.
#[test]
fn the_border_of_painleve_s_paradox() {
    for (mu, degrees) in [
        (1.4, [55.585_810_807_887_1, 69.95186698408728]),
        (2.0, [37.377_368_140_649_7, 79.187_683_036_428_3]),
        (4.0 / 3.0, [2f64.atan() * 180.0 / PI; 2]),
    ] {
        for degrees in degrees {
            assert!(border(degrees * PI / 180.0, mu).abs() < 1e-14);
        }
        let (sine, cosine) = 1f64.sin_cos();
        let expected = 1.0 + 3.0 * cosine * cosine - 3.0 * mu * sine * cosine;
        assert!((border(1.0, mu) - expected).abs() < 1e-14);
    }
}

fn sliding_rod(rate: f64, mu: f64, slip: SlipVelocity) -> Result<FrictionSolution, FrictionError> {
    let angle = PI / 3.0;
    let (sine, cosine) = angle.sin_cos();
    let bias = [0.5 * sine * rate * rate, 0.5 * cosine * rate * rate];
    let contact = Frictional::touching((0, 1), (mu, mu), slip);
    solve(&ROD, &rod(angle), (&[0.0, -1.0, 0.0], &bias), &[contact])
}

/// In the interval: no solution while the floor is pressed on, two while it is not, of which the
/// rod leaves.
#[test]
fn the_rod_has_no_or_two_motions() {
    assert_eq!(sliding_rod(0.1, 2.0, SlipVelocity::Backward).unwrap_err(), FrictionError::Inconsistent);
    let found = sliding_rod(2.0, 2.0, SlipVelocity::Backward).unwrap();
    assert_eq!((found.modes[0], found.reason, found.solutions.len()), (ContactMode::Open, Reason::Stable, 2));
    assert!(sliding_rod(0.1, 2.0, SlipVelocity::Forward).is_ok());
    assert!(sliding_rod(0.1, 1.2, SlipVelocity::Backward).is_ok());
    let at_rest = sliding_rod(0.1, 2.0, SlipVelocity::Rest).unwrap();
    assert_eq!((at_rest.modes[0], at_rest.solutions.len()), (ContactMode::Stick, 1));
}

/// A plank of unit weight on many feet: it slides like a block on one, and bears its weight.
#[test]
fn a_plank_with_two_hundred_feet() {
    let feet = 200;
    let jacobian = DMatrix::from_fn(2 * feet, 3, |row, j| {
        let arm = (row / 2) as f64 - 70.3;
        if row % 2 == 0 { [0.0, 1.0, arm][j] } else { [1.0, 0.0, 0.0][j] }
    });
    let contacts = |slip: SlipVelocity, (mu, limit): (f64, f64)| -> Vec<Frictional> {
        (0..feet).map(|foot| Frictional::touching((2 * foot, 2 * foot + 1), (mu, limit), slip)).collect()
    };
    let bias = vec![0.0; 2 * feet];
    for (push, (mu, limit), slip, mode, a) in [
        (0.3, (0.5, 0.5), SlipVelocity::Rest, ContactMode::Stick, 0.0),
        (0.7, (0.5, 0.6), SlipVelocity::Rest, FORWARD, 0.2),
        (0.0, (0.5, 0.5), SlipVelocity::Backward, BACKWARD, 0.5),
    ] {
        let force = [push, -1.0, 0.0];
        let start = std::time::Instant::now();
        let found =
            solve(&[1.0, 1.0, 1e3], &jacobian, (&force, &bias), &contacts(slip, (mu, limit))).unwrap();
        println!("{mode:?}: {:?}", start.elapsed());
        assert!((&found.solution.accelerations - DVector::from_row_slice(&[a, 0.0, 0.0])).amax() < 1e-12);
        assert!(found.modes.iter().all(|it| *it == mode), "{:?}", found.modes);
        let weight: f64 = (0..feet).map(|foot| found.solution.reactions[2 * foot]).sum();
        assert!((weight - 1.0).abs() < 1e-12 && !found.solution.unique && found.determined);
    }
}

/// A plank on three feet of which each would hold a third: redundant and tried mode by mode. The
/// shortest reactions are thirds too, of the load across as well while it sticks.
#[test]
fn redundant_feet_stick_with_admissible_reactions() {
    let jacobian = DMatrix::from_fn(6, 3, |row, j| {
        let arm = (row / 2) as f64 - 1.0;
        if row % 2 == 0 { [0.0, 1.0, arm][j] } else { [1.0, 0.0, 0.0][j] }
    });
    let foot = |k: usize, slip| Frictional::touching((2 * k, 2 * k + 1), (0.5, 0.5), slip);
    for (push, mode) in [(0.49, ContactMode::Stick), (0.6, FORWARD)] {
        let feet: Vec<_> = (0..3).map(|k| foot(k, SlipVelocity::Rest)).collect();
        let (mass, force) = (DMatrix::identity(3, 3), DVector::from_row_slice(&[push, -1.0, 0.0]));
        let bias = DVector::zeros(6);
        let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
        let question = FrictionProblem { rows: LcpRows::default(), contacts: &feet };
        let found = kkt.solve_with_friction(&question).unwrap();
        let shared = kkt.share_with_friction(&question, &found);
        let across = if mode == ContactMode::Stick { -push / 3.0 } else { -0.5 / 3.0 };
        let thirds = DVector::from_fn(6, |row, _| if row % 2 == 0 { 1.0 / 3.0 } else { across });
        assert!((&shared - thirds).amax() < 1e-13, "{shared}");
        assert_eq!((found.modes.as_slice(), found.solutions.len()), ([mode; 3].as_slice(), 1));
        assert!(!found.solution.unique);
        let reactions = &found.solution.reactions;
        for k in 0..3 {
            assert!(reactions[2 * k + 1].abs() <= 0.5 * reactions[2 * k] + 1e-12, "{reactions}");
        }
    }
}

/// The same plank, pushed by a cart through a joint: the joint bears the push, the feet hold it.
#[test]
fn redundant_feet_hold_what_a_joint_passes_on() {
    let jacobian = DMatrix::from_fn(7, 4, |row, j| match row {
        6 => [1.0, 0.0, 0.0, -1.0][j],
        _ if row % 2 == 0 => [0.0, 1.0, (row / 2) as f64 - 1.0, 0.0][j],
        _ => [1.0, 0.0, 0.0, 0.0][j],
    });
    let feet: Vec<_> =
        (0..3).map(|k| Frictional::touching((2 * k, 2 * k + 1), (0.5, 0.5), SlipVelocity::Rest)).collect();
    for (push, mode, a) in [(0.49, ContactMode::Stick, 0.0), (0.6, FORWARD, 0.05)] {
        let (force, bias) = (DVector::from_row_slice(&[0.0, -1.0, 0.0, push]), DVector::zeros(7));
        let mut kkt =
            EquilibratedKkt::new(&DMatrix::identity(4, 4), &jacobian, (&force, &bias), (&force.abs(), &bias));
        let rows = LcpRows { fixed: &[6], ..LcpRows::default() };
        let found = kkt.solve_with_friction(&FrictionProblem { rows, contacts: &feet }).unwrap();
        assert_eq!(found.modes, [mode; 3]);
        let reactions = &found.solution.reactions;
        // M a of the cart is the push less what the joint bears.
        assert!(
            (found.solution.accelerations[0] - a).abs() < 1e-14 && (reactions[6] - push + a).abs() < 1e-14
        );
        assert!((reactions[1] + reactions[3] + reactions[5] + reactions[6] - a).abs() < 1e-14);
    }
}

/// Planks of unit weight on each other, each on two feet, the lowest on the floor; one of them is
/// pushed. With k planks on it it slides over the next one from (k + 1) μ on, and those carry what
/// is on them along.
#[test]
fn a_tower_of_planks() {
    let (planks, pushed, mu) = (10, 6, 0.5);
    let above = planks - 1 - pushed;
    let jacobian = DMatrix::from_fn(4 * planks, 3 * planks, |row, j| {
        let (plank, arm) = (row / 4, if row % 4 < 2 { -1.0 } else { 1.0 });
        let along = |height: f64| if row % 2 == 0 { [0.0, 1.0, arm] } else { [1.0, 0.0, -height] };
        match j / 3 {
            body if body == plank => along(-0.1)[j % 3],
            body if body + 1 == plank => -along(0.1)[j % 3],
            _ => 0.0,
        }
    });
    let feet: Vec<Frictional> = (0..2 * planks)
        .map(|foot| Frictional::touching((2 * foot, 2 * foot + 1), (mu, mu), SlipVelocity::Rest))
        .collect();
    let bias = vec![0.0; 4 * planks];
    let moving = (above + 1) as f64;
    for (push, a) in [(0.9 * mu * moving, 0.0), ((mu + 0.2) * moving, 0.2)] {
        let mut force: Vec<f64> = (0..3 * planks).map(|j| if j % 3 == 1 { -1.0 } else { 0.0 }).collect();
        force[3 * pushed] = push;
        let start = std::time::Instant::now();
        let found = solve(&vec![1.0; 3 * planks], &jacobian, (&force, &bias), &feet).unwrap();
        println!("{:?}", start.elapsed());
        for (j, value) in found.solution.accelerations.iter().enumerate() {
            let expected = if j % 3 == 0 && j >= 3 * pushed { a } else { 0.0 };
            assert!((value - expected).abs() < 1e-11, "{j}: {value}");
        }
        let reactions = &found.solution.reactions;
        for foot in 0..2 * planks {
            let (normal, friction) = (reactions[2 * foot], reactions[2 * foot + 1]);
            assert!(normal > -1e-12 && friction.abs() <= mu * normal + 1e-12);
        }
    }
}

/// Feet that differ in μ: how they share the load decides how fast the plank slides, and that is
/// told.
#[test]
fn redundant_feet_of_different_friction_leave_the_motion_open() {
    let jacobian = DMatrix::from_fn(6, 3, |row, j| {
        let arm = (row / 2) as f64 - 1.0;
        if row % 2 == 0 { [0.0, 1.0, arm][j] } else { [1.0, 0.0, 0.0][j] }
    });
    let foot = |k: usize, mu: f64| Frictional::touching((2 * k, 2 * k + 1), (mu, mu), SlipVelocity::Forward);
    for (mu, determined) in [([0.1, 0.3, 0.1], false), ([0.2, 0.2, 0.2], true)] {
        let feet: Vec<_> = (0..3).map(|k| foot(k, mu[k])).collect();
        let found = solve(&[1.0, 1.0, 1.0], &jacobian, (&[0.0, -1.0, 0.0], &[0.0; 6]), &feet).unwrap();
        assert_eq!((found.determined, found.solutions.len()), (determined, 1));
        assert_eq!(found.modes, [FORWARD; 3]);
        let slowed = -found.solution.accelerations[0];
        assert!((0.1 - 1e-12..=0.3 + 1e-12).contains(&slowed));
    }
}

/// Order 1 with a contact that slides by the decision of order 0, and one at rest that order 0 left
/// without force: Ṅ of the first is what it bears of a load that moves on, and friction follows it.
#[test]
fn decided_contacts_bear_at_higher_orders() {
    let jacobian =
        DMatrix::from_row_slice(4, 3, &[0.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
    let sliding = Frictional::decided((0, 1), (0.5, 0.5), FORWARD);
    assert!(sliding.is_decided());
    let second = Frictional::touching((2, 3), (0.2, 0.2), SlipVelocity::Forward);
    // The load leaves the first foot at the rate of a half: f = (0, 0, −½) about the middle.
    for (moment, mode, rates) in [(-0.5, FORWARD, [-0.25, 0.25]), (0.5, ContactMode::Open, [0.0, 0.0])] {
        let force = [0.0, 0.0, moment];
        let contacts = [sliding.clone(), second.clone()];
        let found = solve(&[1.0, 1.0, 1.0], &jacobian, (&force, &[0.0; 4]), &contacts).unwrap();
        assert_eq!(found.modes, [FORWARD, mode]);
        if mode == FORWARD {
            let reactions = &found.solution.reactions;
            assert!((reactions[0] - rates[0]).abs() < 1e-15 && (reactions[2] - rates[1]).abs() < 1e-15);
            assert!((found.solution.accelerations[0] - (0.125 - 0.05)).abs() < 1e-15);
        }
        assert!(found.next.iter().all(Frictional::is_decided));
    }
}

/// A plank on three feet carries a block by a joint: the joint bears the block, and the feet both,
/// however they share that.
#[test]
fn a_joint_bears_beside_feet_that_share_a_load() {
    let jacobian = DMatrix::from_row_slice(
        7,
        4,
        &[
            [0.0, 1.0, -1.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, -1.0],
        ]
        .concat(),
    );
    let contacts: Vec<Frictional> =
        (0..3).map(|foot| Frictional::touching((foot, 3 + foot), (0.5, 0.5), SlipVelocity::Rest)).collect();
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, 1.0 / 3.0, 2.0]));
    let bias = DVector::zeros(7);
    for (push, slides) in [(0.9, false), (2.5, true)] {
        let force = DVector::from_row_slice(&[push, -1.0, 0.0, -2.0]);
        let mut kkt = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
        let rows = LcpRows { fixed: &[6], ..LcpRows::default() };
        let found = kkt.solve_with_friction(&FrictionProblem { rows, contacts: &contacts }).unwrap();
        let reactions = &found.solution.reactions;
        assert!((reactions[6] + 2.0).abs() < 1e-13, "{push} {reactions}");
        assert!((reactions.rows(0, 3).sum() - 3.0).abs() < 1e-13, "{push} {reactions}");
        assert!((reactions[2] - reactions[0]).abs() < 1e-13 && !found.solution.unique, "{push}");
        let along = if slides { push - 1.5 } else { 0.0 };
        let a = DVector::from_row_slice(&[along, 0.0, 0.0, 0.0]);
        assert!((&found.solution.accelerations - a).amax() < 1e-13, "{push}");
        assert_eq!(found.modes, [if slides { FORWARD } else { ContactMode::Stick }; 3]);
    }
}
