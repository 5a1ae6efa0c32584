//! Loads, rigid bodies, welds and torsion springs in motions that have closed forms.

use super::{CLOSE, evaluate_output, pose};
use crate::common::run;
use approx::assert_abs_diff_eq;
use core::f64::consts::PI;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{oscillator, parallelogram};

/// A point thrown through air that resists in proportion to speed, pushed by a swinging wind.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[force(drag = (-c * vx(P), -c * vy(P)), at = P)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Thrown {
    m: f64,
    c: f64,
    g: f64,
}

#[test]
fn a_throw_with_drag() {
    let (m, c, g, v) = (0.7, 0.4, 9.81, 12.0);
    let start = pose(&[("x", 0.0), ("y", 0.0), ("x'", v), ("y'", v)]);
    let run = run(&Thrown { m, c, g }, start, &["t = 2"]);
    let (time, fall) = (m / c, m * g / c);
    for t in [0.3, 1.0, 2.0] {
        let gone = -(-t / time).exp_m1();
        assert_abs_diff_eq!(evaluate_output(&run, "x", t), v * time * gone, epsilon = CLOSE);
        assert_abs_diff_eq!(
            evaluate_output(&run, "y", t),
            (v + fall) * time * gone - fall * t,
            epsilon = CLOSE
        );
    }
}

/// A crank on a torsion spring with damping, moved by a couple.
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[torsion(OA, stiffness = k, angle = a, damping = c)]
#[couple(OA = f * t)]
#[coordinate(phi = angle(OA))]
struct Balance {
    m: f64,
    l: f64,
    k: f64,
    a: f64,
    c: f64,
    f: f64,
}

/// The couple f t moves it as a displaced rest does, a + f t/k − f c/k², with the oscillation that
/// makes up for it.
#[test]
fn a_balance_under_a_growing_couple() {
    let (m, l, k, a, c, f) = (1.5, 0.8, 4.0, 0.6, 0.3, 0.5);
    let inertia = m * l * l / 3.0;
    let shift = f * c / (k * k);
    let run = run(&Balance { m, l, k, a, c, f }, pose(&[("phi", 1.0), ("phi'", f / k)]), &["t = 5"]);
    for t in [0.5, 2.0, 5.0] {
        let [x, v] = oscillator::released(inertia, c, k, t).map(|part| (1.0 - a + shift) * part);
        assert_abs_diff_eq!(evaluate_output(&run, "phi", t), a + f * t / k - shift + x, epsilon = CLOSE);
        let rate = f / k + v;
        assert_abs_diff_eq!(evaluate_output(&run, "phi'", t), rate, epsilon = CLOSE);
        let torque = -k * (f * t / k - shift + x) - c * rate;
        assert_abs_diff_eq!(evaluate_output(&run, "torque(OA)", t), torque, epsilon = CLOSE);
    }
}

/// A point on a spring without a length of its own, whose ends meet.
#[derive(BarSystem, Clone, Debug)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k, length = 0, damping = 0)]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Drawn {
    m: f64,
    k: f64,
}

/// It starts where they do: x = (v/ω) sin ω t, ω² = k/m.
#[test]
fn a_spring_whose_ends_meet() {
    let start = pose(&[("x", 0.0), ("y", 0.0), ("x'", 2.0), ("y'", 0.0)]);
    let run = run(&Drawn { m: 1.0, k: 4.0 }, start, &["t = 2"]);
    for t in [0.0, 0.5, 2.0] {
        assert_abs_diff_eq!(evaluate_output(&run, "x", t), (2.0 * t).sin(), epsilon = CLOSE);
    }
}

/// Two bars about pins of their own, joined by a torsion spring; one is read from below, the other
/// from the left.
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = m, length = l)]
#[bar(PB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(P = (2 * l, 0))]
#[torsion(OA, PB, stiffness = k, angle = a)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(PB), from = left)]
#[figure(A = (0, -l), B = (l, 0))]
struct Wound {
    m: f64,
    l: f64,
    k: f64,
    a: f64,
}

/// Down is −π/2 and left is π: from one to the other is a quarter turn clockwise, within half a turn.
#[test]
fn a_torsion_spring_between_two_references() {
    let (k, a) = (3.0, -1.8);
    let run = run(&Wound { m: 1.2, l: 0.8, k, a }, pose(&[("phi", 0.1), ("psi", 0.2)]), &["t = 0.5"]);
    for t in [0.0, 0.5] {
        let wound = -0.5 * PI + evaluate_output(&run, "psi", t) - evaluate_output(&run, "phi", t) - a;
        assert_abs_diff_eq!(evaluate_output(&run, "torque(OA, PB)", t), -k * wound, epsilon = CLOSE);
    }
}

/// A bar that a motor presses onto a floor on the left of its pin, and another about the same pin,
/// joined to it by a torsion spring.
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = m, length = l)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[support(A = floor(0))]
#[couple(press = c, on = OA)]
#[torsion(OA, OB, stiffness = k, angle = a)]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(OB), from = right)]
#[figure(A = (-l, 0), B = (0, l))]
struct Pressed {
    m: f64,
    l: f64,
    c: f64,
    k: f64,
    a: f64,
}

