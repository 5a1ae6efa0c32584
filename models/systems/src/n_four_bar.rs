use liftoff::prelude::*;

/// Two four-bar loops in a row (IFToMM multibody benchmark A02): every bar is level at once twice a turn, and the
/// loops are then singular.
///
/// ```text
///   B ──── D ──── F
///   │      │      │        phi: the upright bars, from the vertical, clockwise
///   │      │      │
///   A      C      E
/// ```
///
/// On the branch of parallelograms, φ̇² = φ̇₀² + 2g (3/2 + 2)(1 − cos φ)/(l (3/3 + 2)).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(CD, mass = m, length = l)]
#[bar(EF, mass = m, length = l)]
#[bar(BD, mass = m, length = l)]
#[bar(DF, mass = m, length = l)]
#[pin(A = (0, 0))]
#[pin(C = (l, 0))]
#[pin(E = (2 * l, 0))]
#[figure(B = (0, l), D = (l, l), F = (2 * l, l))]
#[coordinate(phi = -angle(AB), from = up)]
#[coordinate(phi_c = -angle(CD), from = up)]
#[coordinate(phi_e = -angle(EF), from = up)]
#[coordinate(psi_b = angle(BD))]
#[coordinate(psi_d = angle(DF))]
pub struct NFourBar {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
