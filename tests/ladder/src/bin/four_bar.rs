//! A four-bar loop.

use liftoff::prelude::*;
use parallelogram::Parallelogram;

#[path = "../../../../models/systems/src/parallelogram.rs"]
mod parallelogram;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Known at run time only, so that the compiler computes nothing in advance.
    let turn = std::env::args().len() as f64;
    let model = Parallelogram { m: 1.0, l: 1.0, c: 1.0, d: 2.0, g: 9.81 };
    let start = Pose::new("phi", turn);
    let run = Simulation::new(&model)?.tolerance(1e-9).start(start)?.limit(1.0).observe(&mut ())?;
    for event in run.events() {
        println!("{event}");
    }
    Ok(())
}
