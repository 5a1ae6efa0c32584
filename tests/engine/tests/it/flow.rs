//! Motions without events, by series and by projected steps.

use liftoff::{FlowError, flow};
use liftoff_core::model::BarSystem;
use liftoff_fixtures::{DoublePendulum, QuickReturn, SpringPendulum};

/// φ = ω t and tan ψ = (h + r sin φ)/(r cos φ), with joints: projected.
#[test]
fn a_loop_flows() {
    let model = QuickReturn { a: 1.0, b: 1.0, r: 1.0, l: 4.0, h: 2.0, omega: 1.0 };
    let psi = |t: f64| (2.0 + t.sin()).atan2(t.cos());
    let rate = (psi(1e-6) - psi(-1e-6)) / 2e-6;
    let end = flow(&model, &[0.0, psi(0.0), 1.0, rate, 0.0], 1.0, 1e-10).unwrap();
    assert!(
        (end[0] - 1.0).abs() < 1e-8 && (end[1] - psi(1.0)).abs() < 1e-8 && (end[4] - 1.0).abs() < 1e-12,
        "{end:?}"
    );
}

/// Of every kind that has a closed form the energy stays: by series, and where a root has a kink by
/// steps.
#[test]
fn the_energy_stays() {
    fn check<M: BarSystem>(model: &M, state: M::State<f64>) {
        let energy = |state: &M::State<f64>| {
            let energy = M::energy(&model.constants::<f64>(), state);
            energy.kinetic + energy.potential
        };
        let end = flow(model, &state, 3.0, 1e-11).unwrap();
        let moved = state.as_ref().iter().zip(end.as_ref()).any(|(a, b)| (a - b).abs() > 0.1);
        assert!(moved && (energy(&end) - energy(&state)).abs() < 1e-8, "{:?}", end.as_ref());
    }
    check(&DoublePendulum { m: 1.0, l: 1.0, g: 9.81 }, [1.0, -0.5, 0.0, 2.0]);
    check(&SpringPendulum { m: 1.0, k: 10.0, l: 1.0, c: 0.0, g: 9.81 }, [0.3, 1.0, 0.0, 0.5]);
}

#[test]
fn a_tolerance_that_is_none_is_reported() {
    let model = QuickReturn { a: 1.0, b: 1.0, r: 1.0, l: 4.0, h: 2.0, omega: 1.0 };
    let told = flow(&model, &[0.0, 1.0, 1.0, 0.0, 0.0], 1.0, -1.0);
    assert!(matches!(told, Err(FlowError::Tolerance(_))), "{told:?}");
}
