//! What is told apart from rounding, and what is not determined.

use std::f64::consts::PI;

use nalgebra::DMatrix;

use super::super::decision::{FrictionError, Reason};
use super::super::modes::{ContactMode, Frictional, ModeCondition, SlipDirection, SlipVelocity};
use super::super::problem::RowEquations;
use super::closed_forms::solve;
use super::random::Random;

const FORWARD: ContactMode = ContactMode::Slide(SlipDirection::Forward);
const BACKWARD: ContactMode = ContactMode::Slide(SlipDirection::Backward);

/// A contact of which the tangent moves by a part ε of the block, on a support that is accelerated
/// by c: v = ε (ẋ − c t), and the push across is ε R. It is carried along up to ε μ N, however
/// small ε is.
#[test]
fn a_weak_tangent_rubs_as_much_as_it_moves() {
    let (mu, normal) = (0.5, 2.0);
    for weak in [1.0, 1e-2, 1e-3, 1e-5, -1e-5] {
        let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, weak, 0.0]);
        let most = f64::abs(weak) * mu * normal;
        let slides = if weak > 0.0 { FORWARD } else { BACKWARD };
        for (part, mode) in [(0.8, ContactMode::Stick), (-0.8, ContactMode::Stick), (1.2, slides)] {
            for carried in [0.0, 0.1 * most, -0.1 * most] {
                let contact = Frictional::touching((0, 1), (mu, mu), SlipVelocity::Rest);
                let (force, bias) = ([part * most, -normal], [0.0, -weak * carried]);
                let found = solve(&[1.0, 1.0], &jacobian, (&force, &bias), &[contact]).unwrap();
                assert_eq!(found.modes[0], mode, "{weak} {part} {carried}");
                let a = if mode == ContactMode::Stick { carried } else { (part - 1.0) * most };
                let bears = (a - part * most) / weak;
                let apart = (found.solution.accelerations[0] - a).abs();
                assert!(apart < 1e-12 * most, "{weak} {part} {carried}");
                assert!((found.solution.reactions[1] - bears).abs() < 1e-12, "{weak} {part} {carried}");
            }
        }
    }
}

/// What no mass resists and no contact holds has no accelerations, unless a slip may be what leaves
/// them open.
#[test]
fn accelerations_without_mass_are_not_determined() {
    let jacobian = DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 1.0, 0.0, 0.0]);
    let found = |push: f64| {
        let contact = Frictional::touching((0, 1), (0.5, 0.5), SlipVelocity::Rest);
        solve(&[1.0, 1.0, 0.0], &jacobian, (&[push, -1.0, 0.0], &[0.0; 2]), &[contact])
    };
    assert_eq!(found(0.3).unwrap_err(), FrictionError::Singular);
    assert!(!found(0.7).unwrap().determined);
}

/// N of a block is known no better than its weight, which acts beside an inertia force nearly as
/// large; so is the friction that it bears, however small the push across is.
#[test]
fn friction_is_known_as_well_as_the_load_that_presses() {
    let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
    let at_limit = [(ContactMode::Stick, vec![ModeCondition::Above]), (FORWARD, vec![ModeCondition::Slips])];
    for (more, left) in
        [(1e-9, at_limit.to_vec()), (1e-7, at_limit.to_vec()), (1e-5, vec![(ContactMode::Stick, vec![])])]
    {
        let contact = Frictional::touching((0, 1), (1.0, 1.0), SlipVelocity::Rest);
        // N = 1e6 − (1e6 − 1 − more) against a push of one.
        let bias = [1e6 - 1.0 - more, 0.0];
        let found = solve(&[1.0, 1.0], &jacobian, (&[1.0, -1e6], &bias), &[contact]).unwrap();
        let told: Vec<_> = found.next[0].choices.iter().map(|it| (it.mode, it.conditions.to_vec())).collect();
        assert_eq!(told, left, "{more}");
    }
}

/// Many equations of which a third depend on the others: x₀ + z with A z = 0 has the same
/// right-hand side as x₀ = Aᵀ y, the shortest.
#[test]
fn the_shortest_solution_of_many_singular_equations() {
    let mut random = Random(0xCBBB_9D5D_C105_9ED8);
    for size in [3, 30, 90] {
        let rank = 2 * size / 3;
        let mut part = |rows, columns| DMatrix::from_fn(rows, columns, |_, _| random.between(-1.0, 1.0));
        let matrix = part(size, rank) * part(rank, size);
        let shortest = matrix.tr_mul(&part(size, 1).column(0));
        let right = &matrix * &shortest;
        let equations = RowEquations { index: (0..size).collect(), matrix, right };
        assert!(equations.solve().is_none());
        let (x, determined) = equations.least_norm(&equations.right, 1).unwrap();
        assert!((&x - &shortest).amax() <= 1e-8 * shortest.amax(), "{size} {:e}", (&x - &shortest).amax());
        assert!(!determined, "{size}");
    }
}

/// Two guides in one place hold a push that is more than μ times their load by pressing against
/// each other, either of them up: that is one motion, and to slide another.
#[test]
fn guides_that_share_a_load_have_one_motion() {
    let rows = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let jacobian = DMatrix::from_fn(4, 3, |row, j| rows[row % 2][j]);
    let guide = |k: usize| Frictional::guide((2 * k, 2 * k + 1), (0.5, 0.5), SlipVelocity::Rest);
    let force = [0.9, -1.0, 1.0];
    let found = solve(&[1.0; 3], &jacobian, (&force, &[0.0; 4]), &[guide(0), guide(1)]).unwrap();
    assert_eq!((found.solutions.len(), found.reason), (2, Reason::Sticks), "{:?}", found.solutions);
    let a = &found.solution.accelerations;
    assert!(a[0].abs() < 1e-14 && a[1].abs() < 1e-14 && (a[2] - 1.0).abs() < 1e-14);
}

/// A rod slides in Painlevé's region, where it may open or be pressed on by a reaction that no
/// stiff contact holds; a block beside it, much heavier or lighter, slides on. The rod opens as it
/// does alone.
#[test]
fn a_heavy_block_beside_a_rod_does_not_hold_it() {
    let (sine, cosine) = (PI / 3.0).sin_cos();
    for heavy in [1e-13, 1.0, 1e13] {
        let jacobian = DMatrix::from_row_slice(
            4,
            5,
            &[
                [0.0, 1.0, -0.5 * cosine, 0.0, 0.0],
                [1.0, 0.0, 0.5 * sine, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, 0.0, 1.0, 0.0],
            ]
            .concat(),
        );
        let contacts =
            [0, 2].map(|row| Frictional::touching((row, row + 1), (2.0, 2.0), SlipVelocity::Backward));
        let force = [0.0, -1.0, 0.0, 0.0, -heavy];
        let bias = [2.0 * sine, 2.0 * cosine, 0.0, 0.0];
        let found =
            solve(&[1.0, 1.0, 1.0 / 12.0, heavy, heavy], &jacobian, (&force, &bias), &contacts).unwrap();
        assert_eq!(
            (found.modes.as_slice(), found.reason),
            ([ContactMode::Open, BACKWARD].as_slice(), Reason::Stable)
        );
        assert_eq!(found.solutions.len(), 2);
    }
}
