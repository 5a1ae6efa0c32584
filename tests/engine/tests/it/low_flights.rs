//! Contacts that lift off with their reaction at zero and land before their gap is more than
//! rounding.
//!
//! The feet of a falling A-frame with sin φ = s, S = 1 + ε, open where N/mg = ¼ − (3/2) s S + (9/4)
//! s² falls through zero, at s₁ = (S + √(S² − 1))/3, and would push again at s₂ = (S − √(S² −
//! 1))/3. Between the two the speed changes by a part of the order √ε only, so that the gap's
//! acceleration is as k τ (T − τ) and the gap as k (T τ³/6 − τ⁴/12): it closes after twice the time
//! T from s₁ to s₂, at 2 s₂ − s₁.

#![allow(clippy::duplicated_attributes, reason = "two bars may be as long as each other")]

use core::f64::consts::FRAC_PI_2;

use liftoff::method::{Dop853, Method, Radau, Taylor, Tsit5};
use liftoff::prelude::*;
use liftoff::{LogEntry, LoggedDecision};
use liftoff_fixtures::{AFrame, Particle};

const EXCESSES: [f64; 6] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// sin φ of the two events after the start.
fn opening_and_landing(excess: f64, method: impl Method, tolerance: f64) -> [f64; 2] {
    let start = 0.9_f64.asin();
    let spin = (3.0 * (1.0 + excess - start.sin())).sqrt();
    let simulation =
        Simulation::new(&AFrame { m: 1.0, l: 1.0, g: 1.0 }).unwrap().method(method).tolerance(tolerance);
    let run =
        simulation.start(Pose::new("phi", start).with("phi'", -spin)).unwrap().limit(1.0).run().unwrap();
    [1, 2].map(|k| run.events()[k].state[0].sin())
}

#[test]
fn feet_land_after_twice_the_time_without_pressure() {
    landings(&Taylor);
    landings(&Dop853);
    landings(&Tsit5);
    landings(&Radau);
}

fn landings(method: &(impl Method + Clone)) {
    let name = method.name();
    for (excess, tolerance) in EXCESSES.iter().flat_map(|e| [(*e, 1e-11), (*e, 1e-12)]) {
        let sum = 1.0 + excess;
        let half = (sum * sum - 1.0).sqrt() / 3.0;
        let [opens, lands] = opening_and_landing(excess, method.clone(), tolerance);
        assert!((opens - (sum / 3.0 + half)).abs() < 100.0 * tolerance / half, "{name} {excess:e}: {opens}");
        // The next order: the speed changes by a part of √ε over T.
        let within = excess + 400.0 * tolerance / half;
        let expected = sum / 3.0 - 3.0 * half;
        assert!((lands - expected).abs() < within, "{name} {excess:e} {tolerance:e}: {lands} for {expected}");
    }
}

/// h = v t + g t²/2, from heights below and above what counts as zero behind an event.
#[test]
fn falls_from_low_heights_end_on_the_floor() {
    let ball = Particle { m: 1.0, g: 9.81, e: 0.9 };
    let mut falls = 0;
    for (tolerance, heights) in [
        (1e-6, [1e-9, 1e-8, 3e-7, 9.8e-7, 9.9e-7, 1.01e-6, 1.02e-6, 3e-6, 9e-6, 1e-5, 1.1e-5]),
        (1e-9, [2e-10, 1e-9, 5e-9, 9e-9, 9.9e-9, 1e-8, 1.01e-8, 1e-7, 1e-6, 1e-5, 1e-4]),
    ] {
        for (h, v) in heights.into_iter().flat_map(|h| [0.0, 1e-3, 1.0].map(|v| (h, v))) {
            let start = Pose::new("y", h).with("y'", -v).with("x'", 1.0);
            let lands = 2.0 * h / (v + (v * v + 2.0 * ball.g * h).sqrt());
            let simulation = Simulation::new(&ball).unwrap().tolerance(tolerance).start(start).unwrap();
            let run = simulation.limit(lands + 0.01).run().unwrap();
            let impact = &run.events()[1];
            assert_eq!(impact.kind, EventKind::Impact, "{h:e} {v:e} {tolerance:e}");
            assert!(
                (impact.t / lands - 1.0).abs() < 1e-6,
                "{h:e} {v:e} {tolerance:e}: {:e} {lands:e}",
                impact.t
            );
            assert!(run.final_state()[1] > -1e-2 * h, "{h:e} {v:e} {tolerance:e}: {:?}", run.final_state());
            falls += 1;
        }
    }
    assert_eq!(falls, 66);
}

/// Two tents side by side with bars of unlike masses: released beside upright by δ, their motion is
/// linear in δ, so that A opens and lands at times that do not depend on it, as high as δ².
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(9.81)]
#[support(A = floor)]
#[bar(AB, mass = 0.96, length = 0.83)]
#[coordinate(phi_0 = angle(AB), from = horizontal)]
#[bar(BC, mass = 0.79, length = 0.83)]
#[coordinate(phi_1 = angle(BC), from = horizontal)]
#[support(C = floor)]
#[support(B = floor, stop)]
#[bar(CD, mass = 1.06, length = 0.62)]
#[coordinate(phi_2 = angle(CD), from = horizontal)]
#[bar(DE, mass = 1.14, length = 0.62)]
#[coordinate(phi_3 = angle(DE), from = horizontal)]
#[support(E = floor)]
#[support(D = floor, stop)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[figure(A = (0, 0), B = (0.4980, 0.6640), C = (0.9960, 0), D = (1.3680, 0.4960), E = (1.7400, 0))]
struct TwoTents {}

#[test]
fn low_landings_are_found_or_reported() {
    for delta in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let factors = [0.7187810373376886, 0.7187810373376886, 1.337577975662573, 1.337577975662573];
        let angle = |(k, factor): (usize, f64)| (format!("phi_{k}"), FRAC_PI_2 - factor * delta);
        let angles = factors.into_iter().enumerate().map(angle);
        let pose =
            angles.fold(Pose::new("x", 0.0).with("y", 0.0), |pose, (name, value)| pose.with(&name, value));
        let run =
            Simulation::new(&TwoTents {}).unwrap().start(pose).unwrap().until_event(EventKind::Impact, "A");
        let run = run.unwrap().limit(1.0).run().unwrap();
        let lands = run.events().last().unwrap().t;
        let unresolved = |entry: &LogEntry| {
            matches!(entry.decision, LoggedDecision::LandingUnresolved { contact: "A", .. })
        };
        if delta > 1e-7 {
            assert!((lands - 0.48138).abs() < 1e-4, "{delta:e}: {lands}");
        } else {
            assert!(run.log().iter().any(unresolved), "{delta:e}: {lands}");
        }
    }
}
