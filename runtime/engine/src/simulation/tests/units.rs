//! The same scenes in other units. Units that differ by powers of two change no digit: what counts
//! as zero is a part of something that has the same unit.

use super::given::*;
use crate::event::EventKind;
use crate::prelude::*;

/// Units of length, time and mass.
#[derive(Clone, Copy)]
struct Units {
    length: f64,
    time: f64,
    mass: f64,
}

impl Units {
    fn speed(self) -> f64 {
        self.length / self.time
    }

    fn acceleration(self) -> f64 {
        self.speed() / self.time
    }

    fn force(self) -> f64 {
        self.mass * self.acceleration()
    }
}

/// What happens, when and where, in natural units.
type Course = Vec<(EventKind, f64, Vec<f64>)>;

fn compute_course(simulation: &Simulation) -> (Course, usize) {
    let run = simulation.run().unwrap_or_else(|error| panic!("{error}"));
    let (scales, layout) = (simulation.scales(), simulation.layout());
    let natural = |event: &Event| {
        let entries = event.state.iter().enumerate();
        let state = entries.map(|(i, entry)| entry / scales.entry(layout, i)).collect();
        (event.kind, event.t / scales.time, state)
    };
    (run.events().iter().map(natural).collect(), run.log().len())
}

/// The events that all units agree on.
fn check_units(scene: impl Fn(Units) -> Simulation) -> Vec<EventKind> {
    let find = |[length, time, mass]: [i32; 3]| {
        let [length, time, mass] = [length, time, mass].map(|exponent| f64::powi(2.0, exponent));
        compute_course(&scene(Units { length, time, mass }))
    };
    let expected = find([0; 3]);
    for units in [[20, 0, 0], [-20, 0, 0], [0, 20, 0], [0, -20, 0], [0, 0, 20], [-20, 10, -10]] {
        let found = find(units);
        for (one, other) in found.0.iter().zip(&expected.0) {
            assert_eq!(one, other, "{units:?}");
        }
        assert_eq!(found, expected, "{units:?}");
    }
    expected.0.into_iter().map(|(kind, ..)| kind).collect()
}

/// A ball over a rough floor, a wall that comes and wind behind a line.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e, friction = mu)]
#[support(w = wall(d), facing = left, under = P, restitution = e, while("t > s"))]
#[force(P = (q, 0), while("x > c"))]
#[figure(P = (0, h))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Thrown {
    m: f64,
    g: f64,
    e: f64,
    mu: f64,
    d: f64,
    s: f64,
    q: f64,
    c: f64,
    h: f64,
}

#[test]
fn a_ball_bounces_settles_and_stops_alike() {
    let kinds = check_units(|units| {
        let ball = Thrown {
            m: 2.0 * units.mass,
            g: 9.81 * units.acceleration(),
            e: 0.4,
            mu: 0.2,
            d: 3.0 * units.length,
            s: 0.9 * units.time,
            q: -2.0 * units.force(),
            c: 2.0 * units.length,
            h: units.length,
        };
        let pose = Pose::new("x", 0.25 * units.length).with("y", 0.7 * units.length);
        let ball = Simulation::new(&ball).unwrap().start(pose.with("x'", 3.0 * units.speed())).unwrap();
        let struck = [0.5 * units.mass * units.speed(), units.mass * units.speed()];
        ball.impulse("P", struck, 5.0 * units.time).unwrap().limit(9.0 * units.time)
    });
    for kind in [EventKind::Impact, EventKind::Settle, EventKind::Stick, EventKind::Arm, EventKind::Impulse] {
        assert!(kinds.contains(&kind), "{kind:?} {kinds:?}");
    }
}

#[test]
fn a_rod_falls_slides_and_rocks_alike() {
    for (theta, mu, spin) in [(0.4, 0.3, -1.0), (0.4, 0.05, 2.0), (0.0, 0.3, 0.0)] {
        let kinds = check_units(|units| {
            let [m, g] = [3.0 * units.mass, 9.81 * units.acceleration()];
            let sled = Sled { m, l: 1.5 * units.length, g, mu, e: 0.3 };
            let pose = Pose::new("theta", theta).with("theta'", spin / units.time);
            let pose = pose.with("x'", 2.0 * units.speed()).with("y", 0.3 * units.length);
            Simulation::new(&sled).unwrap().start(pose).unwrap().limit(4.0 * units.time)
        });
        assert!(kinds.contains(&EventKind::Settle), "{kinds:?}");
    }
}

#[test]
fn a_bar_slides_off_a_corner_alike() {
    let kinds = check_units(|units| {
        let bar = Overhang { m: units.mass, l: 2.0 * units.length, g: 9.81 * units.acceleration() };
        let pose = Pose::new("theta", 0.6).with("x", -1.9 * units.length * 0.6f64.cos());
        let pose = pose.with("y", -1.9 * units.length * 0.6f64.sin());
        Simulation::new(&bar).unwrap().start(pose).unwrap().limit(2.0 * units.time)
    });
    assert!(kinds.contains(&EventKind::SlideOff), "{kinds:?}");
}

/// A carriage that a drive takes along from where it comes by.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu)]
#[drive(x = d + v * (t - s), while("t > s"))]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Carriage {
    m: f64,
    g: f64,
    mu: f64,
    d: f64,
    v: f64,
    s: f64,
}

#[test]
fn a_drive_takes_hold_alike() {
    for at_once in [false, true] {
        let kinds = check_units(|units| {
            let (v, s, mu) = (0.5 * units.speed(), units.time, 0.05);
            // At t = s the carriage is where the drive begins, or before it.
            let g = 9.81 * units.acceleration();
            let there = 3.0 * units.time - 0.5 * mu * 9.81 * units.time;
            let d = units.length + units.speed() * if at_once { there } else { 1.1 * there };
            let carriage = Carriage { m: 2.0 * units.mass, g, mu, d, v, s };
            let pose = Pose::new("x", units.length).with("x'", 3.0 * units.speed());
            Simulation::new(&carriage).unwrap().start(pose).unwrap().limit(3.0 * units.time)
        });
        assert!(kinds.contains(&EventKind::Impact), "{kinds:?}");
    }
}

/// A carriage on a spring, pushed by a load that falls off within a thousandth of a period.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (-l, 0))]
#[spring(OP, stiffness = k, length = l)]
#[force(P = (f / (1 + (w * (t - s)).powi(2)), 0))]
#[support(P = floor)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Pushed {
    m: f64,
    g: f64,
    l: f64,
    k: f64,
    f: f64,
    w: f64,
    s: f64,
}

#[test]
fn a_sudden_load_is_seen_alike() {
    check_units(|units| {
        let pushed = Pushed {
            m: units.mass,
            g: 9.81 * units.acceleration(),
            l: units.length,
            k: 4.0 * units.mass / (units.time * units.time),
            f: 50.0 * units.force(),
            w: 1e4 / units.time,
            s: 1.3 * units.time,
        };
        let pose = Pose::new("x", 0.1 * units.length);
        Simulation::new(&pushed).unwrap().start(pose).unwrap().tolerance(1e-8).limit(3.0 * units.time)
    });
}
