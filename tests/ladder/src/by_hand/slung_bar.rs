//! A bar on a thread that slips through an eye, m = l = 1.

use crate::GRAVITY;

/// Rates of φ, x, y, and their rates, with the thread taut: M a = f − T ∂(|A| + |B|)/∂q, J = 1/12.
pub fn rates(state: &[f64; 6]) -> [f64; 6] {
    let (row, tension) = pull(state);
    let [.., w, u, v] = *state;
    [w, u, v, -12.0 * row[0] * tension, -row[1] * tension, -GRAVITY - row[2] * tension]
}

/// The tension T.
pub fn tension(state: &[f64; 6]) -> f64 {
    pull(state).1
}

/// ∂(|A| + |B|)/∂q, and T from d²(|A| + |B|)/dt² = 0.
fn pull(&[phi, x, y, w, u, v]: &[f64; 6]) -> ([f64; 3], f64) {
    let (sin, cos) = phi.sin_cos();
    let (half_x, half_y) = (0.5 * cos, 0.5 * sin);
    let mut row = [0.0; 3];
    let mut bias = 0.0;
    for side in [-1.0, 1.0] {
        let (px, py) = (x + side * half_x, y + side * half_y);
        let (vx, vy) = (u - side * half_y * w, v + side * half_x * w);
        let inverse = 1.0 / (px * px + py * py).sqrt();
        let (nx, ny) = (px * inverse, py * inverse);
        let along = nx * vx + ny * vy;
        row[0] += side * (ny * half_x - nx * half_y);
        row[1] += nx;
        row[2] += ny;
        bias += (vx * vx + vy * vy - along * along) * inverse - side * (nx * half_x + ny * half_y) * w * w;
    }
    let mobility = 12.0 * row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
    (row, (bias - row[2] * GRAVITY) / mobility)
}
