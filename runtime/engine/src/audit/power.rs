//! The power of all forces that have no potential: dE/dt along the accelerations of the equations, E = T + V.

use crate::integration::phase_point::{PhasePoint, RunContext};

/// Gauss's points and weights of order 8 on 0..1.
const POINTS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];
/// Steps of Taylor series are long.
const PARTS: usize = 4;
/// Half the span of the difference, in times in which a state moves by itself.
const SPAN: f64 = 1e-5;

/// ∫ P dt from one time to another, between which the motion is smooth.
pub(super) fn work(context: &RunContext, [t0, t1]: [f64; 2], at: impl Fn(f64) -> PhasePoint) -> f64 {
    let h = (t1 - t0) / PARTS as f64;
    let part = |k: usize| {
        let start = t0 + k as f64 * h;
        POINTS.iter().map(|(theta, weight)| h * weight * power(context, &at(start + theta * h))).sum::<f64>()
    };
    (0..PARTS).map(part).sum()
}

fn power(context: &RunContext, point: &PhasePoint) -> f64 {
    let (n, state, a) = (context.layout().coordinates.len(), point.state(), point.accelerations());
    let rate = |i: usize| if i < n { state[n + i] } else { a.get(i - n).copied().unwrap_or(1.0) };
    let unit = |i: usize| context.scales.entry(context.layout(), i).max(state[i].abs());
    let fastest = (0..2 * n).map(|i| rate(i).abs() / unit(i)).fold(f64::MIN_POSITIVE, f64::max);
    let dt = SPAN / fastest;
    let [ahead, behind] = [dt, -dt].map(|dt| {
        let moved: Vec<f64> = (0..state.len()).map(|i| state[i] + dt * rate(i)).collect();
        context.system().energy(&moved)
    });
    ahead.gained_since(&behind) / (2.0 * dt)
}