/// On the floor φ = π, and J ψ̈ = −k (ψ − π − a): the angle that the closed form of the set puts
/// for φ keeps its half turn.
#[test]
fn a_torsion_spring_from_a_bar_that_lies() {
    let (m, l, k, a) = (1.5, 0.6, 2.0, -1.0);
    let start = pose(&[("phi", PI), ("psi", 2.0), ("phi'", 0.0), ("psi'", 0.0)]);
    let run = run(&Pressed { m, l, c: 9.0, k, a }, start, &["t = 1"]);
    assert_eq!(run.segments().len(), 1);
    assert_eq!(run.segments()[0].form, Form::Reduced);
    let frequency = (3.0 * k / (m * l * l)).sqrt();
    for t in [0.0, 0.4, 1.0] {
        let wound = (2.0 - PI - a) * (frequency * t).cos();
        assert_abs_diff_eq!(evaluate_output(&run, "psi", t), PI + a + wound, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "torque(OA, OB)", t), -k * wound, epsilon = CLOSE);
    }
}

/// The same bars turned against each other by a motor.
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = m, length = l)]
#[bar(PB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(P = (2 * l, 0))]
#[drive(angle(OA, PB) = -pi / 2 + w * t)]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(PB), from = left)]
#[figure(A = (0, -l), B = (l, 0))]
struct Motor {
    m: f64,
    l: f64,
    w: f64,
}

#[test]
fn a_motor_between_two_references() {
    let start = pose(&[("phi", 0.1), ("psi", 0.1), ("phi'", 0.0), ("psi'", 0.4)]);
    let run = run(&Motor { m: 1.2, l: 0.8, w: 0.4 }, start, &["t = 0.5"]);
    assert_abs_diff_eq!(
        evaluate_output(&run, "psi", 0.5) - evaluate_output(&run, "phi", 0.5),
        0.2,
        epsilon = CLOSE
    );
}

/// Two bars welded at a right angle.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[weld(OA, AB)]
#[figure(A = (0, -l), B = (l, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Elbow {
    m: f64,
    l: f64,
    g: f64,
}

/// A triangular plate hung from its right angle.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[body(plate, points(O = (0, 0), A = (l, 0), B = (0, l)), mass = m)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0), B = (0, l))]
#[coordinate(phi = angle(plate))]
struct Plate {
    m: f64,
    l: f64,
    g: f64,
}

/// Inertia about the hinge 5/3 m l², centre (3/4, 1/4) l for the elbow; m l²/3 and (1/3, 1/3) l for
/// the plate.
#[test]
fn rigid_pendulums_have_their_periods() {
    let (m, l, g) = (1.2, 0.5, 9.81);
    let amplitude = 1.3;
    let hanging = (1.0_f64 / 3.0).atan();
    let elbow =
        run(&Elbow { m, l, g }, Pose::new("phi", amplitude - hanging), &[&format!("phi = -{hanging}")]);
    let square = 2.0 * g * 10.0_f64.sqrt() / 4.0 * 3.0 / (5.0 * l);
    assert_abs_diff_eq!(4.0 * elbow.end_time(), parallelogram::period(square, amplitude), epsilon = CLOSE);

    let hanging = -0.75 * PI;
    let plate = run(&Plate { m, l, g }, Pose::new("phi", hanging + amplitude), &["phi = -3 * pi / 4"]);
    let square = 2.0_f64.sqrt() * g / l;
    assert_abs_diff_eq!(4.0 * plate.end_time(), parallelogram::period(square, amplitude), epsilon = CLOSE);
}

/// The frame comes to rest on its springs: the feet bear the weight in halves and push inwards,
/// every joint's spring bears the moment of what is beyond.
#[test]
fn a_walking_frame_comes_to_stand() {
    let (m, l, a, k, c, g) = (10.0, 1.0, 0.75_f64.atan(), 400.0, 20.0, 9.81);
    let run = run(&Walker { m, l, a, k, c, g }, Pose::nominal(), &["t = 20"]);
    let end = |output: &str| evaluate_output(&run, output, 20.0);
    assert_abs_diff_eq!(end("T"), 0.0, epsilon = CLOSE);
    let half = 0.8 * m * g;
    for foot in ["N(P)", "N(Q)"] {
        assert_abs_diff_eq!(end(foot), half, epsilon = CLOSE);
    }
    assert_abs_diff_eq!(end("R(P)"), -end("R(Q)"), epsilon = CLOSE);
    assert!(end("R(P)") > 0.0);
    // at the right knee the shin and what its foot bears are balanced by the spring alone
    let (across, up) = (end("x(Q) - x(J)"), end("y(Q) - y(J)"));
    let moment = across * end("N(Q)") - up * end("R(Q)") - 0.05 * m * g * across;
    assert_abs_diff_eq!(end("torque(right, right_shin)"), -moment, epsilon = CLOSE);
    assert!(end("y(H)") < 0.9 * l);
}
