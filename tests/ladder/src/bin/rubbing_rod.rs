//! The rod that topples on a rough floor.

use liftoff::prelude::*;
use slipping_rod::SlippingRod;

#[path = "../../../../models/systems/src/slipping_rod.rs"]
mod slipping_rod;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let model = SlippingRod { m: 1.0, l: 1.0, mu: 0.3, g: 9.81 };
    let start = Pose::new("phi", 0.1 * turn);
    let run = Simulation::new(&model)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
