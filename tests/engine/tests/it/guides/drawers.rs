//! Bodies in a guide at two points: self-locking, Painlevé's paradox, impacts.

use liftoff::prelude::*;

use crate::friction::run;

/// A drawer: a body in a guide at two points, pulled beside it.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, b))]
#[slider(A = horizontal(0), friction = mu, jams)]
#[slider(B = horizontal(0), friction = mu)]
#[force(C = (f, 0))]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Drawer {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    b: f64,
    mu: f64,
    f: f64,
}

/// With the centre on the guide −N_A = N_B = f h/l: it locks for 2 μ h > l, whatever the force, and
/// else has (f − 2 μ f h/l)/m.
#[test]
fn a_drawer_locks_beyond_the_angle_of_friction() {
    let (m, j, l, h, b) = (2.0, 0.3, 0.6, 1.0, 0.0);
    for f in [-50.0, 0.1, 3.0, 1e4] {
        let start = || Pose::new("x", 0.0).with("x'", 0.0);
        let locked = Drawer { m, j, l, h, b, mu: 0.3001, f };
        let simulation = Simulation::new(&locked).unwrap().start(start()).unwrap();
        let error = simulation.clone().run().unwrap_err();
        assert!(
            matches!(error.cause(), liftoff::RunCause::Start(liftoff::StartError::Equilibrium)),
            "{error}"
        );
        let rests = run(simulation.limit(1.0));
        assert!(rests.log().iter().any(|entry| entry.decision == liftoff::LoggedDecision::StartRests));
        assert_eq!((rests.end_time(), rests.final_state()), (1.0, rests.events()[0].state.clone()));
        let free = Drawer { m, j, l, h, b, mu: 0.2, f };
        let record = run(Simulation::new(&free).unwrap().start(start()).unwrap().limit(1.0));
        let a = (f - f.signum() * 2.0 * 0.2 * (f * h / l).abs()) / m;
        let [x, na, nb] = ["x", "N(A)", "N(B)"].map(|text| record.function(text).unwrap());
        assert!((x(1.0) - 0.5 * a).abs() < 1e-10 * a.abs().max(1.0));
        assert!((na(0.5) + f * h / l).abs() < 1e-9 * f.abs().max(1.0), "{} {}", na(0.5), f * h / l);
        assert!((na(0.5) + nb(0.5)).abs() < 1e-9 * f.abs().max(1.0));
    }
}

/// The same with the centre at the height b, pushed on while it slides:
///
/// ```text
/// (l − 2 σ μ s b) N_B = f (h − b),    s = sign N_B
/// ```
///
/// For 2 μ b > l, σ = 1 and f (h − b) > 0 there is no motion in which it slides; for f (h − b) < 0
/// there are two, of which stiff guides would hold that with N_B < 0.
fn tall(mu: f64, f: f64) -> Drawer {
    Drawer { m: 2.0, j: 0.3, l: 0.6, h: 1.5, b: 1.0, mu, f }
}

#[test]
fn where_no_reaction_obeys_the_law_a_guide_jams() {
    let start = || Pose::new("x", 0.0).with("x'", 1.0);
    let go =
        |mu: f64, f: f64| Simulation::new(&tall(mu, f)).unwrap().start(start()).unwrap().limit(0.01).run();
    for f in [0.5, 20.0] {
        let error = go(0.31, f).unwrap_err();
        assert!(error.to_string().contains("jammed: no reactions of A, B satisfy"), "{error}");
        let run = go(0.29, f).unwrap();
        let normal = run.function("N(B)").unwrap()(0.0);
        let expected = f * 0.5 / (0.6 - 2.0 * 0.29);
        assert!((normal / expected - 1.0).abs() < 1e-9, "{normal} {expected}");
    }
    let run = go(0.31, -20.0).unwrap();
    let normal = run.function("N(B)").unwrap()(0.0);
    assert!((normal + 20.0 * 0.5 / (0.6 + 2.0 * 0.31)).abs() < 1e-9, "{normal}");
    let several = |entry: &liftoff::LogEntry| entry.decision.to_string().contains("stiff springs");
    assert!(run.log().iter().any(several), "{:?}", run.log());
}

