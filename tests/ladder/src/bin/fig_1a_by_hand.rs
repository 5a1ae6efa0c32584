//! The paper's Fig. 1a, by hand.

use liftoff_ladder::by_hand::{fig_1a, integrate};

const END: f64 = 1.0;

fn main() {
    // Read, so that nothing is computed by the compiler.
    let turn = std::env::args().len() as f64;
    let (t, [phi, w]) = integrate(fig_1a::held, fig_1a::reaction, (0.0, [0.1 * turn, 0.0]), (END, 1e-9));
    println!("{t} {phi} {w}");
    let drop = 0.5 * phi.tan();
    let free = [phi, drop, w, 0.5 * w / (phi.cos() * phi.cos())];
    // What opens leaves the corner, wherever rounding begins.
    let gap = |state: &[f64; 4]| fig_1a::gap(state) + 1e-12;
    let (t, state) = integrate(fig_1a::free, gap, (t, free), (END, 1e-9));
    println!("{t} {state:?}");
}
