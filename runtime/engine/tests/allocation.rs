//! Stepping allocates nothing: a run ten times as long allocates as often. What steps write is kept
//! on each thread for the next run, which is not to be noticed.

use allocation_counter::measure;
use liftoff::method::{Auto, Dop853, Gauss, Method, Radau, Taylor, Tsit5};
use liftoff::prelude::*;
use liftoff_fixtures::DoublePendulum;
use liftoff_fixtures::FallingPair;

/// Allocations and steps of a run that records nothing, up to a time.
fn run(simulation: Simulation, limit: f64) -> (u64, u64) {
    let simulation = simulation.limit(limit);
    let mut steps = 0;
    let counted = measure(|| steps = simulation.observe(&mut ()).unwrap().statistics().steps);
    (counted.count_total, steps)
}

fn check(method: impl Method + Copy) {
    let pendulum = || {
        let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
        let start = Pose::new("a", 2.0).with("b", 1.0);
        Simulation::new(&model).unwrap().tolerance(1e-9).method(method).start(start).unwrap()
    };
    // With a reaction and the ends of a bar watched, before anything happens.
    let pair = || {
        let model = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
        let start = Pose::new("phi", 0.001);
        Simulation::new(&model).unwrap().tolerance(1e-9).method(method).start(start).unwrap()
    };
    // What steps write is allocated once on each thread, and kept for the next run.
    run(pendulum(), 1.0);
    run(pair(), 1.0);
    for (short, long) in [(run(pendulum(), 1.0), run(pendulum(), 10.0)), (run(pair(), 1.0), run(pair(), 7.0))]
    {
        assert_eq!(short.0, long.0, "{}", method.name());
        assert!(long.1 > short.1 + 3, "{}: {} steps, {}", method.name(), short.1, long.1);
    }
}

#[test]
fn steps_allocate_nothing() {
    check(Auto);
    check(Dop853);
    check(Tsit5);
    check(Taylor);
    check(Radau);
    check(Gauss);
}

/// By no bit does a run depend on those before it on its thread, of other tolerances and orders.
#[test]
fn no_run_depends_on_those_before() {
    let end = |tolerance: f64, k: usize| -> Vec<u64> {
        let simulation = if k.is_multiple_of(2) {
            let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
            Simulation::new(&model).unwrap().start(Pose::new("a", 2.0).with("b", 1.0)).unwrap().limit(3.0)
        } else {
            let model = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
            Simulation::new(&model).unwrap().start(Pose::new("phi", 0.1)).unwrap().limit(1.1)
        };
        let run = simulation.tolerance(tolerance).method(Taylor).run().unwrap();
        run.final_state().iter().map(|x| x.to_bits()).collect()
    };
    let tolerances = [1e-14, 1e-6, 1e-4, 1e-10, 1e-5, 1e-13, 1e-8, 1e-7];
    for (k, tolerance) in (0..).zip(tolerances.into_iter().flat_map(|tolerance| [tolerance; 2])) {
        let alone = std::thread::spawn(move || end(tolerance, k)).join().unwrap();
        assert_eq!(end(tolerance, k), alone, "{tolerance:e}");
    }
}
