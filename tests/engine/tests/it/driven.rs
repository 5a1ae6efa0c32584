//! Drives far from natural units.

use liftoff::prelude::*;
use liftoff_fixtures::QuickReturn;

/// The completed rates satisfy the drive up to a rounding of its own rate; tan ψ = (h + r sin φ)/(r cos φ).
#[test]
fn a_start_fits_a_drive_of_any_rate_and_size() {
    for (omega, size) in [(1.0, 1.0), (1e6, 1.0), (1.0, 1e-6), (1e6, 1e-6)] {
        let model = QuickReturn { a: 1.0, b: 1.0, r: size, l: 4.0 * size, h: 2.0 * size, omega };
        let run = Simulation::new(&model).unwrap().limit(1.0 / omega).run().unwrap();
        let psi = run.value(&run.output("psi").unwrap(), 1.0 / omega);
        let exact = (2.0 + 1f64.sin()).atan2(1f64.cos());
        assert!((psi - exact).abs() < 1e-9, "{omega} {size} {psi} {exact}");
    }
}
