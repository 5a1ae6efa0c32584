//! The bar on a thread, by hand.

use liftoff_ladder::by_hand::{integrate, slung_bar};

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let start = (0.0, [0.0, 0.0, -2.0 / 3.0, turn, 0.0, 0.0]);
    let (t, state) = integrate(slung_bar::rates, slung_bar::tension, start, (1.0, 1e-9));
    println!("{t} {state:?}");
}
