//! Loads whose values jump: `if`, `sign` and `atan2`, against closed forms, by every method.

use core::f64::consts::PI;
use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A force that turns where its point comes beyond a place, or above a speed.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (if(x < a, f, -f), if(t > 1 && t < 2 || rate(y) < 0, f, 0)))]
struct Turning {
    m: f64,
    f: f64,
    a: f64,
}

/// A constant pull towards the middle.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (-f * sign(x), 0))]
struct Pull {
    m: f64,
    f: f64,
}

/// A bar whose torsion spring forgets full turns.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA))]
#[couple(OA = -k * atan2(y(A), x(A)))]
struct Turned {
    m: f64,
    l: f64,
    k: f64,
}

fn each<M: BarSystem>(model: &M, start: &Pose, limit: f64, check: impl Fn(&Trajectory, MethodId, f64)) {
    for method in MethodId::ALL {
        for tolerance in [1e-6, 1e-10, 1e-12] {
            let simulation = Simulation::new(model).unwrap().tolerance(tolerance).method(method);
            let run = simulation.start(start.clone()).unwrap().limit(limit).run();
            let run = run.unwrap_or_else(|error| panic!("{method:?} at {tolerance:e}: {error}"));
            assert!(run.audit().is_clean(), "{method:?} at {tolerance:e}: {:?}", run.audit());
            check(&run, method, tolerance);
        }
    }
}

/// With a = f t₁²/2m it turns at t₁, 3 t₁, 5 t₁ …; up by f from 1 to 2, and never down.
#[test]
fn a_choice_turns_where_its_condition_does() {
    let start = Pose::new("x", 0.0).with("y", 0.0).with("y'", 1.0);
    each(&Turning { m: 0.5, f: 1.0, a: 1.0 }, &start, 4.0, |run, method, tolerance| {
        let turns = run.events().iter().filter(|event| event.supports == ["if(x < a)"]);
        let times: Vec<f64> = turns.map(|event| event.t).collect();
        assert_eq!(times.len(), 2, "{method:?}: {:?}", run.events());
        // In the middle the force is zero, and nothing but rounding is lost.
        let bound = 100.0 * tolerance;
        assert!((times[0] - 1.0).abs() < bound && (times[1] - 3.0).abs() < bound, "{method:?}: {times:?}");
        let end = run.events().last().unwrap();
        assert!(end["x"].abs() < bound && (end["y"] - 9.0).abs() < bound, "{method:?}: {end}");
    });
}

/// x = 1 − t² up to t = 1, then its mirror image, with a period of 4.
#[test]
fn a_sign_turns_at_zero_and_is_zero_there() {
    let pull = Pull { m: 1.0, f: 2.0 };
    each(&pull, &Pose::new("x", 1.0).with("y", 0.0), 6.0, |run, method, tolerance| {
        let bound = 100.0 * tolerance;
        let crossings: Vec<f64> = run
            .events()
            .iter()
            .filter(|event| event.kind == EventKind::Disarm)
            .map(|event| event.t)
            .collect();
        assert_eq!(crossings.len(), 3, "{method:?}: {:?}", run.events());
        for (t, exact) in crossings.iter().zip([1.0, 3.0, 5.0]) {
            assert!((t - exact).abs() < bound, "{method:?}: {t}");
        }
        assert!((run.final_state()[0] + 1.0).abs() < bound, "{method:?}: {:?}", run.final_state());
    });
    for (rate, expected) in [(0.0, 0.0), (2.0, 1.0)] {
        let start = Pose::new("x", 0.0).with("x'", rate).with("y", 0.0);
        let run = Simulation::new(&pull).unwrap().start(start).unwrap().limit(1.0).run().unwrap();
        assert!((run.final_state()[0] - expected).abs() < 1e-7, "{:?}", run.final_state());
    }
}

