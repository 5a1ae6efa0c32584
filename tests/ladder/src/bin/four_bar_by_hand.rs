//! The four-bar loop, by hand.

use liftoff_ladder::by_hand::{four_bar, integrate};

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let (t, state) = integrate(four_bar::rates, |_| 1.0, (0.0, [turn, 0.0]), (1.0, 1e-9));
    println!("{t} {state:?}");
}
