use liftoff::prelude::*;

/// A wheel of six spokes and no rim rolls down a slope, spoke by spoke.
///
/// ```text
///       D   C
///        ╲ ╱
///     E───H───B
///        ╱ ╲
///    ▔▔▔F   A▔▔▔▔      γ below the horizontal, to the right
/// ```
///
/// Each impact leaves η = (j + m l² cos 2α)/(j + m l²) of the rate, 2α = 60° (McGeer, Int. J. Robotics Res. 9(2), 1990, 62–82);
/// a rate squared that differs from that of steady rolling differs by η² of that after the next step.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[body(
    wheel,
    points(
        H = (0, 0),
        A = (l / 2, -l * sqrt(3) / 2),
        B = (l, 0),
        C = (l / 2, l * sqrt(3) / 2),
        D = (-l / 2, l * sqrt(3) / 2),
        E = (-l, 0),
        F = (-l / 2, -l * sqrt(3) / 2),
    ),
    mass = m,
    inertia = j,
    centre = (0, 0),
)]
#[support(A = slope(-gamma), friction = mu)]
#[support(B = slope(-gamma), friction = mu)]
#[support(C = slope(-gamma), friction = mu)]
#[support(D = slope(-gamma), friction = mu)]
#[support(E = slope(-gamma), friction = mu)]
#[support(F = slope(-gamma), friction = mu)]
#[figure(F = (0, 0), A = (l * cos(gamma), -l * sin(gamma)))]
#[coordinate(phi = angle(wheel), from = right)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
#[liftoff(sets = 16)]
pub struct RimlessWheel {
    /// Mass.
    pub m: f64,
    /// Moment of inertia about the hub.
    pub j: f64,
    /// Length of a spoke.
    pub l: f64,
    /// Angle of the slope.
    pub gamma: f64,
    /// Friction of the slope.
    pub mu: f64,
    /// Gravity.
    pub g: f64,
}
