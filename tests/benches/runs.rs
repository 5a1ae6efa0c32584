//! One kind of run in a loop, for profilers and counters of instructions:
//!
//! ```text
//! cargo bench -p liftoff-tests --bench runs --no-run
//! valgrind --tool=callgrind --toggle-collect='*measured*' target/release/deps/runs-… stick-slip dop853 1e-9 10
//! ```
//!
//! A model's name with its default run, or `stick-slip`, the run of the friction benchmark, or `by-hand`, the same in event code by
//! hand; a method; a tolerance; how many runs.

#[path = "speed/stick_slip.rs"]
mod stick_slip;

use liftoff::method::MethodId;
use std::hint::black_box;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let [name, method, tolerance, repeats] = &words[..] else { return Ok(()) };
    let (tolerance, repeats): (f64, usize) = (tolerance.parse()?, repeats.parse()?);
    if name == "by-hand" {
        measured(repeats, &|| {
            black_box(stick_slip::by_hand(&stick_slip::BELT, tolerance));
        });
        return Ok(());
    }
    let simulation = if name == "stick-slip" {
        stick_slip::simulation(tolerance)?
    } else {
        let entry = liftoff_models::models().find(name)?;
        entry.simulation(&entry.default_run().tolerance(tolerance))?
    };
    let simulation = simulation.method(method.parse::<MethodId>()?);
    measured(repeats, &|| drop(black_box(simulation.run())));
    Ok(())
}

#[inline(never)]
fn measured(repeats: usize, run: &dyn Fn()) {
    (0..repeats).for_each(|_| run());
}
