//! Drives far from natural units.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_fixtures::QuickReturn;

/// The completed rates satisfy the drive up to a rounding of its own rate; tan ψ = (h + r sin φ)/(r
/// cos φ).
#[test]
fn a_start_fits_a_drive_of_any_rate_and_size() {
    for (omega, size) in [(1.0, 1.0), (1e6, 1.0), (1.0, 1e-6), (1e6, 1e-6)] {
        let model = QuickReturn { a: 1.0, b: 1.0, r: size, l: 4.0 * size, h: 2.0 * size, omega };
        let run = Simulation::new(&model).unwrap().limit(1.0 / omega).run().unwrap();
        let psi = run.value(&run.output("psi").unwrap(), 1.0 / omega);
        let exact = (2.0 + 1f64.sin()).atan2(1f64.cos());
        assert!((psi - exact).abs() < 1e-9, "{omega} {size} {psi} {exact}");
    }
}

/// A crank that is turned until its drive has no angle any more.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[drive(phi = sqrt(c - w * t))]
struct Halted {
    m: f64,
    l: f64,
    c: f64,
    w: f64,
    g: f64,
}

/// The run stops there, by each method, and all that it has before is numbers.
#[test]
fn a_drive_that_ends_stops_the_run() {
    let model = Halted { m: 1.0, l: 1.0, c: 1.0, w: 1.0, g: 9.81 };
    for method in MethodId::ALL {
        let simulation = Simulation::new(&model).unwrap().method(method).limit(2.0);
        let error = simulation.run().expect_err("the drive has no angle behind t = 1");
        let run = error.trajectory();
        let phi = run.output("phi").unwrap();
        assert!((run.end_time() - 1.0).abs() < 1e-6, "{method:?} {}: {error}", run.end_time());
        for k in 0..=1000 {
            let t = run.end_time() * f64::from(k) / 1000.0;
            let value = run.value(&phi, t);
            assert!((value - (1.0 - t).sqrt()).abs() < 1e-6, "{method:?} {t} {value}");
        }
    }
}

/// A crank that a drive swings, and nothing else tells the time.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[drive(phi = b * sin(w * t - p))]
struct Swung {
    m: f64,
    l: f64,
    b: f64,
    w: f64,
    p: f64,
}

/// It starts where it turns round: b ω cos(π/2) is 6e-17 of ω, not the rate that tells the time.
#[test]
fn a_drive_that_starts_where_it_turns_round_tells_the_time() {
    for w in [2f64.powi(-30), 1.0, 2f64.powi(30)] {
        let model = Swung { m: 1.0, l: 1.0, b: 0.3, w, p: core::f64::consts::FRAC_PI_2 };
        for rate in [Some(0.0), None] {
            let start = Pose::new("phi", -0.3);
            let start = rate.map_or(start.clone(), |rate| start.with("phi'", rate));
            let simulation = Simulation::new(&model).unwrap().start(start).unwrap().limit(3.0 / w);
            let natural = simulation.scales().time * w;
            assert!((0.1..10.0).contains(&natural), "{w}: {natural}");
            let run = simulation.run().unwrap();
            let phi = run.value(&run.output("phi").unwrap(), 2.0 / w);
            assert!((phi + 0.3 * 2f64.cos()).abs() < 1e-9, "{w} {phi}");
        }
    }
}
