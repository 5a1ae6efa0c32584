//! The free bar.

use liftoff::flow;
use liftoff_ladder::FreeBar;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    println!("{:?}", flow(&FreeBar::SCENE, &[0.0, 0.0, 0.0, turn, 1.0, 2.0], 1.0, 1e-9));
}
