//! A rod with one end on a rough floor: impacts with friction, and Painlevé's paradox.

use core::f64::consts::PI;

use liftoff::Note;
use liftoff::method::MethodId;
use liftoff::prelude::*;

use crate::friction::run;

/// A rod with one end on a floor, as Painlevé had it.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu, restitution = e, law = stronge)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.8, 0.6))]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
    e: f64,
}

/// Impacts computed by other codes along Routh's path, with Stronge's law: end velocities of the
/// tip, energy.
#[test]
fn a_rod_strikes_with_friction_as_routh_has_it() {
    for (degrees, slip, mu, e, normal, lost) in [
        (60.0_f64, 0.5, 0.3, 0.6, 0.5153986768, 0.218753372),
        (70.0, -0.4, 0.5, 0.9, 0.9729528532, 0.1477773351),
        (75.0, 1.0, 0.8, 0.9, 0.7524522557, 0.1686304875),
        (55.0, 0.75, 0.5, 1.0, 0.7356505710, 0.0482244150),
    ] {
        let rod = Rod { m: 1.0, l: 1.0, g: 0.0, mu, e };
        let pose =
            Pose::new("theta", degrees.to_radians()).with("y", 0.001).with("x'", slip).with("y'", -1.0);
        let pose = pose.with("theta'", 0.0);
        let record = run(Simulation::new(&rod).unwrap().start(pose).unwrap().limit(0.002).tolerance(1e-12));
        let impact = record.events().iter().find(|event| event.kind == EventKind::Impact).expect("an impact");
        assert!((impact["y'"] - normal).abs() < 1e-9, "{degrees}: {impact}");
        let energy = |state: &Event| {
            let (u, w, omega) = (state["x'"], state["y'"], state["theta'"]);
            let (s, c) = (state["theta"].sin(), state["theta"].cos());
            0.5 * ((u - 0.5 * s * omega).powi(2) + (w + 0.5 * c * omega).powi(2)) + omega * omega / 24.0
        };
        let gained = energy(impact) - energy(&record.events()[0]);
        assert!((gained + lost).abs() < 1e-9, "{degrees}: {gained}");
    }
}

/// The rod, beside a particle that touches a wall without load.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = 1, length = 1)]
#[particle(P, mass = 1)]
#[support(A = floor, friction = mu)]
#[support(W = wall(5), under = P, facing = left)]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(u = x(P))]
#[coordinate(v = y(P))]
#[figure(A = (0, 0), B = (0.6, 0.8), P = (4, 0))]
struct Beside {
    g: f64,
    mu: f64,
}

/// What touches elsewhere without load does not change how a slip that nothing holds ends: about
/// the tip, whose angular momentum is kept, θ̇ = ³⁄₂ v sin θ.
#[test]
fn a_contact_without_load_elsewhere_changes_no_paradox() {
    let pose = Pose::new("theta", 1.0).with("y", 0.0).with("u", 5.0).with("x'", -3.0);
    let pose = ["theta'", "y'", "u'", "v'"].into_iter().fold(pose, |pose, rate| pose.with(rate, 0.0));
    let simulation = Simulation::new(&Beside { g: 10.0, mu: 1.6 }).unwrap().start(pose).unwrap();
    let record = run(simulation.limit(0.02).tolerance(1e-10));
    let stopped = &record.events()[1];
    assert!(matches!(stopped.note, Some(Note::WithoutCollision)), "{stopped}");
    assert!((stopped["theta'"] - 4.5 * 1.0f64.sin()).abs() < 1e-13, "{stopped}");
}

/// Sliding with the tip behind, at 60° and μ = 2, no reaction obeys the law: an impact without
/// collision stops the tip, about which the angular momentum is kept, and the rod falls on about
/// it. With the tip ahead it slides.
#[test]
fn painleve_paradox_is_answered_by_an_impact_without_collision() {
    let rod = Rod { m: 1.0, l: 1.0, g: 9.81, mu: 2.0, e: 0.0 };
    let theta = 60.0_f64.to_radians();
    let from = |v: f64| {
        let pose = Pose::new("theta", theta).with("y", 0.0).with("x'", v).with("theta'", 0.0);
        run(Simulation::new(&rod).unwrap().start(pose).unwrap().limit(0.02).tolerance(1e-10))
    };
    let record = from(-3.0);
    let [start, stopped, ..] = record.events() else { panic!("{:?}", record.events()) };
    assert_eq!((start.kind, &start.note), (EventKind::Start, &Some(Note::BeforeImpact)), "{start}");
    assert_eq!((start.t, start["x'"], start.reaction("A")), (0.0, -3.0, Some(0.0)), "{start}");
    assert_eq!((stopped.kind, stopped.supports.len()), (EventKind::Impact, 1), "{stopped}");
    assert!(matches!(stopped.note, Some(Note::WithoutCollision)));
    let turned = 3.0 * 0.5 * theta.sin() * 3.0;
    let error = stopped["x'"].abs() + stopped["y'"].abs() + (stopped["theta'"] - turned).abs();
    assert!(error < 1e-13, "{stopped}");
    let kinds = |record: &Trajectory| record.events().iter().map(|event| event.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&from(3.0)), [EventKind::Start, EventKind::End]);
}

