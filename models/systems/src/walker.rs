use liftoff::prelude::*;

/// A walking frame stands on point feet that do not slip, kept upright by springs and dampers at hips and knees.
///
/// ```text
///          T
///          │ torso
///          H
///     left╱ ╲right        thighs
///        K   J
///        │   │            shins
///      ▒▒P▒▒▒Q▒▒
/// ```
///
/// Where tan a = ¾ the springs have no torque in the figure; the weight bends the legs until they bear it.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(torso = T -> H, mass = m, length = l)]
#[bar(left = H -> K, mass = m / 5, length = l / 2)]
#[bar(right = H -> J, mass = m / 5, length = l / 2)]
#[bar(left_shin = K -> P, mass = m / 10, length = l / 2)]
#[bar(right_shin = J -> Q, mass = m / 10, length = l / 2)]
#[support(P = floor, rough)]
#[support(Q = floor, rough)]
#[torsion(torso, left, stiffness = k, angle = -a, damping = c)]
#[torsion(torso, right, stiffness = k, angle = a, damping = c)]
#[torsion(left, left_shin, stiffness = k, angle = a, damping = c)]
#[torsion(right, right_shin, stiffness = k, angle = -a, damping = c)]
#[figure(
    P = (-3 * l / 10, 0),
    K = (-3 * l / 10, l / 2),
    H = (0, 9 * l / 10),
    T = (0, 19 * l / 10),
    J = (3 * l / 10, l / 2),
    Q = (3 * l / 10, 0),
)]
#[coordinate(lean = angle(torso), from = down)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
pub struct Walker {
    /// Mass of the torso.
    pub m: f64,
    /// Length of the torso, and of a leg.
    pub l: f64,
    /// Angle of the thighs to the vertical without load.
    pub a: f64,
    /// Stiffness of a joint.
    pub k: f64,
    /// Damping of a joint.
    pub c: f64,
    /// Gravity.
    pub g: f64,
}
