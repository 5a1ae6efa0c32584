use liftoff::prelude::*;

/// Whitworth's quick return: a pin on a steady crank slides in the slot of a lever, which swings fast one way and
/// slowly the other.
///
/// ```text
///            B
///           ╱
///     A ───╱      phi: the crank OA
///      ╲  ╱       psi: the lever CB
///     ──O╱──
///       ╱
///     ──C──
/// ```
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = a, length = r)]
#[bar(CB, mass = b, length = l)]
#[pin(O = (0, h))]
#[pin(C = (0, 0))]
#[slider(A = bar(CB))]
#[figure(A = (r, h), B = (4 * l / 5, 3 * l / 5))]
#[coordinate(phi = angle(OA))]
#[coordinate(psi = angle(CB))]
#[drive(phi = omega * t)]
pub struct QuickReturn {
    /// Mass of the crank.
    pub a: f64,
    /// Mass of the lever.
    pub b: f64,
    /// Length of the crank.
    pub r: f64,
    /// Length of the lever.
    pub l: f64,
    /// Height of the crank's pin over the lever's.
    pub h: f64,
    /// Rate of the crank.
    pub omega: f64,
}
