//! The rod that topples on a rough floor, by hand.

use liftoff_ladder::by_hand::rubbing_rod;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    for at in rubbing_rod::run([0.1 * turn, 0.0], 1.0) {
        println!("{at:?}");
    }
}
