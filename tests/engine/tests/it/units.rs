//! The same scene in other units.

use liftoff::method::{Dop853, Method, Radau};
use liftoff::prelude::*;
use liftoff_fixtures::{QuickReturn, StruckChain};

/// θ of the first bar at ten times the time l m/p behind an impulse p that strikes the chain at
/// rest after as long a time; lengths in l, masses in m, times in `unit`.
fn turned(method: impl Method, [m, unit]: [f64; 2]) -> f64 {
    let simulation = Simulation::new(&StruckChain { m, l: 1.0 }).unwrap().method(method).tolerance(1e-9);
    let struck =
        simulation.start(Pose::nominal()).unwrap().impulse("C", [0.0, m / unit], 10.0 * unit).unwrap();
    struck.limit(20.0 * unit).run().unwrap().final_state()[0]
}

#[test]
fn an_impulse_tells_the_time_of_what_rests_without_gravity() {
    let expected = turned(Dop853, [1.0, 1.0]);
    assert!(expected.abs() > 1.0, "{expected}");
    for exponent in [-60, -30, 30, 60] {
        let units = [f64::powi(2.0, 31), f64::powi(2.0, exponent)];
        assert!((turned(Dop853, units) - expected).abs() < 1e-9, "2^{exponent}");
        assert!((turned(Radau, units) - expected).abs() < 1e-6, "2^{exponent}");
    }
}

/// A block on a belt, held back by a spring; nothing in its pose tells how large it is.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (-l, 0))]
#[spring(OP, stiffness = k, length = l)]
#[support(P = floor, friction = mu, static = limit, moving = w)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Block {
    m: f64,
    l: f64,
    k: f64,
    mu: f64,
    limit: f64,
    w: f64,
    g: f64,
}

/// In units of length 2³⁰ times larger the block sticks and slips as before.
#[test]
fn a_model_at_the_origin_has_the_size_of_its_spring() {
    let courses = [1.0, 2f64.powi(-30), 2f64.powi(30)].map(|unit| {
        let block = Block { m: 1.0, l: unit, k: 20.0, mu: 0.2, limit: 1.0, w: 0.3 * unit, g: 9.81 * unit };
        let start = Pose::new("x", 0.0).with("x'", 0.0);
        let run =
            Simulation::new(&block).unwrap().start(start).unwrap().tolerance(1e-7).limit(3.0).run().unwrap();
        run.events().iter().map(|event| (event.kind, event.t)).collect::<Vec<_>>()
    });
    let kinds = courses[0].iter().map(|(kind, _)| *kind);
    assert!(kinds.eq([
        EventKind::Start,
        EventKind::Stick,
        EventKind::Slip,
        EventKind::Stick,
        EventKind::End
    ]));
    for course in &courses[1..] {
        assert_eq!(course.len(), courses[0].len(), "{course:?}");
        assert!(
            course.iter().zip(&courses[0]).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-10),
            "{course:?}"
        );
    }
}

/// A hop of 1e-24 m is not what a block is measured by.
#[test]
fn a_hop_below_rounding_is_no_size() {
    let block = Block { m: 1.0, l: 1.0, k: 6.0, mu: 0.4, limit: 0.5, w: 0.6, g: 9.81 };
    let start = Pose::new("x", 0.0).with("y'", 4e-12);
    for tolerance in [1e-6, 5e-13] {
        let run = Simulation::new(&block).unwrap().start(start.clone()).unwrap().tolerance(tolerance);
        let run = run.limit(4.0).run().unwrap_or_else(|error| panic!("{tolerance:e}: {error}"));
        let kinds: Vec<_> = run.events().iter().map(|event| event.kind).collect();
        let events = |kind: EventKind| kinds.iter().filter(|other| **other == kind).count();
        assert_eq!([EventKind::Stick, EventKind::Slip].map(events), [2, 1], "{kinds:?}");
        assert!(run.audit().is_clean(), "{}", run.audit());
    }
}

