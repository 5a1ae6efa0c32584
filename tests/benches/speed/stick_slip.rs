//! A block on a belt that sticks and slips: the run, and event code by hand over the same stepper,
//! which knows that there are two phases, two guards, and that none of them turns within a step.

use liftoff::prelude::*;
use liftoff_core::integrate::{Dop853, StepState, Stepper, Tolerance};
use liftoff_fixtures::Belt;

const END: f64 = 100.0;

/// The block.
pub const BELT: Belt = Belt { m: 1.0, g: 10.0, k: 4.0, mu: 0.2, mu_s: 0.5, w: 0.7 };

/// The run.
pub fn simulation(tolerance: f64) -> Result<Simulation, Box<dyn std::error::Error>> {
    let pose = Pose::new("x", 0.1).with("x'", 0.7);
    Ok(Simulation::new(&BELT)?.start(pose)?.limit(END).tolerance(tolerance))
}

/// The number of events up to the end, and the last state.
pub fn by_hand(belt: &Belt, tolerance: f64) -> (usize, [f64; 2]) {
    let Belt { m, g, k, mu, mu_s, w } = *belt;
    let (slide, stick) = (|y: &[f64; 2]| [y[1], mu * g - k / m * y[0]], |y: &[f64; 2]| [y[1], 0.0]);
    let (mut t, mut y, mut events) = (0.0, [0.1, 0.7], 0);
    while t < END {
        let sticks = events % 2 == 0;
        let guard = |y: &[f64; 2]| if sticks { mu_s * m * g - k * y[0] } else { w - y[1] };
        let rates = |y: &[f64; 2]| if sticks { stick(y) } else { slide(y) };
        let absolute = Tolerance::new(tolerance, [tolerance; 2]).expect("a tolerance");
        let mut stepper = Dop853::new(&rates, StepState::new(absolute, t, y).with_end(END));
        let mut is_first = true;
        loop {
            stepper.step().expect("a step");
            let (t1, y1) = (stepper.step_state().time(), *stepper.step_state().state());
            if guard(&y1) <= 0.0 && !(is_first && !sticks && guard(&y1).abs() < 1e-14) {
                let dense = stepper.dense();
                let theta = root(|theta| guard(&dense.interpolate(theta)), if is_first { 1e-3 } else { 0.0 });
                (y, t) = (dense.interpolate(theta), dense.t0 + theta * (dense.t1 - dense.t0));
                events += 1;
                break;
            }
            (t, y, is_first) = (t1, y1, false);
            if t >= END {
                break;
            }
        }
        if sticks && t < END {
            y[1] = w;
        }
    }
    (events, y)
}

/// A root of a function that falls through zero, by bisection and secants.
fn root(f: impl Fn(f64) -> f64, from: f64) -> f64 {
    let (mut a, mut b) = (from, 1.0);
    let (mut fa, mut fb) = (f(a), f(b));
    while (b - a) > 1e-13 && fb != 0.0 {
        let secant = b - fb * (b - a) / (fb - fa);
        let c = if secant > a && secant < b { secant } else { 0.5 * (a + b) };
        let fc = f(c);
        if (fc > 0.0) == (fa > 0.0) {
            (a, fa, fb) = (c, fc, 0.5 * fb);
        } else {
            (b, fb, fa) = (c, fc, 0.5 * fa);
        }
        if fc == 0.0 {
            return c;
        }
    }
    0.5 * (a + b)
}
