//! Dormand and Prince's pair of order 5(4) (Hairer, Nørsett, Wanner I, table II.5.2)
//! with events by bisection of a step.

const A: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// One step of length h, and its error.
fn step<const N: usize>(f: impl Fn(&[f64; N]) -> [f64; N], y: &[f64; N], h: f64) -> ([f64; N], f64) {
    let mut k = [[0.0; N]; 7];
    let mut end = *y;
    k[0] = f(y);
    for stage in 0..6 {
        end = core::array::from_fn(|i| y[i] + h * (0..=stage).map(|j| A[stage][j] * k[j][i]).sum::<f64>());
        k[stage + 1] = f(&end);
    }
    let error = |i: usize| h * (0..7).map(|j| E[j] * k[j][i]).sum::<f64>();
    (end, (0..N).map(|i| error(i).abs() / (1.0 + y[i].abs())).fold(0.0, f64::max))
}

/// The time and state where `guard` falls through zero, or at `limit`.
pub fn integrate<const N: usize>(
    f: impl Fn(&[f64; N]) -> [f64; N],
    guard: impl Fn(&[f64; N]) -> f64,
    (mut t, mut y): (f64, [f64; N]),
    (limit, tolerance): (f64, f64),
) -> (f64, [f64; N]) {
    let mut h = 0.01;
    while t < limit {
        h = f64::min(h, limit - t);
        let (end, error) = step(&f, &y, h);
        if error <= tolerance {
            if guard(&end) < 0.0 {
                return locate(&f, &guard, (t, &y), h);
            }
            (t, y) = (t + h, end);
        }
        // The fifth root by Newton's method would be as good: five halvings at most, one doubling.
        let ratio = 0.5 * tolerance / error.max(1e-300);
        h *= if ratio > 32.0 { 2.0 } else { ratio.clamp(0.1, 1.2) };
    }
    (t, y)
}

/// Bisection of the step in which the guard falls.
fn locate<const N: usize>(
    f: impl Fn(&[f64; N]) -> [f64; N],
    guard: impl Fn(&[f64; N]) -> f64,
    (t, y): (f64, &[f64; N]),
    h: f64,
) -> (f64, [f64; N]) {
    let (mut low, mut high) = (0.0, h);
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        if guard(&step(&f, y, middle).0) < 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    (t + low, step(&f, y, low).0)
}
