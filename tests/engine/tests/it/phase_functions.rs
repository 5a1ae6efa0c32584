//! The equations of a phase called without the integrator.

use liftoff::prelude::*;
use liftoff_fixtures::FallingPair;
use liftoff_fixtures::Ladder;

/// Fig. 1a, m = l = g = 1: the force is sec²φ − cos φ = (3/2) φ² + O(φ⁴), its digits kept as φ → 0.
#[test]
fn force_keeps_its_digits() {
    let phase = FallingPair { m: 1.0, l: 1.0, g: 1.0 }.phase(&["P", "Q"]).unwrap();
    assert_eq!((phase.form(), phase.kept()), (Form::Reduced, vec![0]));
    for k in 1..=12 {
        let phi = 10f64.powi(-k);
        let state = [phi, -0.5 * phi.tan(), 0.0, 0.0];
        let half = (0.5 * phi).sin();
        let vers = 2.0 * half * half;
        let c = phi.cos();
        let force = vers * (1.0 + c + c * c) / (c * c);
        assert!((phase.forces(&state)[0] / force - 1.0).abs() < 1e-13, "{phi:e}");
        assert!(
            (phase.accelerations(&state)[0] / phase.reduced_accelerations(&state)[0] - 1.0).abs() < 1e-15
        );
        assert!((phase.energy(&state).potential / -(phi.tan() * vers) - 1.0).abs() < 1e-13);
    }
    // T = (1/4)(4/3 + sec⁴φ − 2 sec φ) φ̇².
    let inertia = phase.mass_matrix(&[0.7, -0.5 * 0.7f64.tan(), 0.0, 0.0])[0][0];
    let sec = 1.0 / 0.7f64.cos();
    assert!((inertia - 0.5 * (4.0 / 3.0 + sec.powi(4) - 2.0 * sec)).abs() < 1e-14);
}

/// Both forms solve the same equations.
#[test]
fn closed_and_projected_agree() {
    let pair = FallingPair { m: 2.0, l: 0.5, g: 9.81 };
    let phi = 0.6f64;
    let (y, u) = (-0.25 * phi.tan(), 1.7);
    let state = [phi, y, u, -0.25 * u / phi.cos().powi(2)];
    let (closed, projected) = (pair.phase(&["P"]).unwrap(), pair.projected_phase(&["Q"]).unwrap());
    for (a, b) in closed.accelerations(&state).iter().zip(projected.accelerations(&state)) {
        assert!((a - b).abs() < 1e-13 * a.abs());
    }
    let (a, b) = (closed.reactions(&state)[0], projected.reactions(&state)[0]);
    assert!((a - b).abs() < 1e-13 * a.abs());
}

/// A ladder against wall and floor is a pendulum: θ̈ = −(3g/2l) cos θ.
#[test]
fn ladder_on_both_contacts() {
    let ladder = Ladder { m: 3.0, l: 2.0, g: 9.81 };
    let (s, c) = 1f64.sin_cos();
    let phases = [ladder.phase(&["A", "B"]).unwrap(), ladder.projected_phase(&["A", "B"]).unwrap()];
    assert_eq!(phases.each_ref().map(|phase| phase.form()), [Form::Reduced, Form::Multipliers]);
    for phase in phases {
        let accelerations = phase.accelerations(&[1.0, c, s, 0.0, 0.0, 0.0]);
        assert!((accelerations[0] + 0.75 * 9.81 * c).abs() < 1e-14);
        assert!(phase.accelerations(&[]).iter().all(|a| a.is_nan()));
    }
    assert!(ladder.phase(&["C"]).is_err());
}
