//! Entry 11: two equal bars in line, hinged, struck across at one end by P: momentum and angular
//! momentum of each bar with equal velocities of the hinge.

/// Impulse of the struck bar on the other, P/4, against the blow.
pub fn inner_impulse(blow: f64) -> f64 {
    0.25 * blow
}

/// Velocity of the struck end, 7P/2m.
pub fn struck_end(blow: f64, mass: f64) -> f64 {
    3.5 * blow / mass
}

/// Rates of the far and of the struck bar: −(3/2) P/(m l) and (9/2) P/(m l).
pub fn rates(blow: f64, mass: f64, length: f64) -> [f64; 2] {
    [-1.5, 4.5].map(|factor| factor * blow / (mass * length))
}
