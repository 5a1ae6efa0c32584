//! What walks and throws.

use super::{CLOSE, evaluate_output, pose};
use crate::common::{kinds, prepared};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::{FRAC_PI_2, PI};
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::compass::{Compass, Stride};
use liftoff_tests::catalogue::{jansen, trebuchet};

const SLOPE: f64 = PI / 60.0;
/// Goswami, Thuilot and Espiau 1998, of a slope of 3°, where g = 9.8 m/s².
const PUBLISHED: Stride = [0.2187, -1.0918, -0.3772];

fn compass() -> Compass {
    Compass { leg: 5.0, hip: 10.0, a: 0.5, b: 0.5, slope: SLOPE, g: 9.81 }
}

/// Steps of the model from a stride of the leg HA.
fn walked([angle, stance, swing]: Stride, until: &str) -> Trajectory {
    let model = CompassWalker { m: 5.0, hip: 10.0, j: 0.0, a: 0.5, b: 0.5, gamma: SLOPE, s: 0.5347, g: 9.81 };
    let legs = [("left", angle), ("right", -2.0 * SLOPE - angle), ("left'", stance), ("right'", swing)];
    let foot = [("x", 0.0), ("y", 0.0), ("x'", 0.0), ("y'", 0.0)];
    prepared(&model, pose(&[legs, foot].concat()), &[until]).run().unwrap()
}

/// The leg that stands after a step, its rate, and that of the other.
fn stride(step: usize, event: &Event) -> Stride {
    let [stance, swing] = if step.is_multiple_of(2) { ["right", "left"] } else { ["left", "right"] };
    [event[stance], event[&format!("{stance}'")], event[&format!("{swing}'")]]
}

/// The gait that comes back is the published one, and the walker's, to what errors of a step grow
/// to in six.
#[test]
fn a_compass_walks_in_its_published_gait() {
    let theirs = Compass { g: 9.8, ..compass() };
    for (found, published) in theirs.gait(PUBLISHED).unwrap().iter().zip(PUBLISHED) {
        assert_abs_diff_eq!(*found, published, epsilon = 5e-5);
    }
    let gait = compass().gait(PUBLISHED).unwrap();
    let (_, step) = compass().next(gait).unwrap();
    let run = walked(gait, "t = 4.6");
    let strikes: Vec<&Event> = run.events().iter().filter(|e| e.kind == EventKind::Impact).collect();
    assert_eq!(strikes.len(), 6, "{:?}", kinds(&run));
    for (k, strike) in strikes.iter().enumerate() {
        assert_eq!(strike.supports, [if k.is_multiple_of(2) { "B" } else { "A" }]);
        assert_abs_diff_eq!(strike.t, (k + 1) as f64 * step, epsilon = 1e-9);
        for (found, expected) in stride(k, strike).iter().zip(gait) {
            assert_abs_diff_eq!(*found, expected, epsilon = 1e-8);
        }
    }
}

/// Beside its gait each step is what the equations of a step make of the one before, and they come
/// back to it.
#[test]
fn a_compass_finds_back_to_its_gait() {
    let gait = compass().gait(PUBLISHED).unwrap();
    let mut expected = [gait[0] + 0.004, gait[1] - 0.01, gait[2]];
    let run = walked(expected, "t = 15");
    let strikes = run.events().iter().filter(|e| e.kind == EventKind::Impact);
    let strides: Vec<Stride> = strikes.enumerate().map(|(k, strike)| stride(k, strike)).collect();
    assert!(strides.len() >= 20);
    for found in &strides[..4] {
        expected = compass().next(expected).unwrap().0;
        for (found, expected) in found.iter().zip(expected) {
            assert_abs_diff_eq!(*found, expected, epsilon = 1e-8);
        }
    }
    let away = |stride: &Stride| stride.iter().zip(gait).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
    assert!(away(&strides[19]) < 0.05 * away(&strides[0]), "{} {}", away(&strides[0]), away(&strides[19]));
}

