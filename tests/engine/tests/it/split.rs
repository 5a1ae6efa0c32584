//! A run from a state of another run goes on as that does.

use liftoff::LoggedDecision;
use liftoff::prelude::*;
use liftoff_fixtures::{BouncingBar, Ladder, PairOnCorners, Zigzag};

/// The pose of a full state.
fn pose(run: &Trajectory, state: &[f64]) -> Pose {
    let names = run.layout().coordinates.iter().map(|coordinate| coordinate.name);
    let all = names.clone().map(str::to_owned).chain(names.map(|name| format!("{name}'")));
    all.zip(state).fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value))
}

fn named(run: &Trajectory, after: f64) -> Vec<(EventKind, Vec<&'static str>)> {
    let events = run.events().iter().filter(|event| event.t > after);
    events.map(|event| (event.kind, event.supports.clone())).collect()
}

/// Splits a run at each of its events and between them.
fn splits(model: &liftoff_core::system::Model, start: Pose, end: f64) {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let new = || Simulation::new(model.clone()).unwrap().tolerance(tolerance);
        let whole = new().start(start.clone()).unwrap().limit(end).run().unwrap();
        let events = whole.events();
        let middles = events.windows(2).map(|pair| 0.5 * (pair[0].t + pair[1].t));
        let places = events.iter().map(|event| (event.t, event.state.clone()));
        let places = places.chain(middles.map(|t| (t, whole.state(t)))).filter(|(t, _)| *t > 0.0 && *t < end);
        for (t, state) in places {
            let part = new().start(pose(&whole, &state)).map(|run| run.limit(end - t).run());
            let part = part.unwrap_or_else(|error| panic!("{tolerance:e} at {t}: {error}"));
            let part = part.unwrap_or_else(|error| panic!("{tolerance:e} at {t}: {error}"));
            // The bound of a time at which something is known to happen.
            let near = 1e2 * tolerance;
            assert_eq!(named(&part, near), named(&whole, t + near), "{tolerance:e} at {t}");
            let apart = part.final_state().into_iter().zip(whole.final_state()).map(|(a, b)| (a - b).abs());
            let apart = apart.fold(0.0, f64::max);
            // Some steps, whose errors impacts magnify.
            assert!(apart < 1e4 * tolerance, "{tolerance:e} at {t}: {apart:e}");
        }
    }
}

#[test]
fn a_split_run_is_the_whole_run() {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 };
    splits(&(&bar).into(), Pose::new("y", 0.5).with("phi", 0.4), 0.6);
    splits(&(&PairOnCorners { m: 1.0, l: 1.0, g: 9.81 }).into(), Pose::new("phi", 0.1), 1.2);
    splits(&(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).into(), Pose::new("theta", 1.3), 1.7);
    splits(
        &(&Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g: 9.81 }).into(),
        Pose::new("phi_inner", 1.2).with("phi_outer", 1.2),
        0.9,
    );
}

/// States that a run was left in at loose tolerances lie as deep below a support as the tolerance
/// allows, and no deeper.
#[test]
fn a_start_may_penetrate_as_deep_as_its_tolerance_lets_a_motion() {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 };
    let below = |tolerance: f64, depth: f64| {
        let run = Simulation::new(&bar).unwrap().tolerance(tolerance).limit(0.1);
        let pose = Pose::new("phi", 1.0).with("x", 0.0).with("y", -depth);
        run.start(pose).map(|run| run.run().unwrap())
    };
    let told = |run: &Trajectory| {
        run.log().iter().any(|entry| matches!(entry.decision, LoggedDecision::StartPenetrates(_)))
    };
    assert!(below(1e-12, 1e-9).is_err() && below(1e-8, 1e-6).is_err());
    assert!(told(&below(1e-8, 1e-7).unwrap()) && !told(&below(1e-12, 1e-11).unwrap()));
}

/// A tolerance that is set after the start counts as one that is set before.
#[test]
fn a_start_does_not_depend_on_when_the_tolerance_is_set() {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 };
    let new = || Simulation::new(&bar).unwrap().limit(0.1);
    let at_depth = |depth: f64| Pose::new("phi", 1.0).with("x", 0.0).with("y", -depth);
    let before = new().tolerance(1e-8).start(at_depth(1e-8)).unwrap();
    let after = new().tolerance(1e-5).start(at_depth(1e-8)).unwrap().tolerance(1e-8);
    assert_eq!(after.start_state(), before.start_state());
    assert_eq!(after.run().unwrap().final_state(), before.run().unwrap().final_state());
    let refused = new().tolerance(1e-8).start(at_depth(1e-6)).map(|_| ()).unwrap_err();
    let loosened = new().tolerance(1e-5).start(at_depth(1e-6)).unwrap();
    assert_eq!(loosened.tolerance(1e-8).start_state().unwrap_err(), refused);
}
