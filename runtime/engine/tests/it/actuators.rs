//! Drives of relative motions, against closed forms.

use liftoff::model::Layout;
use liftoff::prelude::*;

fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

fn value(record: &Trajectory, layout: &'static Layout, text: &str, t: f64) -> f64 {
    record.value(&Output::parse(layout, text).unwrap(), t)
}

/// Two free masses on a telescope.
#[derive(BarSystem)]
#[particle(A, mass = m)]
#[particle(B, mass = p)]
#[drive(distance(A, B) = l + b * sin(w * t))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(B))]
#[coordinate(v = y(B))]
#[figure(A = (0, 0), B = (2 * l, 0))]
struct Telescope {
    m: f64,
    p: f64,
    l: f64,
    b: f64,
    w: f64,
}

/// With the reduced mass μ and d = l + b sin ωt: d² φ̇ stays, and μ (d̈ − d φ̇²) pushes the masses apart.
#[test]
fn a_telescope_pushes_two_masses_apart() {
    let (m, p, l, b, w, spin) = (1.5, 0.8, 1.2, 0.3, 4.0, 0.9);
    let telescope = Telescope { m, p, l, b, w };
    // Both turn about A at first, with the rate of the distance along them.
    let pose = ["x", "y", "v", "x'", "y'"].iter().fold(Pose::at("u", l), |pose, name| pose.with(*name, 0.0));
    let pose = pose.with("u'", b * w).with("v'", l * spin);
    let record = run(Simulation::new(&telescope).unwrap().start(pose).unwrap().limit(2.0).tolerance(1e-12));
    for t in [0.4, 1.1, 1.9] {
        let at = |text: &str| value(&record, Telescope::LAYOUT, text, t);
        let (sin, cos) = (w * t).sin_cos();
        let (d, acceleration) = (l + b * sin, -b * w * w * sin);
        assert!(((at("u") - at("x")).hypot(at("v") - at("y")) - d).abs() < 1e-10, "{cos}");
        let turning = l * l * spin / (d * d);
        let force = m * p / (m + p) * (acceleration - d * turning * turning);
        let found = at("drive(distance(A, B))");
        assert!((found - force).abs() < 1e-9, "{t}: {found} for {force}");
        assert!((at("px") - p * b * w).abs() < 1e-10 && (at("py") - p * l * spin).abs() < 1e-10);
        assert!((at("Lz") - p * l * l * spin).abs() < 1e-9);
    }
}

/// Two bars on one pin, and a motor between them.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[bar(OB, mass = p, length = b)]
#[pin(O = (0, 0))]
#[drive(angle(OA, OB) = c * sin(w * t))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(OB), from = right)]
#[figure(A = (l, 0), B = (b, 0))]
struct Motor {
    m: f64,
    p: f64,
    l: f64,
    b: f64,
    c: f64,
    w: f64,
}

/// I₁ φ̇ + I₂ ψ̇ stays, and ψ − φ = f takes the torque I₁ I₂ f̈/(I₁ + I₂).
#[test]
fn a_motor_between_two_bars_turns_both() {
    let (m, p, l, b, c, w) = (1.5, 0.8, 1.2, 0.7, 0.5, 3.0);
    let (first, second) = (m * l * l / 3.0, p * b * b / 3.0);
    let share = second / (first + second);
    let pose = Pose::at("phi", 0.0).with("psi", 0.0).with("phi'", -share * c * w);
    let pose = pose.with("psi'", (1.0 - share) * c * w);
    let simulation = Simulation::new(&Motor { m, p, l, b, c, w }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(2.0).tolerance(1e-12));
    let at = |text: &str| value(&record, Motor::LAYOUT, text, 1.7);
    let sin = (w * 1.7).sin();
    assert!(
        (at("phi") + share * c * sin).abs() < 1e-10 && (at("psi") - (1.0 - share) * c * sin).abs() < 1e-10
    );
    let torque = -first * share * c * w * w * sin;
    assert!((at("drive(angle(OA, OB))") - torque).abs() < 1e-9, "{}", at("drive(angle(OA, OB))"));
}

