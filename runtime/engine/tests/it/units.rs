//! The same scene in other units.

use liftoff::method::{Dop853, Method, Radau};
use liftoff::prelude::*;
use liftoff_fixtures::StruckChain;

/// θ of the first bar at ten times the time l m/p behind an impulse p that strikes the chain at rest after as long a time; lengths
/// in l, masses in m, times in `unit`.
fn turned(method: impl Method, [m, unit]: [f64; 2]) -> f64 {
    let simulation = Simulation::new(&StruckChain { m, l: 1.0 }).unwrap().method(method).tolerance(1e-9);
    let struck =
        simulation.start(Pose::nominal()).unwrap().impulse("C", [0.0, m / unit], 10.0 * unit).unwrap();
    struck.limit(20.0 * unit).run().unwrap().final_state()[0]
}

#[test]
fn an_impulse_tells_the_time_of_what_rests_without_gravity() {
    let expected = turned(Dop853, [1.0, 1.0]);
    assert!(expected.abs() > 1.0, "{expected}");
    for exponent in [-60, -30, 30, 60] {
        let units = [f64::powi(2.0, 31), f64::powi(2.0, exponent)];
        assert!((turned(Dop853, units) - expected).abs() < 1e-9, "2^{exponent}");
        assert!((turned(Radau, units) - expected).abs() < 1e-6, "2^{exponent}");
    }
}