/// The interval of the paradox at μ = 2 begins at tan θ = (3μ − √(9μ² − 16))/2, which a rod that
/// pitches up reaches with a reaction beyond all bounds; at μ = 1.4 < 8/3√3 it lifts off before
/// (Génot and Brogliato 1999).
#[test]
fn the_border_of_painleves_region_is_an_event() {
    let border = |mu: f64| (0.5 * (3.0 * mu - (9.0 * mu * mu - 16.0).sqrt())).atan();
    for method in [MethodId::Dop853, MethodId::Tsit5, MethodId::Taylor, MethodId::Radau, MethodId::Gauss] {
        for rate in [0.5, 2.0, 5.0] {
            let first = |mu: f64| {
                let rod = Rod { m: 1.0, l: 1.0, g: 9.81, mu, e: 0.0 };
                let pose = Pose::new("theta", PI / 6.0).with("y", 0.0).with("x'", -10.0).with("theta'", rate);
                let simulation = Simulation::new(&rod).unwrap().start(pose).unwrap().limit(0.2);
                run(simulation.tolerance(1e-10).method(method)).events()[1].clone()
            };
            let event = first(2.0);
            assert!(matches!(event.note, Some(Note::WithoutCollision)), "{} {rate}: {event}", method.name());
            let error = event["theta"] - border(2.0);
            // The reaction has a pole at the border: how near to it a pair's last steps end is
            // rounding.
            let bound = match method {
                MethodId::Tsit5 | MethodId::Radau => 2e-8,
                MethodId::Dop853 => 1e-8,
                _ => 1e-10,
            };
            assert!(error.abs() < bound, "{} {rate}: {error:e}", method.name());
            assert_ne!(first(1.4).kind, EventKind::Impact);
        }
    }
}

/// At tan θ = 2 the paradox begins at μ = 4/3.
#[test]
fn the_critical_coefficient_of_friction() {
    for (mu, jams) in [(4.0 / 3.0 - 1e-8, false), (4.0 / 3.0 + 1e-8, true)] {
        let rod = Rod { m: 1.0, l: 1.0, g: 9.81, mu, e: 0.0 };
        let pose = Pose::new("theta", 2.0_f64.atan()).with("y", 0.0).with("x'", -3.0).with("theta'", 0.0);
        let record = run(Simulation::new(&rod).unwrap().start(pose).unwrap().limit(1e-3).tolerance(1e-10));
        assert_eq!(record.events()[1].note == Some(Note::WithoutCollision), jams, "{mu}");
    }
}

/// While the tip slips with the rod ahead of it, N (1 + 3 cos² θ + 3 μ sin θ cos θ) = m (g − ½ l
/// θ'² sin θ): whatever μ is, N vanishes with the right side. A tip that stuck before slips at |R|
/// = μ N, however small N is there.
#[test]
fn a_tip_under_much_friction_slips_before_it_opens() {
    for mu in [30.0, 1e3, 1e6, 1.6e9] {
        for tolerance in [1e-6, 8e-9, 1e-11] {
            let rod = Rod { m: 1.0, l: 1.0, g: 9.81, mu, e: 0.0 };
            let pose = Pose::new("theta", 0.0).with("y", 0.0).with("x'", 0.0).with("theta'", 6.5613);
            let simulation = Simulation::new(&rod).unwrap().start(pose).unwrap().limit(1.0);
            let record = run(simulation.tolerance(tolerance).method(MethodId::Radau));
            let kinds: Vec<_> = record.events().iter().map(|event| event.kind).collect();
            assert_eq!(
                kinds[..3],
                [EventKind::Start, EventKind::Slip, EventKind::Open],
                "{mu} {tolerance:e}"
            );
            let open = &record.events()[2];
            let right_side = 1.0 - 0.5 * open["theta'"].powi(2) * open["theta"].sin() / 9.81;
            // Errors of a hundred steps, and the bound of the guard.
            assert!(right_side.abs() < 100.0 * tolerance, "{mu} {tolerance:e}: {right_side:e}");
        }
    }
}
