//! `diffsol`.

use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use liftoff_peers::{PAIR_START, PENDULUM_START, in_flight, meeting, on_corners, reaction, released};

type Matrix = NalgebraMat<f64>;

pub fn pendulum(tolerance: f64) -> Option<[f64; 4]> {
    let problem = OdeBuilder::<Matrix>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(|y: &[f64], _: &[f64], _: f64, slope: &mut [f64]| liftoff_peers::pendulum(y, slope))
        .init(|_: &[f64], _: f64, y: &mut [f64]| y.copy_from_slice(&PENDULUM_START), 4)
        .build()
        .ok()?;
    let mut solver = problem.tsit45().ok()?;
    solver.set_stop_time(10.0).ok()?;
    while !matches!(solver.step().ok()?, OdeSolverStopReason::TstopReached) {}
    solver.state().y.batch_as_slice(0).try_into().ok()
}

pub fn pair(tolerance: f64) -> Option<[f64; 2]> {
    let (lift_off, y) = first((on_corners, reaction), (0.0, &PAIR_START), tolerance)?;
    let (end, _) = first((in_flight, meeting), (lift_off, &released(&y)), tolerance)?;
    Some([lift_off, end])
}

type Slope = fn(&[f64], &mut [f64]);

fn first(
    (slope, zero): (Slope, fn(&[f64]) -> f64),
    (t, start): (f64, &[f64]),
    tolerance: f64,
) -> Option<(f64, Vec<f64>)> {
    let problem = OdeBuilder::<Matrix>::new()
        .t0(t)
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(move |y: &[f64], _: &[f64], _: f64, out: &mut [f64]| slope(y, out))
        .init(|_: &[f64], _: f64, y: &mut [f64]| y.copy_from_slice(start), start.len())
        .root(move |y: &[f64], _: &[f64], _: f64, out: &mut [f64]| out[0] = zero(y), 1)
        .build()
        .ok()?;
    let mut solver = problem.tsit45().ok()?;
    solver.set_stop_time(t + 10.0).ok()?;
    loop {
        match solver.step().ok()? {
            OdeSolverStopReason::RootFound(at, _) => {
                return Some((at, solver.interpolate(at).ok()?.batch_as_slice(0).to_vec()));
            }
            OdeSolverStopReason::TstopReached => return None,
            OdeSolverStopReason::InternalTimestep => {}
        }
    }
}
