//! Complementarity against its conditions: for W positive definite they have one solution, so
//! meeting them is enough. The degenerate cases on an A-frame with its feet on the floor, whose
//! reaction is known: N/mg = ¼ − (3/2) s S + (9/4) s² per foot, S = s₀ + l φ̇₀²/3g.

mod balanced;
mod couples;
mod dependent;
mod laws;
mod least_constraint;
mod lifted;
mod massless;
mod rough;
pub(super) mod shared;

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

use super::complementarity::{LcpRows, Solution};
use super::equilibrated_kkt::EquilibratedKkt;
use super::trials::LcpError;
use super::{ContactProblem, ContactSolution, decide};
use crate::model::ContactSet;
use crate::system::Model;

use liftoff_fixtures::{AFrame, RodOnSupports};

fn solve(
    mass: &DMatrix<f64>,
    jacobian: &DMatrix<f64>,
    force: &[f64],
    bias: &[f64],
) -> Result<Solution, LcpError> {
    let (force, bias) = (DVector::from_row_slice(force), DVector::from_row_slice(bias));
    let candidates: Vec<usize> = (0..jacobian.nrows()).collect();
    EquilibratedKkt::new(mass, jacobian, (&force, &bias), (&force.abs(), &bias.abs()))
        .solve(&LcpRows { candidates: &candidates, ..LcpRows::default() })
}

fn entries(count: usize) -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(-1.0..1.0f64, count)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn meets_the_conditions(
        root in entries(25), jacobian in entries(20), force in entries(5), bias in entries(4), heavy in -6.0..6.0f64,
    ) {
        let root = DMatrix::from_row_slice(5, 5, &root);
        let mass = (&root * root.transpose() + DMatrix::identity(5, 5)) * 10f64.powf(heavy);
        let jacobian = DMatrix::from_row_slice(4, 5, &jacobian);
        let inverse = mass.clone().try_inverse().unwrap();
        let delassus = &jacobian * &inverse * jacobian.transpose();
        let eigenvalues = delassus.clone().symmetric_eigenvalues();
        prop_assume!(eigenvalues.min() > 1e-6 * eigenvalues.max());

        let found = solve(&mass, &jacobian, &force, &bias).unwrap();
        let free = &jacobian * inverse * DVector::from_vec(force) + DVector::from_vec(bias);
        let opening = delassus * &found.reactions + &free;
        // The condition bound above times the unit roundoff.
        let small = 1e-9 * free.amax().max(1e-3);
        for i in 0..4 {
            prop_assert!(opening[i] > -small && found.reactions[i] >= -small / eigenvalues.min());
            prop_assert!(opening[i].abs() < small || found.reactions[i] == 0.0);
        }
        prop_assert!(found.unique);
    }
}

#[test]
fn jammed() {
    let jacobian = DMatrix::from_row_slice(2, 1, &[1.0, -1.0]);
    assert_eq!(
        solve(&DMatrix::identity(1, 1), &jacobian, &[0.0], &[-1.0, -0.5]).unwrap_err(),
        LcpError::Jammed
    );
}

/// Numbers that cannot be told from a singular system are not called jammed.
#[test]
fn only_redundant_contacts_jam() {
    let mass = DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 1.0, 1.0]);
    let jacobian = DMatrix::from_row_slice(1, 2, &[1.0, 1.0]);
    assert_eq!(solve(&mass, &jacobian, &[0.0, 1.0], &[-1.0]).unwrap_err(), LcpError::Singular);
}

/// A rod of unit mass on `feet` supports, its centre of mass at c from the first, weight 1.
fn plank(feet: &[f64], c: f64) -> (EquilibratedKkt, Vec<usize>) {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0 / 3.0]));
    let jacobian = DMatrix::from_fn(feet.len(), 2, |foot, j| if j == 0 { 1.0 } else { feet[foot] - c });
    let (force, bias) = (DVector::from_row_slice(&[-1.0, 0.0]), DVector::zeros(feet.len()));
    let problem = EquilibratedKkt::new(&mass, &jacobian, (&force, &bias), (&force.abs(), &bias));
    (problem, (0..feet.len()).collect())
}

/// Catalogue 15: a rod on supports at −1, 0, 1; its weight may be shared in many ways, least norm
/// is a third each.
#[test]
fn redundant_supports_share_least_norm() {
    let (problem, candidates) = plank(&[-1.0, 0.0, 1.0], 0.0);
    let found = problem.solve(&LcpRows { candidates: &candidates, ..LcpRows::default() }).unwrap();
    assert!(!found.unique);
    assert!(found.accelerations.amax() < 1e-14);
    let shared = problem.share(&found, &|_| true);
    assert!((shared - DVector::from_element(3, 1.0 / 3.0)).amax() < 1e-14);
}

