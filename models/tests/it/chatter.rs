//! Impacts without restitution that chase each other: feet and a thread strike in turn, each time
//! with two thirds of the speed, until all are at rest.

use liftoff::prelude::*;
use liftoff_models::models;

/// Lost flights within the bounds of their gaps used to be struck late, each with more energy than
/// was left: thousands of events, more at some tolerances than at others.
#[test]
fn chatter_dies_at_every_tolerance() {
    let angle = 1.266_103_672_779_499_2;
    let entry = models().find("zigzag-thread").unwrap();
    let model = entry.model(&entry.default_run().parameters).unwrap();
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let start = Pose::new("phi_inner", angle).with("phi_outer", angle).with("y", 0.0).with("y'", -0.03);
        let run = Simulation::new(model.clone()).unwrap().tolerance(tolerance).start(start).unwrap();
        let run = run.limit(0.6).run().unwrap();
        assert!(run.events().len() < 500, "{tolerance:e}: {}", run.events().len());
        let energies: Vec<f64> =
            run.events().iter().map(|e| run.value(&run.output("E").unwrap(), e.t)).collect();
        let bound = 1e-3 * tolerance.sqrt().max(1e-9);
        assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + bound), "{tolerance:e}");
    }
}
