//! Four bars released almost upright: their contacts with the floor depend on each other but for
//! cos φ.

use core::f64::consts::FRAC_PI_2;

use liftoff_core::scalar::Scalar;
use liftoff_judge::{Judge, Task};

const GRAVITY: f64 = 9.81;

const ZIGZAG: &str = "
    #[gravity(g)]
    #[bar(AB, mass = m2, length = l)]
    #[bar(BC, mass = m1, length = l)]
    #[bar(CD, mass = m1, length = l)]
    #[bar(DE, mass = m2, length = l)]
    #[support(A = floor)]
    #[support(C = floor)]
    #[support(E = floor)]
    #[support(B = floor, stop)]
    #[support(D = floor, stop)]
    #[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
    #[coordinate(phi_inner = angle(CD), from = horizontal)]
    #[coordinate(phi_outer = angle(DE), from = horizontal)]
    #[coordinate(y = y(C))]
    #[mirror(x = 0)]
    struct Zigzag { m1: f64, m2: f64, l: f64, g: f64 }";

/// δ = π/2 − φ after a time by Runge and Kutta's method, from the energy of a fall in which all
/// angles are equal, (1/3 + 2 λ cos² δ) δ″ = 2 λ sin δ cos δ δ′² + g/(2 l) sin δ.
fn fall(lambda: f64, delta: f64, t: f64) -> f64 {
    const STEPS: usize = 20_000;
    let h = t / STEPS as f64;
    let slope = |[u, v]: [f64; 2]| {
        let (sin, cos) = u.sin_cos();
        [v, (2.0 * lambda * cos * v * v + 0.5 * GRAVITY) * sin / (1.0 / 3.0 + 2.0 * lambda * cos * cos)]
    };
    let mut y = [delta, 0.0];
    for _ in 0..STEPS {
        let moved = |s: [f64; 2], h: f64| [y[0] + h * s[0], y[1] + h * s[1]];
        let a = slope(y);
        let b = slope(moved(a, 0.5 * h));
        let c = slope(moved(b, 0.5 * h));
        let d = slope(moved(c, h));
        for i in 0..2 {
            y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        }
    }
    y[0]
}

#[test]
fn bars_fall_together() {
    for lambda in [0.1, 0.5, 0.75] {
        let judge =
            Judge::new(ZIGZAG, &[1.0 - lambda, lambda, 1.0, GRAVITY], &["phi_inner", "phi_outer", "y"]);
        let judge = judge.unwrap_or_else(|error| panic!("{error}"));
        for delta in [1e-1, 1e-4, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15] {
            let phi = FRAC_PI_2 - delta;
            // What π/2 is more than its double.
            let delta = FRAC_PI_2 - phi + 6.123_233_995_736_766e-17;
            let k = 1.5 * GRAVITY / (1.0 + 6.0 * lambda);
            let until = (0.5 / delta).ln() / k.sqrt();
            let motion =
                judge.follow(&Task { state: &[phi, phi, 0.0, 0.0, 0.0, 0.0], until, ..Task::default() });
            assert!(motion.stopped.is_none() && motion.events.is_empty(), "{lambda}, {delta:e}: {motion:?}");
            let expected = fall(lambda, delta, until);
            for phi in &motion.end[..2] {
                let found = FRAC_PI_2 - phi.to_f64();
                assert!((found - expected).abs() < 1e-11, "{lambda}, {delta:e}: {found}, not {expected}");
            }
        }
    }
}
