//! The falling bar, by hand.

use liftoff_ladder::by_hand::{falling_bar, integrate};

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    println!(
        "{:?}",
        integrate(falling_bar::rates, |_| 1.0, (0.0, [0.0, 0.0, 0.0, turn, 1.0, 2.0]), (1.0, 1e-9)).1
    );
}
