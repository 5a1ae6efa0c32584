//! The bar that strikes a floor, by hand.

use liftoff_ladder::by_hand::{dropped_bar, integrate};

const END: f64 = 1.0;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let mut at = (0.0, [turn, 0.0, 2.0, 0.0, 0.0, 0.0]);
    while at.0 < END {
        at = integrate(dropped_bar::rates, dropped_bar::gap, at, (END, 1e-9));
        if at.0 < END {
            at.1 = dropped_bar::impact(&at.1);
        }
        println!("{at:?}");
    }
}