/// Least norm of λ ≥ 0 with Σ λ = 1, Σ λ x = c: λ = (α + β x)₊. Of feet at 0, 1, 2 under c = 1.8
/// the first bears nothing, the others 0.2 and 0.8. Two contacts at most bear in the basis,
/// whatever their number.
#[test]
fn an_eccentric_load_leaves_far_feet_without_reaction() {
    for (count, c) in [(3, 1.8), (18, 1.8), (18, 16.3), (200, 1.0 / 7.0), (200, 160.25)] {
        let feet: Vec<f64> = (0..count).map(f64::from).collect();
        let (problem, candidates) = plank(&feet, c);
        let found = problem.solve(&LcpRows { candidates: &candidates, ..LcpRows::default() }).unwrap();
        assert!(found.accelerations.amax() < 1e-12 && !found.unique && found.active_basis.len() <= 2);
        assert_eq!(found.active_basis.len() + found.degenerate.len(), feet.len());
        let shared = problem.share(&found, &|_| true);
        let moment: f64 = shared.iter().zip(&feet).map(|(share, x)| share * (x - c)).sum();
        assert!((shared.sum() - 1.0).abs() < 1e-11 && moment.abs() < 1e-9, "{} {moment:e}", shared.sum());
        // α + β x from two feet that bear, to be (·)₊ of all.
        let bearing: Vec<usize> = (0..feet.len()).filter(|&foot| shared[foot] > 0.0).collect();
        let [first, last] = [bearing[0], bearing[bearing.len() - 1]];
        let slope = (shared[last] - shared[first]) / (feet[last] - feet[first]);
        let line = |foot: usize| (shared[first] + slope * (feet[foot] - feet[first])).max(0.0);
        assert!((0..feet.len()).all(|foot| (shared[foot] - line(foot)).abs() < 1e-12), "{shared}");
    }
    let (problem, candidates) = plank(&[0.0, 1.0, 2.0], 1.8);
    let found = problem.solve(&LcpRows { candidates: &candidates, ..LcpRows::default() }).unwrap();
    let shared = problem.share(&found, &|_| true);
    assert!((shared - DVector::from_row_slice(&[0.0, 0.2, 0.8])).amax() < 1e-14);
}

/// The same plank by its first end: φ, x, y, so that M couples them.
#[test]
fn a_plank_described_by_its_end() {
    let (m, c, g, inertia) = (1.0, 1.8, 9.81, 1.0);
    for count in [3, 4, 18] {
        let mass =
            DMatrix::from_row_slice(3, 3, &[inertia + m * c * c, 0.0, m * c, 0.0, m, 0.0, m * c, 0.0, m]);
        let jacobian = DMatrix::from_fn(count, 3, |foot, j| [foot as f64, 0.0, 1.0][j]);
        let found = solve(&mass, &jacobian, &[-m * g * c, 0.0, -m * g], &vec![0.0; count]).unwrap();
        assert!(found.accelerations.amax() < 1e-12 && found.active_basis.len() == 2);
    }
}

/// Two balls of which one is 10¹² times as heavy: the light one's contact is decided by its own
/// forces.
#[test]
fn independent_parts_have_their_own_scales() {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1e12, 1e-12]));
    let jacobian = DMatrix::identity(2, 2);
    let found = solve(&mass, &jacobian, &[-1e25, -1e-13], &[0.0; 2]).unwrap();
    assert_eq!(found.active_basis, [0, 1]);
    assert_eq!(solve(&mass, &jacobian, &[-1e25, 1e-13], &[0.0; 2]).unwrap().active_basis, [0]);
}

/// A light bar's coordinate without any mass, driven by a constraint alone.
#[test]
fn massless_rows_are_solved_where_constrained() {
    let mass = DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 0.0]);
    let tied = DMatrix::from_row_slice(1, 2, &[1.0, -1.0]);
    let found = solve(&mass, &tied, &[-1.0, 0.5], &[-0.25]).unwrap();
    assert_eq!(found.active_basis, [0]);
    // Row 2 of M a = f + Jᵀ λ: 0 = 0.5 − λ.
    assert!((found.reactions[0] - 0.5).abs() < 1e-14);
    assert!((found.accelerations[0] + 0.25).abs() < 1e-14);
    let loose = DMatrix::from_row_slice(1, 2, &[1.0, 0.0]);
    assert_eq!(solve(&mass, &loose, &[-1.0, 0.5], &[0.0]).unwrap_err(), LcpError::Singular);
}

/// Both reactions come out negative with both contacts closed, yet only one opens (rule 2).
#[test]
fn opening_set_is_not_the_set_of_negative_reactions() {
    // W = [1, −0.9; −0.9, 1] and b = −W (−1, −0.5).
    let jacobian = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, -0.9, 0.19f64.sqrt()]);
    let found = solve(&DMatrix::identity(2, 2), &jacobian, &[0.0, 0.0], &[0.55, -0.4]).unwrap();
    assert_eq!(found.active_basis, [1]);
    assert!((found.reactions[1] - 0.4).abs() < 1e-14);
}

