//! Particles: on springs, outside and inside circles, between lines.

use super::{CLOSE, evaluate_output, pose};
use crate::common::{kinds, run};
use approx::assert_abs_diff_eq;
use core::f64::consts::PI;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{oscillator, ring};

/// Upright, the spring pendulum is a damped oscillator about its stretched length, below, at and
/// above critical damping.
#[test]
fn a_mass_on_a_spring_follows_the_damped_oscillator() {
    let (m, k, l, g): (f64, f64, f64, f64) = (0.8, 20.0, 1.5, 9.81);
    let critical = 2.0 * (k * m).sqrt();
    for c in [0.0, 0.3, critical, 3.0 * critical] {
        let rest = l + m * g / k;
        let run = run(&SpringPendulum { m, k, l, c, g }, pose(&[("x", 0.0), ("y", rest + 0.2)]), &["t = 3"]);
        for t in [0.5, 1.7, 3.0] {
            let [x, v] = oscillator::released(m, c, k, t).map(|part| 0.2 * part);
            assert_abs_diff_eq!(evaluate_output(&run, "y", t), rest + x, epsilon = CLOSE);
            assert_abs_diff_eq!(evaluate_output(&run, "y'", t), v, epsilon = CLOSE);
            assert_abs_diff_eq!(
                evaluate_output(&run, "force(OP)", t),
                k * (rest - l + x) + c * v,
                epsilon = CLOSE
            );
        }
    }
}

#[test]
fn a_swinging_spring_keeps_its_energy() {
    let model = SpringPendulum { m: 1.0, k: 30.0, l: 1.0, c: 0.0, g: 9.81 };
    let run = run(&model, pose(&[("x", 0.9), ("y", 0.4)]), &["t = 10"]);
    for t in [2.0, 5.0, 10.0] {
        assert_abs_diff_eq!(evaluate_output(&run, "E", t), evaluate_output(&run, "E", 0.0), epsilon = CLOSE);
        // no couple acts about O but that of the weight
        assert_abs_diff_eq!(
            evaluate_output(&run, "x * py + y * px", t),
            evaluate_output(&run, "Lz", t),
            epsilon = CLOSE
        );
    }
}

#[test]
fn a_marble_leaves_the_ball_at_two_thirds() {
    let start = 0.1_f64;
    let model = Marble { m: 1.0, r: 1.0, g: 1.0 };
    let simulation = Simulation::new(&model).unwrap().tolerance(1e-13);
    let simulation = simulation.start(Pose::new("x", start.sin())).unwrap();
    let run = simulation.on_energy_of(Pose::new("x", 0.0)).unwrap().until("y = 0").unwrap().run().unwrap();
    let open = &run.events()[1];
    assert_eq!((open.kind, &open.supports[..]), (EventKind::Open, &["P"][..]));
    let leaving = (2.0_f64 / 3.0).acos();
    assert_abs_diff_eq!(open.state[1], 2.0 / 3.0, epsilon = CLOSE);
    assert_abs_diff_eq!(open.t, ring::outer_time(start, leaving), epsilon = CLOSE);
    for theta in [0.2_f64, 0.5, 0.8] {
        let t = ring::outer_time(start, theta);
        assert_abs_diff_eq!(evaluate_output(&run, "x", t), theta.sin(), epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "N(P)", t), ring::outer_reaction(theta), epsilon = CLOSE);
    }
}

#[test]
fn a_marble_loops_or_falls_off_the_ring() {
    let model = Looping { m: 1.0, r: 1.0, g: 1.0 };
    let start = |speed: f64| pose(&[("x", 0.0), ("y", -1.0), ("x'", speed)]);
    let slow = run(&model, start(1.8), &["t = 3"]);
    let leaving = ring::leaving_angle(1.8).unwrap();
    let open = &slow.events()[1];
    assert_eq!(open.kind, EventKind::Open);
    assert_abs_diff_eq!(open.state[1], -leaving.cos(), epsilon = CLOSE);
    assert_abs_diff_eq!(open.t, ring::inner_time(1.8, leaving), epsilon = CLOSE);

    let speed = 2.5;
    assert_eq!(ring::leaving_angle(speed), None);
    let fast = run(&model, start(speed), &["t = 4"]);
    assert_eq!(kinds(&fast), [(EventKind::Start, vec![]), (EventKind::Stop, vec![])]);
    for theta in [0.6, 2.0, PI] {
        let t = ring::inner_time(speed, theta);
        assert_abs_diff_eq!(evaluate_output(&fast, "x", t), theta.sin(), epsilon = CLOSE);
        assert_abs_diff_eq!(
            evaluate_output(&fast, "N(P)", t),
            ring::inner_reaction(speed, theta),
            epsilon = CLOSE
        );
    }
}

/// A bead in an inclined slot, as wide as `w`.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = slot(-a, (0, 0), w), stop)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Bead {
    m: f64,
    a: f64,
    w: f64,
    g: f64,
}

/// It slides down on the lower side; thrown up across, it reaches the other.
#[test]
fn a_bead_slides_along_its_slot_and_flies_across() {
    let (m, a, w, g) = (2.0, 0.4_f64, 0.3, 9.81);
    let (sin, cos) = a.sin_cos();
    let below = [-0.5 * w * sin, -0.5 * w * cos];
    let at_rest = [("x", below[0]), ("y", below[1])];
    let slide = run(&Bead { m, a, w, g }, pose(&at_rest), &["t = 1"]);
    let travel = 0.5 * g * sin;
    assert_abs_diff_eq!(evaluate_output(&slide, "x", 1.0), below[0] + travel * cos, epsilon = CLOSE);
    assert_abs_diff_eq!(evaluate_output(&slide, "y", 1.0), below[1] - travel * sin, epsilon = CLOSE);
    assert_abs_diff_eq!(evaluate_output(&slide, "N(P_lower)", 0.5), m * g * cos, epsilon = CLOSE);
    assert_eq!(evaluate_output(&slide, "N(P_upper)", 0.5), 0.0);

    let speed = 3.0;
    let thrown = [at_rest, [("x'", speed * sin), ("y'", speed * cos)]].concat();
    let flight = run(&Bead { m, a, w, g }, pose(&thrown), &["t = 1"]);
    let last = flight.events().last().unwrap();
    assert_eq!((last.kind, &last.supports[..]), (EventKind::Close, &["P_upper"][..]));
    let fall = g * cos;
    assert_abs_diff_eq!(last.t, (speed - (speed * speed - 2.0 * fall * w).sqrt()) / fall, epsilon = CLOSE);
}