/// The stone leaves the trough, and the sling the beam, when and as Lagrange's equations say.
#[test]
fn a_trebuchet_throws_as_computed() {
    let (m, weight, stone, [a, b, c, s], release, g) = (12.0, 160.0, 1.5, [0.4, 1.7, 0.5, 1.6], 3.1, 9.81);
    let lengths = [a, b, c, s];
    let by_hand = trebuchet::Trebuchet { beam: m, weight, spin: weight * c * c / 6.0, stone, lengths, g };
    let theta = -(4.0_f64 / 3.0).atan();
    let (lifted, free) = by_hand.lifted([theta, 0.0, FRAC_PI_2]).unwrap();
    let (flight, thrown) = by_hand.released(free, -release).unwrap();
    let model = Trebuchet { m, weight, stone, a, b, c, s, release, g };
    let run = prepared(&model, Pose::nominal(), &["t = 1"]).run().unwrap();
    let [open, gone] = [EventKind::Open, EventKind::Disarm]
        .map(|kind| run.events().iter().find(|event| event.kind == kind).unwrap());
    assert_eq!((&open.supports[..], &gone.supports[..]), (&["P"][..], &["sling"][..]));
    assert_abs_diff_eq!(open.t, lifted, epsilon = 1e-9);
    assert_abs_diff_eq!(gone.t, lifted + flight, epsilon = 1e-9);
    for (name, expected) in ["psi", "psi'", "theta'"].iter().zip([thrown[1], thrown[4], thrown[3]]) {
        assert_abs_diff_eq!(gone[name], expected, epsilon = 1e-8);
    }
    for (name, expected) in ["x'", "y'"].iter().zip(by_hand.velocity(&thrown)) {
        assert_relative_eq!(gone[name], expected, max_relative = 1e-9);
    }
}

/// Points are where circles meet; the drive bears the weight where the crank hardly turns.
#[test]
fn jansens_leg_steps_along_the_ground() {
    let (rho, u, omega, g) = (2.0, 0.01, 1e-4, 9.81);
    let run = prepared(&JansenLeg { rho, u, omega: 1.0, g }, Pose::nominal(), &["t = 6.3"]).run().unwrap();
    for k in 0..63 {
        let phi = 0.1 * f64::from(k);
        for (name, place) in jansen::NAMES.iter().zip(jansen::places(phi)) {
            for (axis, expected) in ["x", "y"].iter().zip(place) {
                assert_abs_diff_eq!(
                    evaluate_output(&run, &format!("{axis}({name})"), phi),
                    u * expected,
                    epsilon = CLOSE
                );
            }
        }
    }
    // Along the ground the foot stays level within a fiftieth of its stride.
    let feet: Vec<[f64; 2]> = (0..360).map(|k| jansen::places(f64::from(k) * PI / 180.0)[5]).collect();
    let lowest = feet.iter().map(|foot| foot[1]).fold(f64::INFINITY, f64::min);
    let level = feet.iter().filter(|foot| foot[1] < lowest + 1.2).map(|foot| foot[0]);
    let [from, to] = level.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    assert!(to - from > 50.0, "{}", to - from);
    let slow = prepared(&JansenLeg { rho, u, omega, g }, Pose::nominal(), &["t = 1"]).run().unwrap();
    let step = 1e-4;
    let moment = rho * u * u * g * (jansen::lift(step) - jansen::lift(-step)) / (2.0 * step);
    // Central differences are within step² of the third derivative; the crank's rate adds ω² times
    // inertias.
    assert_relative_eq!(evaluate_output(&slow, "drive(phi)", 0.0), moment, max_relative = 1e-6);
}

/// Each half swing is that of a damped oscillator about 0, or about push/k while the escapement
/// pushes.
#[test]
fn a_balance_wheel_comes_to_one_swing() {
    let (inertia, k, c, push, first) = (0.5, 20.0, 0.3, 1.5, -0.2);
    let model = BalanceWheel { m: 2.0, inertia, r: 1.0, k, c, push };
    let run = prepared(&model, Pose::new("phi", first), &["t = 40"]).run().unwrap();
    let (omega, zeta) = ((k / inertia).sqrt(), 0.5 * c / (k * inertia).sqrt());
    let half = PI / (omega * (1.0 - zeta * zeta).sqrt());
    let left = (-PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
    // At rest it does not turn forwards, but does so from there on.
    assert_eq!((run.events()[1].kind, run.events()[1].t), (EventKind::Arm, 0.0));
    let mut phi = first;
    for (n, event) in run.events()[2..run.events().len() - 1].iter().enumerate() {
        let forwards = n % 2 == 0;
        let centre = if forwards { push / k } else { 0.0 };
        phi = centre - left * (phi - centre);
        assert_eq!(event.kind, if forwards { EventKind::Disarm } else { EventKind::Arm });
        assert_eq!(event.supports, ["couple escapement"]);
        assert_abs_diff_eq!(event.t, half * (n + 1) as f64, epsilon = 1e-9);
        assert_abs_diff_eq!(event["phi"], phi, epsilon = 1e-9);
    }
    assert!(run.events().len() > 75, "{}", run.events().len());
    assert_abs_diff_eq!(phi.abs().max(phi.abs() / left), push / (k * (1.0 - left)), epsilon = 1e-3);
}