/// The A-frame falling with φ̇ < 0 at sin φ = s on the level S.
fn a_frame(s: f64, sum: f64, unloaded: bool) -> ContactSolution {
    let frame = AFrame { m: 1.0, l: 1.0, g: 1.0 };
    let c = (1.0 - s * s).sqrt();
    let rate = -(3.0 * (sum - s)).sqrt();
    let touching = ContactSet::EMPTY.with(0);
    let unloaded = if unloaded { touching } else { ContactSet::EMPTY };
    let question = ContactProblem { touching, unloaded, ..ContactProblem::default() };
    decide(&Model::new(&frame), &[s.asin(), s, rate, c * rate], &question).unwrap()
}

#[test]
fn a_vanished_reaction_opens_or_not_by_its_rate() {
    let reaction = |s: f64, sum: f64| 2.0 * (0.25 - 1.5 * s * sum + 2.25 * s * s);
    let bearing = a_frame(0.9, 0.95, false);
    assert_eq!(bearing.closed, ContactSet::from_bits(1));
    assert!((bearing.reactions[0] - reaction(0.9, 0.95)).abs() < 1e-14);
    assert_eq!(a_frame(0.4, 1.05, false).closed, ContactSet::EMPTY, "N < 0");

    let sum = 1.01f64;
    let root = (sum * sum - 1.0).sqrt();
    // As s falls the reaction falls through the upper root and rises through the lower one.
    assert_eq!(a_frame((sum + root) / 3.0, sum, true).closed, ContactSet::EMPTY);
    assert_eq!(a_frame((sum - root) / 3.0, sum, true).closed, ContactSet::from_bits(1));
    // λ = λ̇ = 0 < λ̈ at s = ⅓ for S = 1; the state is right to rounding and so is λ̇.
    let touch = a_frame(1.0 / 3.0, 1.0, true);
    assert_eq!((touch.closed, touch.reactions[0]), (ContactSet::from_bits(1), 0.0));
}

#[test]
fn redundant_reactions_are_marked() {
    let rod = RodOnSupports { m: 1.0, l: 1.0, g: 1.0 };
    let question = ContactProblem { touching: ContactSet::from_bits(0b111), ..ContactProblem::default() };
    let found = decide(&Model::new(&rod), &[0.0; 6], &question).unwrap();
    assert_eq!((found.closed, found.unique), (ContactSet::from_bits(0b111), false));
    let held = ContactProblem {
        touching: ContactSet::from_bits(0b001),
        held: ContactSet::from_bits(0b001),
        ..ContactProblem::default()
    };
    let found = decide(&Model::new(&rod), &[0.0; 6], &held).unwrap();
    assert!(found.unique && (found.reactions[0] - 0.25).abs() < 1e-14);
}

/// A level rod on its middle and one end: the end bears nothing, now and later. A turn that is
/// rounding does not lift it.
#[test]
fn rounding_of_a_state_at_rest_opens_nothing() {
    let rod = RodOnSupports { m: 1.0, l: 1.0, g: 8.127 };
    let question = ContactProblem {
        touching: ContactSet::from_bits(0b011),
        time: Some(0.35),
        ..ContactProblem::default()
    };
    for turn in [0.0, 2.9e-17, -2.9e-17] {
        for rate in [0.0, 6.8e-49, -6.8e-49, 1e-17, -1e-17] {
            let mut state = [0.0; 6];
            (state[0], state[3]) = (turn, rate);
            let found = decide(&Model::new(&rod), &state, &question).unwrap();
            assert_eq!(found.closed, question.touching, "{turn} {rate}");
            assert!(found.reactions[0].abs() < 1e-14, "{turn} {rate}: {:?}", found.reactions);
        }
    }
}

/// A joint that cannot move, as that of a thread whose ends meet, bears anything; what a contact
/// bears is known all the same.
#[test]
fn a_row_without_entries_leaves_its_reaction_open() {
    let (jacobian, bias) = (DMatrix::from_row_slice(2, 1, &[0.0, 1.0]), DVector::zeros(2));
    let force = DVector::from_element(1, -2.0);
    let problem =
        EquilibratedKkt::new(&DMatrix::identity(1, 1), &jacobian, (&force, &bias), (&force.abs(), &bias));
    let found = problem.solve(&LcpRows { fixed: &[0], candidates: &[1], ..LcpRows::default() }).unwrap();
    assert_eq!((found.active_basis, found.unique), (vec![1], false));
    assert!((found.reactions - DVector::from_row_slice(&[0.0, 2.0])).amax() < 1e-14);
}
