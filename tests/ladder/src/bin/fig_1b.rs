//! The paper's Fig. 1b, every support watched on its own.

use liftoff::prelude::*;
use zigzag::Zigzag;

#[path = "../../../../models/systems/src/zigzag.rs"]
mod zigzag;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let model = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g: 9.81 };
    let start = Pose::new("phi_inner", 1.2 * turn).with("phi_outer", 1.2 * turn);
    let run = Simulation::new(&model)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
