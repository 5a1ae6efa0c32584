//! The pendulum, by hand.

use liftoff_ladder::by_hand::{integrate, pendulum};

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    println!("{:?}", integrate(pendulum::rates, |_| 1.0, (0.0, [turn, 0.0]), (1.0, 1e-9)).1);
}
