//! Limits of angles, positions and distances: closed forms, and the same as supports and threads.

use core::f64::consts::PI;

use liftoff::prelude::*;
use liftoff::{EventKind, StartError};

/// A rod that turns about its end between two stops, without gravity.
#[derive(BarSystem)]
#[pin(O = (0, 0))]
#[bar(OA, mass = m, length = l)]
#[couple(OA = c)]
#[limit(angle(OA), low = low, high = high, restitution = e)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (0, -l))]
struct Gate {
    m: f64,
    l: f64,
    c: f64,
    low: f64,
    high: f64,
    e: f64,
}

/// From −π/2 at 2 it reaches the stops, 1 apart on both sides, after 1/2, 1/2 + 1 and 1/2 + 1 + 2,
/// each time e = 1/2 as fast as before; the impulse is the change of the angular momentum.
#[test]
fn a_rod_goes_to_and_fro_between_its_limits() {
    for l in [1.0, 1e3, 1e9, 1e-3, 1e-9] {
        let gate = Gate { m: 3.0, l, c: 0.0, low: -PI / 2.0 - 1.0, high: -PI / 2.0, e: 0.5 };
        let start = Pose::new("phi", -PI / 2.0 - 0.5).with("phi'", 2.0);
        let run = Simulation::new(&gate).unwrap().start(start).unwrap().limit(3.0).run().unwrap();
        let impacts: Vec<_> = run.events().iter().filter(|event| event.kind == EventKind::Impact).collect();
        let expected = [(0.25, "OA_high"), (1.25, "OA_low")];
        assert_eq!(impacts.len(), expected.len(), "{l}");
        for (impact, (t, name)) in impacts.iter().zip(expected) {
            assert!((impact.t - t).abs() < 1e-11 && impact.supports == [name], "{l}: {impact:?}");
        }
        let inertia = 3.0 * l * l / 3.0;
        let impulse = impacts[0].impulses.iter().find(|reaction| reaction.label == "OA_high").unwrap();
        assert!((impulse.value - 3.0 * inertia).abs() < 1e-12 * inertia, "{l}: {impulse:?}");
    }
}

/// What presses it against a stop is the couple.
#[test]
fn the_reaction_of_a_limit_of_an_angle_is_a_couple() {
    for (l, c) in [(1.0, 5.0), (1e-3, 2e-6), (1e3, -7e9)] {
        let gate = Gate { m: 3.0, l, c, low: -PI / 2.0 - 1.0, high: -PI / 2.0, e: 0.0 };
        let start = Pose::new("phi", -PI / 2.0 - 0.5);
        let run = Simulation::new(&gate).unwrap().start(start).unwrap().limit(100.0).run().unwrap();
        let name = if c > 0.0 { "N(OA_high)" } else { "N(OA_low)" };
        let found = run.value(&run.output(name).unwrap(), 99.0);
        assert!((found - c.abs()).abs() < 1e-12 * c.abs(), "{l}: {found}");
    }
}

macro_rules! arm {
    ($name:ident, $($limit:tt)*) => {
        #[derive(BarSystem)]
        #[liftoff(dimensionless)]
        #[gravity(9.81)]
        #[pin(O = (0, 0))]
        #[bar(OA, mass = 1, length = 1)]
        #[bar(AB, mass = 2, length = 1)]
        $($limit)*
        #[coordinate(phi = angle(OA), from = down)]
        #[coordinate(psi = angle(AB), from = OA)]
        #[figure(A = (0, -1), B = (0.8, -1.6))]
        struct $name;
    };
}