/// A drawer that runs against a wall with its handle.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, 0))]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = horizontal(0), friction = mu)]
#[support(C = wall(w), restitution = e)]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Stopped {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    w: f64,
    mu: f64,
    e: f64,
}

/// The guides bear P h/l each, and rub against the rebound: m (1 + e) v = P (1 − 2 μ h/l). An
/// impulse I at the handle moves the drawer by I (1 − 2 μ h/l)/m, and not at all where it locks.
#[test]
fn guides_rub_at_impacts() {
    let (m, l, h, mu, e, v) = (2.0, 0.6, 1.0, 0.2, 0.5, 1.0);
    let of = |mu: f64| Stopped { m, j: 0.3, l, h, w: 0.25, mu, e };
    let start = |rate: f64| Pose::new("x", 0.0).with("x'", rate);
    let record = run(Simulation::new(&of(mu)).unwrap().start(start(v)).unwrap().limit(0.5));
    let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    assert!((impact.t - 0.25 / v).abs() < 1e-10 && (impact["x'"] + e * v).abs() < 1e-12, "{impact}");
    let expected = m * (1.0 + e) * v / (1.0 - 2.0 * mu * h / l);
    let [a, b, wall] =
        ["A", "B", "C"].map(|label| impact.impulses.iter().find(|it| it.label == label).unwrap());
    assert!((wall.value - expected).abs() < 1e-10, "{:?}", impact.impulses);
    for guide in [a, b] {
        assert!((guide.value.abs() - expected * h / l).abs() < 1e-10, "{:?}", impact.impulses);
        assert!((guide.friction.unwrap() - mu * guide.value.abs()).abs() < 1e-10, "{:?}", impact.impulses);
    }
    let lost = record.function("D").unwrap()(0.5);
    assert!((lost - 0.5 * m * v * v * (1.0 - e * e)).abs() < 1e-10, "{lost}");
    for (mu, rate) in [(0.2, 3.0 / m * (1.0 - 2.0 * mu * h / l)), (0.31, 0.0)] {
        let simulation = Simulation::new(&of(mu)).unwrap().start(start(0.0)).unwrap().limit(0.02);
        let record = run(simulation.impulse("C", [-3.0, 0.0], 0.01).unwrap());
        let impulse = record.events().iter().find(|event| event.kind == EventKind::Impulse).unwrap();
        assert!((impulse["x'"] + rate).abs() < 1e-12, "{impulse}");
    }
}

/// A drawer that does not jam: what no reaction holds is stopped at once.
#[derive(BarSystem)]
#[body(K, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m, inertia = j, centre = (l / 2, b))]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = horizontal(0), friction = mu)]
#[force(C = (f, 0))]
#[coordinate(x = x(A))]
#[figure(A = (0, 0), B = (l, 0), C = (0, h))]
struct Wedged {
    m: f64,
    j: f64,
    l: f64,
    h: f64,
    b: f64,
    mu: f64,
    f: f64,
}

/// The impulses of the guides stop it, |P_A| = |P_B| = b m v/l, within the cones of friction.
#[test]
fn an_impact_without_collision_ends_a_slip_in_guides() {
    let model = Wedged { m: 2.0, j: 0.3, l: 0.6, h: 1.5, b: 1.0, mu: 0.31, f: 5.0 };
    let start = Pose::new("x", 0.0).with("x'", 1.0);
    let record = run(Simulation::new(&model).unwrap().start(start).unwrap().limit(0.1));
    let impact = &record.events()[1];
    assert_eq!(
        (impact.kind, &impact.note),
        (EventKind::Impact, &Some(liftoff::Note::WithoutCollision)),
        "{impact}"
    );
    assert!(impact.t == 0.0 && impact["x'"].abs() < 1e-12, "{impact}");
    let impulse = |label: &str| impact.impulses.iter().find(|it| it.label == label).unwrap();
    for label in ["A", "B"] {
        let bound = 0.31 * impulse(label).value.abs();
        assert!((impulse(label).value.abs() - 1.0 * 2.0 / 0.6).abs() < 1e-10, "{:?}", impact.impulses);
        assert!(impulse(label).friction.unwrap().abs() <= bound, "{:?}", impact.impulses);
    }
    assert!(record.final_state().iter().all(|x| x.abs() < 1e-12), "{:?}", record.final_state());
}
