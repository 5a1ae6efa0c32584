//! The paper's Fig. 1a.

use falling_pair::FallingPair;
use liftoff::prelude::*;

#[path = "../../../../models/systems/src/falling_pair.rs"]
mod falling_pair;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let model = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    let start = Pose::new("phi", 0.1 * turn);
    let run = Simulation::new(&model)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