arm!(Turning, #[limit(elbow = angle(OA, AB), low = -pi / 6, high = 2, restitution = 0.4)]);
arm!(Named, #[limit(psi, low = -pi / 6, high = 2, restitution = 0.4)]);
arm!(OneBound, #[limit(psi, low = -pi / 6, restitution = 0.4)] #[limit(other = psi, high = 2, restitution = 0.4)]);
arm!(Threaded, #[thread(OB, length = 1.8, restitution = 0.4)]);
arm!(Distant, #[limit(distance(O, B), high = 1.8, restitution = 0.4)]);
arm!(Floored, #[support(B = floor(-1.7), restitution = 0.4)]);
arm!(Low, #[limit(y(B), low = -1.7, restitution = 0.4)]);

/// The times of all events, with the states after them.
fn events<M: BarSystem>(model: &M) -> Vec<(f64, Vec<f64>)> {
    let start = Pose::new("phi", 0.5).with("psi", 1.4).with("phi'", 2.0).with("psi'", -4.0);
    let run = Simulation::new(model).unwrap().start(start).unwrap().limit(2.0).run().unwrap();
    run.events().iter().map(|event| (event.t, event.state.to_vec())).collect()
}

fn same<A: BarSystem, B: BarSystem>(a: &A, b: &B) {
    let (a, b) = (events(a), events(b));
    assert!(a.len() > 2 && a.len() == b.len(), "{a:?} {b:?}");
    for ((t, state), (time, there)) in a.iter().zip(&b) {
        assert!((t - time).abs() < 1e-8, "{t} {time}");
        for (x, y) in state.iter().zip(there) {
            assert!((x - y).abs() < 1e-7, "{t}: {state:?} {there:?}");
        }
    }
}

#[test]
fn a_limit_is_the_same_in_other_words() {
    same(&Turning, &Named);
    same(&Turning, &OneBound);
    same(&Threaded, &Distant);
    same(&Floored, &Low);
}

/// A point that slides along a bar, stopped before its end by a limit or by the bar's end.
macro_rules! sliding {
    ($name:ident, $slider:meta $(, $limit:meta)?) => {
        #[derive(BarSystem)]
        #[liftoff(dimensionless)]
        #[gravity(9.81)]
        #[pin(O = (0, 0))]
        #[bar(OA, mass = 1, length = 1)]
        #[particle(P, mass = 1)]
        #[$slider]
        $(#[$limit])?
        #[coordinate(phi = angle(OA), from = right)]
        #[figure(A = (1, 0), P = (0.5, 0))]
        struct $name;
    };
}

sliding!(Stopped, slider(P = bar(OA), stops, restitution = 0.5));
sliding!(Limited, slider(P = bar(OA)), limit(along(P, OA), low = 0, high = 1, restitution = 0.5));

#[test]
fn a_limit_along_a_bar_is_its_end() {
    let states = |run: Trajectory| -> Vec<(f64, Vec<f64>)> {
        run.events().iter().map(|event| (event.t, event.state.to_vec())).collect()
    };
    let start = || Pose::new("phi", 0.1).with("phi'", 0.0).with("x_P", 0.5);
    let run = |simulation: Simulation| simulation.start(start()).unwrap().limit(2.0).run().unwrap();
    let (a, b) =
        (states(run(Simulation::new(&Stopped).unwrap())), states(run(Simulation::new(&Limited).unwrap())));
    assert!(a.len() > 3 && a.len() == b.len());
    for ((t, state), (time, there)) in a.iter().zip(&b) {
        assert!((t - time).abs() < 1e-9, "{t} {time}");
        assert!(state.iter().zip(there).all(|(x, y)| (x - y).abs() < 1e-7), "{t}: {state:?} {there:?}");
    }
}

/// Whatever its size it bounces as often before it rests: what of an angle counts as zero is no
/// length.
#[test]
fn a_rod_settles_on_a_limit_alike_whatever_its_length() {
    let bounces = |l: f64| {
        let c = 3.0 * l * l;
        let gate = Gate { m: 3.0, l, c, low: -PI / 2.0 - 1.0, high: -PI / 2.0, e: 0.3 };
        let start = Pose::new("phi", -PI / 2.0 - 0.2);
        let run = Simulation::new(&gate).unwrap().start(start).unwrap().limit(3.0).run().unwrap();
        run.events().iter().filter(|event| event.kind == EventKind::Impact).count()
    };
    let expected = bounces(1.0);
    assert!(expected > 3);
    for l in [1e-9, 1e-3, 1e3, 1e9] {
        assert_eq!(bounces(l), expected, "{l}");
    }
}

/// Bounds that parameters make.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[pin(O = (0, 0))]
#[bar(OA, mass = 1, length = 1)]
#[particle(P, mass = 1)]
#[limit(phi, low = a, high = b)]
#[limit(distance(A, P), high = d)]
#[coordinate(phi = angle(OA), from = right)]
#[figure(A = (1, 0), P = (2, 1))]
struct Bounded {
    a: f64,
    b: f64,
    d: f64,
}

#[test]
fn bounds_that_leave_nothing_are_refused() {
    let refused = |a, b, d| Simulation::new(&Bounded { a, b, d }).err().map(|error| error.to_string());
    assert_eq!(refused(-1.0, 1.0, 3.0), None);
    for (a, b, d, name) in
        [(1.0, 0.5, 3.0, "phi_high"), (1.0, 1.0, 3.0, "phi_high"), (-1.0, 1.0, -3.0, "A_P_high")]
    {
        let error = refused(a, b, d).unwrap();
        assert!(error.contains(name) && error.contains("must be positive"), "{error}");
    }
}

#[test]
fn a_start_beyond_a_limit_is_refused_by_its_name() {
    let start = Pose::new("phi", 0.0).with("psi", -1.0);
    let error = Simulation::new(&Turning).unwrap().start(start).err().unwrap();
    assert!(
        matches!(error, StartError::Penetrates { .. }) && error.to_string().contains("elbow_low"),
        "{error}"
    );
}
