//! `ivp`.

use ivp::prelude::*;
use liftoff_peers::{PAIR_START, PENDULUM_START, in_flight, meeting, on_corners, reaction, released};

struct Smooth(fn(&[f64], &mut [f64]));

impl FirstOrderSystem for Smooth {
    fn derivative(&self, _: f64, y: &[f64], slope: &mut [f64]) {
        self.0(y, slope);
    }
}

/// A motion to the zero of a function.
struct Ended(fn(&[f64], &mut [f64]), fn(&[f64]) -> f64);

impl FirstOrderSystem for Ended {
    fn derivative(&self, _: f64, y: &[f64], slope: &mut [f64]) {
        self.0(y, slope);
    }

    fn events(&self, _: f64, y: &[f64], out: &mut [f64]) {
        out[0] = self.1(y);
    }

    fn n_events(&self) -> usize {
        1
    }

    fn event_config(&self, _: usize) -> EventConfig {
        let mut config = EventConfig::default();
        config.terminal();
        config
    }
}

pub fn pendulum(tolerance: f64) -> Option<[f64; 4]> {
    let system = Smooth(liftoff_peers::pendulum);
    let run = Ivp::first_order(&system, 0.0, 10.0, &PENDULUM_START).method(Method::DOP853);
    let solution = run.rtol(tolerance).atol(tolerance).solve().ok()?;
    solution.y.last()?.as_slice().try_into().ok()
}

pub fn pair(tolerance: f64) -> Option<[f64; 2]> {
    let (lift_off, y) = first(&Ended(on_corners, reaction), (0.0, &PAIR_START), tolerance)?;
    let (end, _) = first(&Ended(in_flight, meeting), (lift_off, &released(&y)), tolerance)?;
    Some([lift_off, end])
}

fn first(system: &Ended, (t, y): (f64, &[f64]), tolerance: f64) -> Option<(f64, Vec<f64>)> {
    let run = Ivp::first_order(system, t, t + 10.0, y).method(Method::DOP853);
    let solution = run.rtol(tolerance).atol(tolerance).solve().ok()?;
    Some((*solution.t_events.first()?.first()?, solution.y_events.first()?.first()?.to_vec()))
}
