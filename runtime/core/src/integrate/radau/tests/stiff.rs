//! A bob of mass 1 on a rod of length 1 that gives way like a critically damped spring, k = 1e6 …
//! 1e12 times its weight: one period from 60° at rest must lead back, as the rigid pendulum's does
//! (period 2π √(l/g) / agm(1, cos 30°)), but for what the rod gives way, O(1/k).

use core::f64::consts::{FRAC_PI_3, PI};

use crate::integrate::tests::fields::Field;
use crate::integrate::{Counts, Radau, StepState, Stepper, Tolerance};
use crate::scalar::Scalar;

const G: f64 = 9.81;

/// θ from the downward vertical and r, in which the stiff direction is a coordinate's.
struct Polar {
    k: f64,
}

impl Field<4> for Polar {
    fn rates<S: Scalar>(&self, &[theta, r, w, v]: &[S; 4]) -> [S; 4] {
        let (k, c) = (S::from_f64(self.k), S::from_f64(2.0 * self.k.sqrt()));
        let (sin, cos) = theta.sin_cos();
        let g = S::from_f64(G);
        let spring = k * (r - S::ratio(1, 1)) + c * v;
        [w, v, -(g * sin + (v + v) * w) / r, r * w * w + g * cos - spring]
    }
}

/// x and y downwards, in which the stiff direction turns.
struct Cartesian {
    k: f64,
}

impl Field<4> for Cartesian {
    fn rates<S: Scalar>(&self, &[x, y, u, v]: &[S; 4]) -> [S; 4] {
        let (k, c) = (S::from_f64(self.k), S::from_f64(2.0 * self.k.sqrt()));
        let r = (x * x + y * y).sqrt();
        let spring = k * (r - S::ratio(1, 1)) + c * (x * u + y * v) / r;
        [u, v, -(spring * x / r), S::from_f64(G) - spring * y / r]
    }
}

fn period() -> f64 {
    let mean = (0..8).fold((1.0f64, (0.5 * FRAC_PI_3).cos()), |(a, b), _| (0.5 * (a + b), (a * b).sqrt()));
    2.0 * PI / G.sqrt() / mean.0
}

/// The state after one period, and the work. Absolute tolerances are those of a run, 1e-4 of the
/// relative one.
fn swing(field: &impl Field<4>, start: [f64; 4], tol: f64) -> ([f64; 4], Counts) {
    let tolerance = Tolerance::new(tol, [1e-4 * tol; 4]).expect("a valid tolerance");
    let f = |y: &[f64; 4]| field.rates(y);
    let step_state = StepState::new(tolerance, 0.0, start).with_end(period());
    let mut solver = Radau::new(&f, |y: &[f64; 4]| field.jacobian(y), step_state);
    while solver.step_state().time() < period() {
        solver.step().expect("a smooth motion");
    }
    (*solver.step_state().state(), solver.step_state().counts())
}

fn angle_in_polar(k: f64, tol: f64) -> (f64, Counts) {
    let start = [FRAC_PI_3, 1.0 + G * FRAC_PI_3.cos() / k, 0.0, 0.0];
    let (state, counts) = swing(&Polar { k }, start, tol);
    (state[0], counts)
}

fn angle_in_cartesian(k: f64, tol: f64) -> (f64, Counts) {
    let r = 1.0 + G * FRAC_PI_3.cos() / k;
    let start = [r * FRAC_PI_3.sin(), r * FRAC_PI_3.cos(), 0.0, 0.0];
    let (state, counts) = swing(&Cartesian { k }, start, tol);
    (state[0].atan2(state[1]), counts)
}

/// The rod's giving way shifts the period by some mg/kl.
#[test]
fn stiffness_costs_no_steps() {
    for weights in [1e6, 1e8, 1e10, 1e12] {
        let k = weights * G;
        for (angle, most) in [(angle_in_polar(k, 1e-6), 150), (angle_in_cartesian(k, 1e-6), 900)] {
            let (angle, counts) = angle;
            let error = (angle - FRAC_PI_3).abs();
            assert!(error < 1e-6, "k = {weights:e}: {error:e}");
            assert!(counts.accepted < most, "k = {weights:e}: {counts:?}");
        }
    }
}

/// Absolute tolerances of 1e-14 are far below what forces known to 1e12 · 1e-16 allow.
#[test]
fn the_rigid_limit_is_reached() {
    let k = 1e12 * G;
    let (polar, counts) = angle_in_polar(k, 1e-10);
    assert!((polar - FRAC_PI_3).abs() < 1e-10 && counts.accepted < 1000, "{counts:?}");
    let (cartesian, counts) = angle_in_cartesian(k, 1e-10);
    assert!((cartesian - FRAC_PI_3).abs() < 1e-8 && counts.accepted < 10_000, "{counts:?}");
}

/// A transient that lasts 1e-9 of the motion is passed over: y′ = −λ(y − sin t) + cos t, with time
/// a state.
struct Transient;

impl Field<2> for Transient {
    fn rates<S: Scalar>(&self, &[y, t]: &[S; 2]) -> [S; 2] {
        let (sin, cos) = t.sin_cos();
        [cos - S::from_f64(1e9) * (y - sin), S::ratio(1, 1)]
    }
}

/// Prothero and Robinson's problem from off its slow solution: only the last steps' errors are left
/// in the end.
#[test]
fn a_transient_decays() {
    let f = |y: &[f64; 2]| Transient.rates(y);
    let tolerance = Tolerance::new(1e-8, [1e-8; 2]).expect("a valid tolerance");
    let step_state = StepState::new(tolerance, 0.0, [1.0, 0.0]).with_end(3.0);
    let mut solver = Radau::new(&f, |y: &[f64; 2]| Transient.jacobian(y), step_state);
    while solver.step_state().time() < 3.0 {
        solver.step().expect("a smooth motion");
    }
    let error = (solver.step_state().state()[0] - 3f64.sin()).abs();
    assert!(error < 1e-8, "{error:e}");
    assert!(solver.step_state().counts().accepted < 500, "{:?}", solver.step_state().counts());
}
