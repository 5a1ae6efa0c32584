//! Springs that change with time, against closed forms.

use liftoff::prelude::*;

/// A mass on a spring of which the natural length is shaken.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k, length = l + b * sin(w * t))]
#[coordinate(x = x(P))]
#[figure(P = (l, 0))]
struct Shaken {
    m: f64,
    k: f64,
    l: f64,
    b: f64,
    w: f64,
}

/// With ω₀² = k/m and A = b ω₀²/(ω₀² − ω²): x = l + A (sin ωt − (ω/ω₀) sin ω₀t) from rest.
#[test]
fn a_shaken_spring_drives_its_mass() {
    let (m, k, l, b, w) = (1.5, 24.0, 1.0, 0.05, 2.5);
    let pose = Pose::new("x", l).with("x'", 0.0);
    let simulation = Simulation::new(&Shaken { m, k, l, b, w }).unwrap().start(pose).unwrap();
    let record = simulation.limit(4.0).tolerance(1e-12).run().unwrap();
    let own = (k / m).sqrt();
    let amplitude = b * own * own / (own * own - w * w);
    for t in [0.5, 2.0, 3.9] {
        let x = |t: f64| l + amplitude * ((w * t).sin() - w / own * (own * t).sin());
        let at = |text: &str| record.value(&Output::parse(Shaken::LAYOUT, text).unwrap(), t);
        assert!((at("x") - x(t)).abs() < 1e-10, "{t}: {}", at("x"));
        let tension = k * (x(t) - l - b * (w * t).sin());
        assert!((at("force(OP)") - tension).abs() < 1e-9, "{t}: {}", at("force(OP)"));
    }
}

/// A mass on a spring that softens.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k / (1 + t / s).powi(2))]
#[coordinate(x = x(P))]
#[figure(P = (r, 0))]
struct Softening {
    m: f64,
    k: f64,
    s: f64,
    r: f64,
}

/// Euler's equation: with τ = 1 + t/s and ν² = k s²/m − ¼, x = x₀ √τ (cos(ν ln τ) − sin(ν ln τ)/2ν)
/// from rest.
#[test]
fn a_softening_spring_follows_euler_s_equation() {
    let (m, k, s, start) = (1.5, 24.0, 0.7, 0.3);
    let pose = Pose::new("x", start).with("x'", 0.0);
    let simulation = Simulation::new(&Softening { m, k, s, r: start }).unwrap().start(pose).unwrap();
    let record = simulation.limit(4.0).tolerance(1e-12).run().unwrap();
    let nu = (k * s * s / m - 0.25).sqrt();
    for t in [0.5, 2.0, 3.9] {
        let tau: f64 = 1.0 + t / s;
        let (sin, cos) = (nu * tau.ln()).sin_cos();
        let x = start * tau.sqrt() * (cos - sin / (2.0 * nu));
        let found = record.value(&Output::parse(Softening::LAYOUT, "x").unwrap(), t);
        assert!((found - x).abs() < 1e-10, "{t}: {found} for {x}");
    }
}

/// A bar on a torsion spring that is wound up.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[torsion(OA, stiffness = k, angle = w * t)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (l, 0))]
struct Wound {
    m: f64,
    l: f64,
    k: f64,
    w: f64,
}

/// With Ω² = k/I: φ = ωt − (ω/Ω) sin Ωt from rest.
#[test]
fn a_spring_that_is_wound_up_turns_its_bar() {
    let (m, l, k, w) = (1.5, 0.8, 6.0, 1.2);
    let pose = Pose::new("phi", 0.0).with("phi'", 0.0);
    let simulation = Simulation::new(&Wound { m, l, k, w }).unwrap().start(pose).unwrap();
    let record = simulation.limit(4.0).tolerance(1e-12).run().unwrap();
    let own = (k / (m * l * l / 3.0)).sqrt();
    for t in [0.5, 2.0, 3.9] {
        let phi = w * t - w / own * (own * t).sin();
        let at = |text: &str| record.value(&Output::parse(Wound::LAYOUT, text).unwrap(), t);
        assert!((at("phi") - phi).abs() < 1e-10, "{t}: {}", at("phi"));
        assert!((at("torque(OA)") + k * (phi - w * t)).abs() < 1e-9, "{t}: {}", at("torque(OA)"));
    }
}