/// A mass that a spindle draws along a bar.
#[derive(BarSystem)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = p)]
#[slider(P = bar(OB))]
#[drive(along(P, OB) = l / 2 + c * sin(w * t))]
#[coordinate(phi = angle(OB), from = right)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(B = (l, 0), P = (l / 2, 0))]
struct Spindle {
    m: f64,
    p: f64,
    l: f64,
    c: f64,
    w: f64,
}

/// With r driven (I + p r²) φ̇ stays, and the spindle pushes with p (r̈ − r φ̇²).
#[test]
fn a_spindle_draws_a_mass_along_a_turning_bar() {
    let (m, p, l, c, w, spin) = (1.5, 0.8, 1.2, 0.3, 3.0, 2.0);
    let pose = Pose::at("phi", 0.0).with("x", l / 2.0).with("y", 0.0).with("phi'", spin);
    let pose = pose.with("x'", c * w).with("y'", l / 2.0 * spin);
    let simulation = Simulation::new(&Spindle { m, p, l, c, w }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(2.0).tolerance(1e-12));
    let at = |text: &str| value(&record, Spindle::LAYOUT, text, 1.7);
    let inertia = |r: f64| m * l * l / 3.0 + p * r * r;
    let sin = (w * 1.7).sin();
    let r = l / 2.0 + c * sin;
    let turning = inertia(l / 2.0) * spin / inertia(r);
    assert!((at("phi'") - turning).abs() < 1e-9, "{}", at("phi'"));
    let force = p * (-c * w * w * sin - r * turning * turning);
    assert!((at("drive(along(P, OB))") - force).abs() < 1e-8, "{}", at("drive(along(P, OB))"));
    // What turns the mass turns the bar back, and the pin bears nothing else.
    let side = p * (2.0 * c * w * (w * 1.7).cos() * turning) + p * r * at("phi''");
    assert!((at("slider(P)") - side).abs() < 1e-8, "{} for {side}", at("slider(P)"));
}

/// Two wheels in mesh, each a bar about its pin; the second turns back twice as fast.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[bar(QB, mass = p, length = b)]
#[pin(O = (0, 0))]
#[pin(Q = (2 * l, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(QB), from = right)]
#[equal(psi, -2 * phi)]
#[couple(OA = c)]
#[torsion(QB, stiffness = k)]
#[figure(A = (l, 0), B = (2 * l + b, 0))]
struct Gears {
    m: f64,
    p: f64,
    l: f64,
    b: f64,
    c: f64,
    k: f64,
}

/// The second wheel's inertia and spring count fourfold: (I₁ + 4 I₂) φ̈ = c − 4 k φ, so that φ = c/4k (1 − cos Ωt).
#[test]
fn gears_turn_together() {
    let (m, p, l, b, c, k) = (1.5, 0.8, 1.2, 0.7, 0.9, 2.0);
    let gears = Gears { m, p, l, b, c, k };
    let pose = Pose::at("phi", 0.0).with("phi'", 0.0);
    let record = run(Simulation::new(&gears).unwrap().start(pose).unwrap().limit(3.0).tolerance(1e-12));
    let own = (4.0 * k / (m * l * l / 3.0 + 4.0 * p * b * b / 3.0)).sqrt();
    for t in [0.4, 1.7, 2.9] {
        let at = |text: &str| value(&record, Gears::LAYOUT, text, t);
        let phi = c / (4.0 * k) * (1.0 - (own * t).cos());
        assert!((at("phi") - phi).abs() < 1e-10, "{t}: {} for {phi}", at("phi"));
        let tip = 2.0 * l + b * (2.0 * phi).cos();
        assert!((at("x(B)") - tip).abs() < 1e-10 && (at("y(B)") + b * (2.0 * phi).sin()).abs() < 1e-10);
    }
}
