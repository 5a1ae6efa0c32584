use liftoff::prelude::*;

/// A folded chain falls, one end held: four bars down, one across, four up, with both ends level.
///
/// ```text
///   ──O      P
///     │      │
///     │      │          every angle from the downward vertical
///     └──────┘
/// ```
///
/// Its end P outruns free fall. As the bars become many the fall takes 0.84721308 √(2L/g), L the whole length.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[chain(bar, links = 9, from = O, to = P, mass = m, length = l)]
#[pin(O = (0, 0))]
#[coordinate(phi_1 = angle(bar1), from = down)]
#[coordinate(phi_2 = angle(bar2), from = down)]
#[coordinate(phi_3 = angle(bar3), from = down)]
#[coordinate(phi_4 = angle(bar4), from = down)]
#[coordinate(phi_5 = angle(bar5), from = down)]
#[coordinate(phi_6 = angle(bar6), from = down)]
#[coordinate(phi_7 = angle(bar7), from = down)]
#[coordinate(phi_8 = angle(bar8), from = down)]
#[coordinate(phi_9 = angle(bar9), from = down)]
pub struct FoldedChain {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
