//! The paper's Fig. 1b with every support on its own, l = 1, bars of mass ½: the right half,
//! φ_inner, φ_outer, rise of C.

use crate::GRAVITY;

/// State: φ_inner, φ_outer, y, and their rates.
pub type State = [f64; 6];

/// Closed contacts, C and E.
pub type Closed = [bool; 2];

/// M q̈ = force + rowsᵀ N, and the accelerations rows q̈ + bias of C and E.
struct Equations {
    mass: [[f64; 3]; 3],
    force: [f64; 3],
    rows: [[f64; 3]; 2],
    bias: [f64; 2],
}

fn equations(&[a, b, _, p, q, _]: &State) -> Equations {
    let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
    let both = (a + b).cos();
    let mass = [
        [2.0 / 3.0, -0.25 * both, 0.75 * ca],
        [-0.25 * both, 1.0 / 6.0, -0.25 * cb],
        [0.75 * ca, -0.25 * cb, 1.0],
    ];
    // Centres of CD and DE: what their accelerations have besides those of the coordinates, and
    // gravity.
    let inner = [0.5 * ca * p * p, 0.5 * sa * p * p - GRAVITY];
    let outer = [ca * p * p + 0.5 * cb * q * q, sa * p * p - 0.5 * sb * q * q - GRAVITY];
    let force = [
        0.5 * (-0.5 * sa * inner[0] + 0.5 * ca * inner[1] - sa * outer[0] + ca * outer[1]),
        0.25 * (-sb * outer[0] - cb * outer[1]),
        0.5 * (inner[1] + outer[1]),
    ];
    let rows = [[0.0, 0.0, 1.0], [ca, -cb, 1.0]];
    Equations { mass, force, rows, bias: [0.0, sb * q * q - sa * p * p] }
}

/// Accelerations, and reactions of the half: of C half of what bears there, of E all.
pub fn solve(state: &State, closed: Closed) -> ([f64; 3], [f64; 2]) {
    let Equations { mass, force, rows, bias } = equations(state);
    // [M −Jᵀ; J 0] with the force 0 of an open contact for its row.
    let mut system = [[0.0; 6]; 5];
    for i in 0..3 {
        system[i][..3].copy_from_slice(&mass[i]);
        system[i][5] = force[i];
        (0..2).for_each(|k| system[i][3 + k] = -rows[k][i]);
    }
    for k in 0..2 {
        if closed[k] {
            system[3 + k][..3].copy_from_slice(&rows[k]);
            system[3 + k][5] = -bias[k];
        } else {
            system[3 + k][3 + k] = 1.0;
        }
    }
    let x = eliminate(system);
    ([x[0], x[1], x[2]], [x[3], x[4]])
}

/// Gauss' elimination with the largest pivot of each column.
fn eliminate(mut system: [[f64; 6]; 5]) -> [f64; 5] {
    for k in 0..5 {
        let pivot = (k..5).max_by(|&i, &j| system[i][k].abs().total_cmp(&system[j][k].abs()));
        system.swap(k, pivot.unwrap_or(k));
        for i in k + 1..5 {
            let factor = system[i][k] / system[k][k];
            (k..6).for_each(|j| system[i][j] -= factor * system[k][j]);
        }
    }
    let mut x = [0.0; 5];
    for k in (0..5).rev() {
        x[k] = (system[k][5] - (k + 1..5).map(|j| system[k][j] * x[j]).sum::<f64>()) / system[k][k];
    }
    x
}

/// Rates of the state with some contacts closed.
pub fn rates(state: &State, closed: Closed) -> State {
    let ([a, b, c], _) = solve(state, closed);
    let [.., p, q, v] = *state;
    [p, q, v, a, b, c]
}

/// The least of what must not be less than 0: reactions of closed contacts, gaps of open ones, the
/// height of B and D.
pub fn margin(state: &State, closed: Closed) -> f64 {
    least(state, closed).1
}

/// Which it is: 0 for C, 1 for A and E, 2 for B and D.
pub fn least(state: &State, closed: Closed) -> (usize, f64) {
    let &[a, b, y, ..] = state;
    let (_, reactions) = solve(state, closed);
    let gaps = [y, y + a.sin() - b.sin()];
    let of = |k: usize| if closed[k] { reactions[k] } else { gaps[k] };
    let margins = [of(0), of(1), y + a.sin()];
    let least = margins.into_iter().enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    least.expect("three")
}
