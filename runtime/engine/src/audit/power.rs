//! The power of all forces that have no potential: dE/dt along the accelerations of the equations, E = T + V.

use crate::integration::phase_point::{Numbers, PhasePoint, RunContext};
use crate::integration::phase_run::RecordedPhase;

/// Gauss's points and weights of order 12 on 0..1: of a function whose nearest pole is three steps away, as that of a Taylor
/// step is at most, the integral is known to 1e-13.
const POINTS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_95, 0.085_662_246_189_585_2),
    (0.169_395_306_766_867_75, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_55, 0.233_956_967_286_345_5),
    (0.619_309_593_041_598_5, 0.233_956_967_286_345_5),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_2),
];
/// The difference of the energy is taken over this part of the time in which a state moves by itself, of the natural time and of the
/// step, inside of which forces are smooth: an error of its fourth power.
const SPAN: f64 = 1e-3;

/// Work done on a model, or by it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Work {
    /// ∫ P dt.
    pub(crate) done: f64,
    /// ∫ |P| dt about, what went in and out.
    pub(crate) passed: f64,
}

impl Work {
    /// Adds that of a phase from one time to another, between which its motion is smooth.
    pub(crate) fn add(&mut self, context: &RunContext, phase: &RecordedPhase, [t0, t1]: [f64; 2]) {
        let mut point = phase.at(t0);
        for (theta, weight) in POINTS {
            phase.show(t0 + theta * (t1 - t0), &mut point);
            let part = weight * (t1 - t0) * power(context, &point, t1 - t0);
            self.done += part;
            self.passed += part.abs();
        }
    }
}

/// By a difference of order four.
fn power(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    let (n, state, a) = (context.layout().coordinates.len(), point.state(), point.accelerations());
    let rate = |i: usize| if i < n { state[n + i] } else { a.get(i - n).copied().unwrap_or(1.0) };
    let unit = |i: usize| context.scales.entry(context.layout(), i).max(state[i].abs());
    let fastest = (0..2 * n).map(|i| rate(i).abs() / unit(i)).fold(f64::MIN_POSITIVE, f64::max);
    let dt = SPAN * (1.0 / fastest).min(context.scales.time).min(step);
    let gain = |dt: f64| {
        let [ahead, behind] = [dt, -dt].map(|dt| {
            let moved: Numbers = (0..state.len()).map(|i| state[i] + dt * rate(i)).collect();
            context.system().energy(&moved)
        });
        ahead.gained_since(&behind) / (2.0 * dt)
    };
    (4.0 * gain(dt) - gain(2.0 * dt)) / 3.0
}