/// J = 1, ω = √k = 1: up to the cut φ = 1 + 5 t in waves about full turns, each begun half a turn
/// before.
#[test]
fn a_direction_jumps_at_its_cut() {
    let model = Turned { m: 3.0, l: 1.0, k: 1.0 };
    let start = Pose::new("phi", 1.0).with("phi'", 5.0);
    // On x″ = −x the phase from x, v to π.
    let quarter = |x: f64, v: f64| (x.hypot(v), x.atan2(v));
    let (amplitude, begun) = quarter(1.0, 5.0);
    let (at_cut, speed) = ((PI / amplitude).asin() - begun, (amplitude * amplitude - PI * PI).sqrt());
    let half = 2.0 * (PI / amplitude).asin();
    each(&model, &start, 4.0, |run, method, tolerance| {
        let bound = 1e3 * tolerance;
        let cuts: Vec<f64> = run
            .events()
            .iter()
            .filter(|event| event.kind == EventKind::Disarm)
            .map(|event| event.t)
            .collect();
        assert_eq!(cuts.len(), 3, "{method:?}: {:?}", run.events());
        for (k, t) in cuts.iter().enumerate() {
            let exact = at_cut + half * k as f64;
            assert!((t - exact).abs() < bound, "{method:?} at {tolerance:e}: {t} {exact}");
        }
        let left = 4.0 - cuts[2];
        let exact = 6.0 * PI - PI * left.cos() + speed * left.sin();
        assert!((run.final_state()[0] - exact).abs() < bound, "{method:?}: {:?} {exact}", run.final_state());
    });
    // Swings about zero see no cut.
    let still =
        Simulation::new(&model).unwrap().start(Pose::new("phi", 2.0)).unwrap().limit(3.0).run().unwrap();
    assert_eq!(still.events().len(), 2);
    assert!((still.final_state()[0] - 2.0 * 3.0f64.cos()).abs() < 1e-9);
}

/// The same functions in outputs; a direction is met by an equation, its jump is no solution.
#[test]
fn outputs_choose_and_conditions_do_not() {
    let model = Turned { m: 3.0, l: 1.0, k: 0.0 };
    let run = |until: &str| {
        let start = Pose::new("phi", 1.0).with("phi'", 1.0);
        let simulation = Simulation::new(&model)?.start(start)?.until(until)?.limit(10.0);
        Ok::<_, Box<dyn std::error::Error>>(simulation.run()?)
    };
    let whole = run("t = 6").unwrap();
    let at = |text: &str, t: f64| whole.function(text).unwrap()(t);
    for t in [0.5, 2.0, 3.5, 5.0] {
        let phi = 1.0 + t;
        assert!((at("atan2(y(A), x(A))", t) - phi.sin().atan2(phi.cos())).abs() < 1e-12);
        assert!((at("l * atan(phi / 2)", t) - (0.5 * phi).atan()).abs() < 1e-12);
        assert_eq!(at("sign(y(A))", t), phi.sin().signum());
        // What is not chosen may have no value.
        let chosen = if phi > 3.0 && phi < 5.0 { 2.0 } else { (phi - 2.0).abs().sqrt() };
        let text = "if(phi > 3 and phi < 5, 2, if(phi > 2, sqrt(phi - 2), sqrt(2 - phi)))";
        assert!((at(text, t) - chosen).abs() < 1e-12, "{t}");
    }
    for target in [0.0, 3.0, -3.0, -1.0] {
        let met = run(&format!("atan2(y(A), x(A)) = {target}")).unwrap();
        let turns = if target > 1.0 { 0.0 } else { 2.0 * PI };
        assert!((met.events().last().unwrap().t - (target + turns - 1.0)).abs() < 1e-12, "{target}");
    }
    for until in ["atan2(y(A), x(A)) < -1", "sign(phi - 2) > 0", "if(phi > 2, 1, -1) > 0"] {
        let error = run(until).unwrap_err().to_string();
        assert!(error.contains("jumps, in outputs and loads; compare what it depends on"), "{error}");
    }
}
