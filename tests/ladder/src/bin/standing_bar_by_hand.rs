//! The bar on a floor, by hand.

use liftoff_ladder::by_hand::{integrate, standing_bar};

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let start = (0.0, [turn, 0.0, 0.0, 0.0]);
    let (t, state) = integrate(standing_bar::rates, standing_bar::reaction, start, (0.3, 1e-9));
    println!("{t} {state:?} {}", standing_bar::reaction(&state));
}
