//! Parts that friction connects, and contacts that are given an impulse.

use nalgebra::{DMatrix, DVector};

use super::super::decision::FrictionError;
use super::super::modes::{
    Bound, ContactMode, Frictional, ImpulseBounds, ModeCondition, SlipDirection, SlipVelocity,
};
use super::super::problem::FrictionProblem;
use super::closed_forms::solve;
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;

/// Of three blocks that do not touch each other the normal and the tangent of one are of one part,
/// and known as well as the larger of both loads; what is of others stays as it is.
#[test]
fn friction_joins_the_parts_of_a_contact() {
    let n = 6;
    // x and y of each block; the normals, then the tangents.
    let jacobian = DMatrix::from_fn(6, n, |row, j| {
        let column = if row < 3 { 2 * row + 1 } else { 2 * (row - 3) };
        if j == column { 1.0 } else { 0.0 }
    });
    for (across, down) in [(3.0, 1e6), (1e6, 3.0)] {
        let force = DVector::from_row_slice(&[across, down, 5.0, 7.0, across, down]);
        let bias = DVector::zeros(6);
        let new =
            || EquilibratedKkt::new(&DMatrix::identity(n, n), &jacobian, (&force, &bias), (&force, &bias));
        let (before, mut kkt) = (new(), new());
        kkt.couple(
            &[0, 2].map(|block| Frictional::touching((block, 3 + block), (0.5, 0.5), SlipVelocity::Rest)),
        );
        let entries = |block: usize| [2 * block, 2 * block + 1, n + block, n + 3 + block];
        for block in [0, 2] {
            let own = entries(block).map(|i| kkt.parts[i]);
            assert!(own.iter().all(|part| *part == own[0]), "{own:?}");
            let known = entries(block).map(|i| kkt.tolerance[i] / (1e-12 * 1e6));
            assert!(known.iter().all(|it| (it - 1.0).abs() < 1e-14), "{known:?}");
        }
        for i in entries(1) {
            assert_eq!((kkt.parts[i], kkt.tolerance[i]), (before.parts[i], before.tolerance[i]));
        }
        let parts: Vec<usize> = [0, 2, 3, 4].map(|i| kkt.parts[i]).to_vec();
        assert!((0..4).all(|i| (0..i).all(|j| parts[i] != parts[j])), "{parts:?}");
    }
}

/// A block of unit mass that is given an impulse, with friction up to ½ λ + 0.3, and only that of
/// 0.3 where it is given no more: the modes that it is in, and what they meet with zero.
#[test]
fn contacts_that_are_given_an_impulse_have_their_modes() {
    use ModeCondition::{Above, Below, Opens, Presses, Slips};
    let (forward, backward) = (Some(SlipDirection::Forward), Some(SlipDirection::Backward));
    let slide = |sense: Option<SlipDirection>| ContactMode::Slide(sense.unwrap());
    let modes = |push: f64, load: f64| {
        let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
        let bound = Bound { slope: 0.5, offset: 0.3 };
        let contact = Frictional::given((0, 1), ImpulseBounds { forward: bound, backward: bound });
        let found = solve(&[1.0, 1.0], &jacobian, (&[push, -load], &[0.0; 2]), &[contact]).unwrap();
        let most = 0.5 * load.max(0.0) + 0.3;
        let slips = push - push.clamp(-most, most);
        assert!((found.solution.accelerations[0] - slips).abs() < 1e-14, "{push} {load}");
        assert!((found.solution.accelerations[1] - (-load).max(0.0)).abs() < 1e-14, "{push} {load}");
        let left = &found.next[0].choices;
        left.iter().map(|it| (it.mode, it.conditions.to_vec())).collect::<Vec<_>>()
    };
    for (push, load, expected) in [
        (0.2, 1.0, vec![(ContactMode::Stick, vec![])]),
        (-0.79, 1.0, vec![(ContactMode::Stick, vec![])]),
        (1.0, 1.0, vec![(slide(forward), vec![])]),
        (-1.0, 1.0, vec![(slide(backward), vec![])]),
        (0.8, 1.0, vec![(ContactMode::Stick, vec![Above]), (slide(forward), vec![Slips])]),
        (-0.8, 1.0, vec![(ContactMode::Stick, vec![Below]), (slide(backward), vec![Slips])]),
        (0.2, -1.0, vec![(ContactMode::Part(None), vec![])]),
        (0.5, -1.0, vec![(ContactMode::Part(forward), vec![])]),
        (-0.5, -1.0, vec![(ContactMode::Part(backward), vec![])]),
        (0.3, -1.0, vec![(ContactMode::Part(None), vec![Above]), (ContactMode::Part(forward), vec![Slips])]),
        (
            -0.3,
            -1.0,
            vec![(ContactMode::Part(None), vec![Below]), (ContactMode::Part(backward), vec![Slips])],
        ),
        (0.2, 0.0, vec![(ContactMode::Stick, vec![Presses]), (ContactMode::Part(None), vec![Opens])]),
        (0.5, 0.0, vec![(slide(forward), vec![Presses]), (ContactMode::Part(forward), vec![Opens])]),
        (-0.5, 0.0, vec![(slide(backward), vec![Presses]), (ContactMode::Part(backward), vec![Opens])]),
    ] {
        assert_eq!(modes(push, load), expected, "{push} {load}");
    }
}

/// What moves changes its velocities by more than 1e-8 of the terms that its forces are summed
/// from.
#[test]
fn what_is_moved_is_moved_beyond_rounding() {
    let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]);
    for unit in [1e-12, 1.0, 1e12] {
        for (part, moves) in
            [(0.0, false), (0.9e-8, false), (-0.9e-8, false), (1.1e-8, true), (-1.1e-8, true)]
        {
            let force = DVector::from_row_slice(&[0.0, 1.0]) * (part * unit);
            let (size, bias) = (DVector::repeat(2, unit), DVector::zeros(2));
            // It rises, or falls beside a contact that is open.
            let contact = Frictional::decided((0, 1), (0.5, 0.5), ContactMode::Open);
            let mut kkt =
                EquilibratedKkt::new(&DMatrix::identity(2, 2), &jacobian, (&force, &bias), (&size, &bias));
            let found =
                kkt.moved_with_friction(&FrictionProblem { rows: LcpRows::default(), contacts: &[contact] });
            assert_eq!(
                found.as_ref().err(),
                (!moves).then_some(&FrictionError::Inconsistent),
                "{unit} {part}"
            );
        }
    }
}
