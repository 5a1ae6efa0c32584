//! The bar on a floor.

use liftoff::prelude::*;
use liftoff_ladder::StandingBar;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let start = Pose::new("phi", turn);
    let run =
        Simulation::new(&StandingBar::SCENE)?.tolerance(1e-9).start(start)?.limit(0.3).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
