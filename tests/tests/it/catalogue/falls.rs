//! One bar falls on floors and walls.

use super::{CLOSE, evaluate_output};
use crate::common::{kinds, run};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::FRAC_PI_2;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{ladder, rod_on_floor, toppling_rod};

#[test]
fn ladder_leaves_the_wall() {
    let start = 75.0_f64.to_radians();
    let run = run(&Ladder { m: 1.0, l: 1.0, g: 1.0 }, Pose::new("phi", start), &["phi = 0"]);
    assert_eq!(
        kinds(&run),
        [(EventKind::Start, vec![]), (EventKind::Open, vec!["B"]), (EventKind::Stop, vec![])]
    );
    let open = &run.events()[1];
    let theta = ladder::leaving_angle(start);
    assert_abs_diff_eq!(open.state[0], theta, epsilon = CLOSE);
    assert_abs_diff_eq!(open.t, ladder::time(start, theta), epsilon = CLOSE);
    let (floor, drift) = (evaluate_output(&run, "N(A)", open.t), evaluate_output(&run, "vx(B)", open.t));
    assert_abs_diff_eq!(floor, 0.25, epsilon = CLOSE);
    assert!(drift.abs() < CLOSE, "B still touches the wall: {drift}");
    assert_abs_diff_eq!(run.end_time() - open.t, ladder::free_time(start, 0.0), epsilon = CLOSE);
    let omega = *run.final_state().get(3).unwrap();
    assert_abs_diff_eq!(omega, -ladder::free_rate_squared(start, 0.0).sqrt(), epsilon = CLOSE);
    for theta in [0.6, 0.3] {
        let t = open.t + ladder::free_time(start, theta);
        assert_abs_diff_eq!(
            evaluate_output(&run, "N(A)", t),
            ladder::free_floor_reaction(start, theta),
            epsilon = CLOSE
        );
    }
}

#[test]
fn rod_topples_without_lifting() {
    let start = 0.01;
    let run =
        run(&RodOnFloor { m: 1.0, l: 1.0, g: 1.0 }, Pose::new("phi", start).with("x", 0.0), &["phi = pi/2"]);
    assert_eq!(kinds(&run), [(EventKind::Start, vec![]), (EventKind::Stop, vec![])]);
    assert_abs_diff_eq!(run.end_time(), rod_on_floor::time(start, FRAC_PI_2), epsilon = CLOSE);
    let rate = evaluate_output(&run, "phi'", run.end_time());
    assert_relative_eq!(rate * rate, rod_on_floor::rate_squared(start, FRAC_PI_2), max_relative = CLOSE);
    let least = run.extrema(&Output::parse(RodOnFloor::LAYOUT, "N(A)").unwrap());
    let least = least.iter().filter(|e| e.minimum).map(|e| e.value).fold(f64::INFINITY, f64::min);
    assert!(least > 0.165 && least < 0.166, "{least}");
}

/// The reaction of the rough point touches zero where cos θ = ⅓, and the rod stays down.
#[test]
fn toppling_rod_does_not_lift() {
    let start = 0.1;
    let simulation = Simulation::new(&TopplingRod { m: 1.0, l: 1.0, g: 1.0 }).unwrap().tolerance(1e-13);
    let simulation = simulation.start(Pose::new("phi", start)).unwrap();
    let run =
        simulation.on_energy_of(Pose::new("phi", 0.0)).unwrap().until("phi = pi/2").unwrap().run().unwrap();
    assert_eq!(
        kinds(&run),
        [(EventKind::Start, vec![]), (EventKind::Touch, vec!["A"]), (EventKind::Stop, vec![])]
    );
    let touch = &run.events()[1];
    let theta = (1.0_f64 / 3.0).acos();
    assert_abs_diff_eq!(touch.state[0], theta, epsilon = CLOSE);
    assert_abs_diff_eq!(run.end_time(), toppling_rod::time(start, FRAC_PI_2), epsilon = CLOSE);
    for theta in [0.2, 0.5, 0.9, 1.2, 1.3, 1.5] {
        let t = toppling_rod::time(start, theta);
        assert_abs_diff_eq!(evaluate_output(&run, "phi", t), theta, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "N(A)", t), toppling_rod::reaction(theta), epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "R(A)", t), toppling_rod::friction(theta), epsilon = CLOSE);
    }
}

/// A floor of friction μ ≥ `ratio(A)` holds the rod until here.
#[test]
fn toppling_rod_would_slip_at() {
    for (mu, condition) in [(0.2, "ratio(A) = 0.2"), (0.5, "ratio(A) = -0.5")] {
        let simulation = Simulation::new(&TopplingRod { m: 1.0, l: 1.0, g: 1.0 }).unwrap().tolerance(1e-13);
        let simulation = simulation.start(Pose::new("phi", 0.1)).unwrap();
        let run =
            simulation.on_energy_of(Pose::new("phi", 0.0)).unwrap().until(condition).unwrap().run().unwrap();
        let slip = toppling_rod::slip_angle(mu).unwrap();
        assert_abs_diff_eq!(run.final_state()[0], slip, epsilon = CLOSE);
    }
}
