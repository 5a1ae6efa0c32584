//! `ode_solvers`: no events.

use liftoff_peers::{PENDULUM_START, pendulum as slope};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, System, Vector4};

struct Pendulum;

impl System<f64, Vector4<f64>> for Pendulum {
    fn system(&self, _: f64, y: &Vector4<f64>, dy: &mut Vector4<f64>) {
        slope(y.as_slice(), dy.as_mut_slice());
    }
}

pub fn pendulum(tolerance: f64) -> Option<[f64; 4]> {
    let start = Vector4::from(PENDULUM_START);
    let mut stepper = Dop853::new(Pendulum, 0.0, 10.0, 10.0, start, tolerance, tolerance);
    stepper.set_output(OutputType::Sparse);
    stepper.integrate().ok()?;
    stepper.y_out().last().map(|y| [y[0], y[1], y[2], y[3]])
}
