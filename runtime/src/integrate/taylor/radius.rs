//! How far the series reach.

use crate::integrate::Tolerance;
use crate::integrate::tolerance::norm;
use crate::series::ORDERS;

/// The last term kept, against the tolerance: what is left out is about as large.
const LAST: f64 = 0.01;

/// Where a step ends whose last two coefficients, of order p − 1 and p, would be the same in units of the tolerance.
const DECAY: f64 = 7.389056098930650;

/// θ up to which the last terms meet the tolerance; infinite where they vanish.
pub(super) fn radius<const N: usize>(
    series: &[[f64; N]; ORDERS],
    order: usize,
    tolerance: &Tolerance<N>,
) -> f64 {
    let reach = |theta: f64| {
        let end = core::array::from_fn(|i| series[0][i].abs() + theta * series[1][i].abs());
        let scale = tolerance.scale(&series[0], &end);
        let size = |k: usize| (0..N).map(|i| series[k][i].abs() / scale[i]).fold(0.0, f64::max);
        let last = log2(LAST / size(order)) / order as f64;
        let before = log2(DECAY * LAST / size(order - 1)) / (order - 1) as f64;
        exp2(last.min(before))
    };
    let theta = reach(1.0);
    if theta < 0.5 { reach(theta) } else { theta }
}

/// How often the state changes by its own size in a unit of time, by its first two coefficients.
pub(super) fn rate<const N: usize>([y, slope, bend]: &[[f64; N]; 3], tolerance: &Tolerance<N>) -> f64 {
    let scale = tolerance.scale(y, y);
    let size = if tolerance.relative() > 0.0 { 1.0 / tolerance.relative() } else { norm(y, &scale).max(1.0) };
    let second = (2.0 * norm(bend, &scale) / size).sqrt();
    (norm(slope, &scale) / size).max(second)
}

fn log2(x: f64) -> f64 {
    x.log2()
}

fn exp2(x: f64) -> f64 {
    x.exp2()
}
