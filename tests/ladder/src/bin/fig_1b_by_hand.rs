//! The paper's Fig. 1b with every support on its own, by hand: until B and D reach the floor.

use liftoff_ladder::by_hand::{fig_1b, integrate};

const END: f64 = 1.0;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let (mut at, mut closed) = ((0.0, [1.2 * turn, 1.2 * turn, 0.0, 0.0, 0.0, 0.0]), [true; 2]);
    while at.0 < END {
        // What opens leaves the floor, wherever rounding begins.
        let margin = |state: &fig_1b::State| fig_1b::margin(state, closed) + 1e-9;
        at = integrate(|state| fig_1b::rates(state, closed), margin, at, (END, 1e-9));
        println!("{at:?}");
        match fig_1b::least(&at.1, closed) {
            (k @ 0..2, _) if closed[k] => closed[k] = false,
            _ => break,
        }
    }
}
