//! The pendulum.

use liftoff::flow;
use liftoff_ladder::Pendulum;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    println!("{:?}", flow(&Pendulum::SCENE, &[turn, 0.0], 1.0, 1e-9));
}
