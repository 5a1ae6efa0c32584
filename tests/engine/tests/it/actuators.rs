//! Drives of relative motions, against closed forms.

use liftoff::RunCause;
use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_core::model::Layout;

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

/// With the reduced mass μ and d = l + b sin ωt: d² φ̇ stays, and μ (d̈ − d φ̇²) pushes the masses
/// apart.
#[test]
fn a_telescope_pushes_two_masses_apart() {
    let (m, p, l, b, w, spin) = (1.5, 0.8, 1.2, 0.3, 4.0, 0.9);
    let telescope = Telescope { m, p, l, b, w };
    // Both turn about A at first, with the rate of the distance along them.
    let pose = ["x", "y", "v", "x'", "y'"].iter().fold(Pose::new("u", l), |pose, name| pose.with(*name, 0.0));
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
    let pose = Pose::new("phi", 0.0).with("psi", 0.0).with("phi'", -share * c * w);
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
    let pose = Pose::new("phi", 0.0).with("x", l / 2.0).with("y", 0.0).with("phi'", spin);
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

/// The second wheel's inertia and spring count fourfold: (I₁ + 4 I₂) φ̈ = c − 4 k φ, so that φ =
/// c/4k (1 − cos Ωt).
#[test]
fn gears_turn_together() {
    let (m, p, l, b, c, k) = (1.5, 0.8, 1.2, 0.7, 0.9, 2.0);
    let gears = Gears { m, p, l, b, c, k };
    let pose = Pose::new("phi", 0.0).with("phi'", 0.0);
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

/// Two masses on a telescope that is drawn in evenly; the second from a time on.
#[derive(BarSystem)]
#[particle(A, mass = m)]
#[particle(B, mass = m)]
#[drive(distance(A, B) = a - v * t)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(B))]
#[coordinate(w = y(B))]
#[figure(A = (0, 0), B = (1, 0))]
struct DrawnIn {
    m: f64,
    a: f64,
    v: f64,
}

/// A distance that is not above zero at t = 0 is no distance: −1 was taken as 1.
#[test]
fn a_driven_distance_begins_above_zero() {
    for a in [-1.0, 0.0] {
        let told = Simulation::new(&DrawnIn { m: 1.0, a, v: 0.5 }).err().unwrap().to_string();
        let expected =
            format!("`drive(distance(A, B) = …)` prescribes {a} at t = 0: a distance is above zero");
        assert!(told.starts_with(&expected), "{told}");
    }
}

/// It comes to zero at a/v, and the run ends there; what is prescribed is an output.
#[test]
fn a_driven_distance_that_comes_to_zero_ends_a_run() {
    for method in [MethodId::Auto, MethodId::Taylor, MethodId::Dop853, MethodId::Radau] {
        for spin in [0.0, 1e-7] {
            let drawn = DrawnIn { m: 1.0, a: 1.0, v: 0.5 };
            let pose =
                [("x", 0.0), ("y", 0.0), ("w", 0.0), ("x'", 0.0), ("y'", 0.0), ("u'", -0.5), ("w'", spin)];
            let pose = pose.iter().fold(Pose::new("u", 1.0), |pose, (name, value)| pose.with(*name, *value));
            let run = Simulation::new(&drawn).unwrap().start(pose).unwrap().method(method).limit(3.0).run();
            let error = run.map(|_| ()).unwrap_err();
            let RunCause::DrivenDistance { t, drive } = error.cause() else { panic!("{method:?} {error}") };
            // Below 1e-6, at the rate ½, it counts as zero where steps fail.
            assert!((t - 2.0).abs() < 2.1e-6 && drive == "distance(A, B)", "{method:?} {error}");
            let target = error.trajectory().function("target(distance(A, B))").unwrap();
            assert!((target(1.0) - 0.5).abs() < 1e-15);
        }
    }
}

/// The same on a condition.
#[derive(BarSystem)]
#[particle(A, mass = m)]
#[particle(B, mass = m)]
#[drive(distance(A, B) = a - v * t, while("t < s"))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(B))]
#[coordinate(w = y(B))]
#[figure(A = (0, 0), B = (1, 0))]
struct LetGo {
    m: f64,
    a: f64,
    v: f64,
    s: f64,
}

/// Let go before, the masses pass each other; else it is refused where it comes to zero. One that
/// is not there yet, and below zero, is refused when it is armed only.
#[test]
fn a_driven_distance_on_a_condition_is_above_zero_while_it_is_there() {
    let pose = [("x", 0.0), ("y", 0.0), ("w", 0.0), ("x'", 0.0), ("y'", 0.0), ("u'", -0.5), ("w'", 0.0)];
    let pose = pose.iter().fold(Pose::new("u", 1.0), |pose, (name, value)| pose.with(*name, *value));
    let started = |s: f64| {
        let model = LetGo { m: 1.0, a: 1.0, v: 0.5, s };
        Simulation::new(&model).unwrap().start(pose.clone()).unwrap().limit(3.0).run()
    };
    let end = started(1.0).unwrap_or_else(|error| panic!("{error}")).events().last().unwrap().clone();
    assert!((end["u"] - end["x"] + 0.5).abs() < 1e-10, "{end}");
    let error = started(5.0).map(|_| ()).unwrap_err();
    assert!(matches!(error.cause(), RunCause::DrivenDistance { t, .. } if (t - 2.0).abs() < 1e-9), "{error}");
}
