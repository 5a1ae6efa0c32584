//! Closed forms that are singular within a step: what they give near such a place is off by a power
//! of 1/p.

use liftoff::prelude::*;

/// A bar whose line is held at the origin: y cos θ = x sin θ, which leaves x only where cos θ ≠ 0.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(0)]
#[bar(AB, mass = m, length = l)]
#[support(P = corner(0, 0), under = AB)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
struct HeldBar {
    m: f64,
    l: f64,
}

/// Turned about its centre it turns on, at each time by the same. Steps of loose tolerances are so
/// long that they pass θ = π/2 between places where the closed form is regular.
#[test]
fn a_step_does_not_pass_a_singular_elimination() {
    let bar = HeldBar { m: 1.0, l: 1.0 };
    for tolerance in [1e-5, 1e-6, 1e-8, 1e-10] {
        let start = Pose::new("x", -0.5).with("y", 0.0).with("theta", 0.0);
        let start = start.with("theta'", 1.0).with("y'", -0.5);
        let spinning = Simulation::new(&bar).unwrap().start(start).unwrap();
        let run = spinning.hold("P").unwrap().tolerance(tolerance).limit(3.0).run().unwrap();
        let outputs = ["x", "y", "theta", "x'", "y'", "theta'"].map(|name| run.output(name).unwrap());
        for k in -200..=200 {
            let t = core::f64::consts::FRAC_PI_2 + 1e-4 * f64::from(k);
            let exact = [-0.5 * t.cos(), -0.5 * t.sin(), t, 0.5 * t.sin(), -0.5 * t.cos(), 1.0];
            let off = |(output, exact): (&Output, f64)| (run.value(output, t) - exact).abs();
            let off = outputs.iter().zip(exact).map(off).fold(0.0, f64::max);
            assert!(off < 100.0 * tolerance, "off by {off:e} at {t}: {tolerance:e}");
        }
    }
}
