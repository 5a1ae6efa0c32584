//! The bar that strikes a floor.

use liftoff::prelude::*;
use liftoff_ladder::DroppedBar;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let start = Pose::new("phi", turn).with("y", 2.0);
    let run =
        Simulation::new(&DroppedBar::SCENE)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