/// The row of a drive that turns is an angle in every unit of length.
#[test]
fn a_driven_loop_moves_the_same_in_other_units_of_length() {
    let psi = |unit: f64, omega: f64| {
        let [r, l, h] = [0.2, 1.0, 0.5].map(|length| length * unit);
        let run = Simulation::new(&QuickReturn { a: 1.0, b: 2.0, r, l, h, omega }).unwrap().tolerance(1e-10);
        let run = run
            .start(Pose::nominal())
            .unwrap()
            .limit(10.0 / omega)
            .run()
            .unwrap_or_else(|error| panic!("{unit:e}: {error}"));
        assert!(run.audit().is_clean(), "{unit:e}: {}", run.audit());
        assert!(run.events()[0].state[0].abs() < 1e-15, "{unit:e}: {:?}", run.events()[0].state);
        run.final_state()[1]
    };
    let expected = psi(1.0, 5.0);
    // ψ follows from φ alone: (h + r sin φ)/(r cos φ) of its tangent.
    let (sin, cos) = 10.0_f64.sin_cos();
    assert!((expected - (0.5 + 0.2 * sin).atan2(0.2 * cos)).abs() < 1e-9, "{expected}");
    for unit in [-40, -30, 30, 40].map(|exponent| f64::powi(2.0, exponent)) {
        assert!((psi(unit, 5.0) - expected).abs() < 1e-9, "{unit:e}");
        assert!((psi(unit, 5e-9) - expected).abs() < 1e-9, "{unit:e}");
        assert!((psi(unit, 5e9) - expected).abs() < 1e-9, "{unit:e}");
    }
}

/// A wheel at rest, held by the friction of its pin and by a clutch at once.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[pin(O, friction = mu, radius = r)]
#[force(O = (f, 0))]
#[couple(AB = c * t)]
#[drive(phi = 0 * t, while("t < s"))]
#[coordinate(phi = angle(AB), from = right)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
struct Braked {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    f: f64,
    c: f64,
    s: f64,
}

/// Friction acts at the radius of the journal: of R² + (C/r)² → min with r R + C = −c t each has a
/// half, in every unit.
#[test]
fn friction_and_a_clutch_share_a_couple_alike_in_every_unit() {
    let (r, c, late) = (0.03, 0.1, 3.0);
    for [length, time, mass] in
        [[0, 0, 0], [30, 0, 0], [-30, 0, 0], [0, 30, 0], [0, 0, -30], [-30, 30, 30], [29, -29, 31]]
    {
        let [length, time, mass] = [length, time, mass].map(|exponent| f64::powi(2.0, exponent));
        let force = mass * length / (time * time);
        let braked = Braked {
            m: 2.0 * mass,
            l: 0.6 * length,
            mu: 0.2,
            r: r * length,
            f: 40.0 * force,
            c: c * force * length / time,
            s: 9.0 * time,
        };
        let start = Simulation::new(&braked).unwrap().start(Pose::new("phi", 0.0)).unwrap();
        let run = start.limit(4.0 * time).run().unwrap_or_else(|error| panic!("{length:e}: {error}"));
        assert_eq!(run.events().len(), 2, "{:?}", run.events());
        let at = |text: &str| run.function(text).unwrap()(late * time);
        let [friction, couple] = [at("R(O)") / force, at("drive(phi)") / (force * length)];
        assert!((friction + 0.5 * c * late / r).abs() < 1e-11, "{length:e} {time:e} {mass:e}: {friction}");
        assert!((couple + 0.5 * c * late).abs() < 1e-12, "{length:e} {time:e} {mass:e}: {couple}");
    }
}

/// A bead on a rod without mass that a drive tilts.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OB, mass = 0, length = l)]
#[pin(O = (0, 0))]
#[drive(y(B) = r * sin(omega * t))]
#[particle(P, mass = m)]
#[slider(P = bar(OB))]
#[figure(B = (l, 0), P = (l / 2, 0))]
#[coordinate(tilt = angle(OB))]
struct Bead {
    m: f64,
    l: f64,
    r: f64,
    omega: f64,
    g: f64,
}

/// At the start l φ̇ = r ω, half of that for the bead, in units of length 2³⁰ and of mass 2³⁰ too.
#[test]
fn rates_of_massless_bars_are_completed_in_any_units() {
    let powers = [-30, 0, 30].map(|power| 2f64.powi(power));
    for (length, mass) in powers.iter().flat_map(|&length| powers.map(|mass| (length, mass))) {
        let bead = Bead { m: mass, l: length, r: 0.1 * length, omega: 10.0, g: length };
        let run = Simulation::new(&bead).unwrap().limit(0.1).run();
        let run = run.unwrap_or_else(|error| panic!("l = {length:e}, m = {mass:e}: {error}"));
        let rates = &run.events()[0].state;
        let names = run.layout().coordinates.iter().map(|coordinate| coordinate.name);
        let rate = |name: &str| rates[rates.len() / 2 + names.clone().position(|n| n == name).unwrap()];
        assert!((rate("tilt") - 1.0).abs() < 1e-14, "{rates:?}");
        assert!((rate("y_P") / length - 0.5).abs() < 1e-14, "{rates:?}");
    }
}
