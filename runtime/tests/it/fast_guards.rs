//! Guards that turn often within one step, or in a small part of it.

use crate::common::double_pendulum::DoublePendulum;
use liftoff::prelude::*;

/// When a condition ends a run of the pendulum from a = 1 at rest, and a then. a falls from 1 through zero.
fn end(condition: &str) -> [f64; 2] {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    let start = Pose::at("a", 1.0).with("b", 1.0);
    let run = Simulation::new(&model).unwrap().start(start).unwrap().limit(3.0);
    let run = run.until(condition).unwrap().run().unwrap();
    let a = Output::parse::<DoublePendulum>("a").unwrap();
    [run.end_time(), run.value(&a, run.end_time())]
}

/// The bound of a condition is 1e-12 of its sides (the default tolerance), the time of a root that over its rate.
#[test]
fn the_first_of_many_roots() {
    for omega in [300.0, 1000.0] {
        let [t, _] = end(&format!("sin({omega}*t)=0.5"));
        assert!((t - 0.5f64.asin() / omega).abs() < 1e-11 / omega, "{omega}: {t}");
    }
}

#[test]
fn a_part_of_a_step_in_which_a_condition_holds() {
    for (omega, height) in [(300.0, 0.99), (1000.0, 0.99999)] {
        let [t, _] = end(&format!("sin({omega}*t)>{height}"));
        // The rate is ω cos: 4.5e-3 ω at the lesser.
        assert!((t - f64::asin(height) / omega).abs() < 1e-9 / omega, "{omega}: {t}");
    }
}
