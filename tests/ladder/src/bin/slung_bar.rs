//! The bar on a thread.

use liftoff::prelude::*;
use liftoff_ladder::SlungBar;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let start = Pose::new("x", 0.0).with("y", -2.0 / 3.0).with("phi", 0.0).with("phi'", turn);
    let run = Simulation::new(&SlungBar::SCENE)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
