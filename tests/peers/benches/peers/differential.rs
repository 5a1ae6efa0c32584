//! `differential-equations`.

use differential_equations::prelude::*;
use liftoff_peers::{PAIR_START, PENDULUM_START, in_flight, meeting, on_corners, reaction, released};

/// A motion, to the zero of a function where it has one.
struct Motion(fn(&[f64], &mut [f64]), fn(&[f64]) -> f64);

impl<const N: usize> ODE<f64, [f64; N]> for Motion {
    fn diff(&self, _: f64, y: &[f64; N], slope: &mut [f64; N]) {
        self.0(y, slope);
    }
}

impl<const N: usize> Event<f64, [f64; N]> for Motion {
    fn config(&self) -> EventConfig {
        EventConfig::default().terminal()
    }

    fn event(&self, _: f64, y: &[f64; N]) -> f64 {
        self.1(y)
    }
}

pub fn pendulum(tolerance: f64) -> Option<[f64; 4]> {
    let system = Motion(liftoff_peers::pendulum, |_| 1.0);
    let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
    let solution = IVP::ode(&system, 0.0, 10.0, PENDULUM_START).method(method).solve().ok()?;
    solution.y.last().copied()
}

pub fn verner(tolerance: f64) -> Option<[f64; 4]> {
    let system = Motion(liftoff_peers::pendulum, |_| 1.0);
    let method = ExplicitRungeKutta::rkv988e().rtol(tolerance).atol(tolerance);
    let solution = IVP::ode(&system, 0.0, 10.0, PENDULUM_START).method(method).solve().ok()?;
    solution.y.last().copied()
}

pub fn pair(tolerance: f64) -> Option<[f64; 2]> {
    let (lift_off, y) = first(&Motion(on_corners, reaction), (0.0, PAIR_START), tolerance)?;
    let (end, _) = first(&Motion(in_flight, meeting), (lift_off, released(&y)), tolerance)?;
    Some([lift_off, end])
}

fn first<const N: usize>(
    system: &Motion,
    (t, y): (f64, [f64; N]),
    tolerance: f64,
) -> Option<(f64, [f64; N])> {
    let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
    let run = IVP::ode(system, t, t + 10.0, y).event(system);
    let solution = run.method(method).solve().ok()?;
    matches!(solution.status, Status::Interrupted).then_some(())?;
    Some((*solution.t.last()?, *solution.y.last()?))
}
