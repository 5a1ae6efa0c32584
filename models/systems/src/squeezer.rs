use liftoff::prelude::*;

/// Andrews' squeezer: seven bodies, three loops, driven by a constant torque against a spring, without gravity.
///
/// ```text
///        H ───── A ────── G         O–F crank K1, F–E link K2, B–E–D plate K3,
///         ╲      ▲       ╱          G–E and A–G links K4 and K5, H–E and A–H links K6 and K7
///      K6  ╲            ╱ K4
///           ╲  K2      ╱
///             E ───── F ── O        the spring joins D to the ground at C
///              ╲ K3
///         D ─── B
/// ```
///
/// Numbers: Hairer & Wanner, Solving Ordinary Differential Equations II, VII.7 (m, kg, s). The angles are theirs, but
/// `phi` and `omega` are measured from the neighbouring bar: π/2 less and π/2 more.
#[derive(BarSystem, Clone, Debug)]
#[bar(K1 = O -> F, mass = 0.04325, length = 0.007, centre = 0.00092, inertia = 2.194e-6)]
#[bar(K2 = E -> F, mass = 0.00365, length = 0.028, centre = 0.0165, inertia = 4.410e-7)]
#[body(
    K3,
    points(B = (0, 0), E = (0.035, 0), D = (0.018, 0.02)),
    mass = 0.02373,
    centre = (0.01874, 0.01043),
    inertia = 5.255e-6,
)]
#[bar(K4 = G -> E, mass = 0.00706, length = 0.02, centre = 0.00579, inertia = 5.667e-7)]
#[bar(K5 = A -> G, mass = 0.07050, length = 0.04, centre = (0.02308, 0.00916), inertia = 1.169e-5)]
#[bar(K6 = H -> E, mass = 0.00706, length = 0.02, centre = 0.00579, inertia = 5.667e-7)]
#[bar(K7 = A -> H, mass = 0.05498, length = 0.04, centre = (0.01228, 0.00449), inertia = 1.912e-5)]
#[pin(O = (0, 0))]
#[pin(A = (-0.06934, -0.00227))]
#[pin(B = (-0.03635, 0.03273))]
#[ground(C = (0.014, 0.072))]
#[spring(DC, stiffness = k, length = 0.07785)]
#[couple(K1 = torque)]
#[figure(
    F = (0.007, 0),
    E = (-0.021, 0.0013),
    G = (-0.034, 0.0165),
    H = (-0.0316, -0.0156),
    D = (-0.0263, 0.0255),
)]
#[coordinate(beta = angle(K1))]
#[coordinate(theta = angle(K2), from = K1)]
#[coordinate(gamma = angle(K3), from = down)]
#[coordinate(phi = angle(K4), from = K5)]
#[coordinate(delta = angle(K5))]
#[coordinate(omega = angle(K6), from = K7)]
#[coordinate(epsilon = angle(K7), from = down)]
pub struct Squeezer {
    /// Torque on the crank.
    pub torque: f64,
    /// Stiffness of the spring.
    pub k: f64,
}
