//! Joints that let go, against closed forms.

use liftoff::ModelError;
use liftoff::prelude::*;

/// A rod is thrown off its pin.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0), while("t < t_1"))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
struct Thrown {
    m: f64,
    l: f64,
    t_1: f64,
}

/// The same by the two drives that it stands for.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[drive(x(O) = 0, while("t < t_1"))]
#[drive(y(O) = 0, while("t < t_1"))]
#[figure(O = (0, 0), A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
struct Driven {
    m: f64,
    l: f64,
    t_1: f64,
}

fn value(run: &Trajectory, output: &str, t: f64) -> f64 {
    run.function(output).unwrap()(t)
}

/// It turns at ω about its end, which bears m ω² l/2 towards its middle, and about its middle,
/// which goes straight on at ω l/2, from t₁ on.
#[test]
fn a_rod_is_thrown_off_its_pin() {
    let (m, l, t_1, omega) = (2.0, 1.5, 0.3, 4.0);
    let start = || Pose::new("phi", 0.0).with("phi'", omega);
    let thrown = Simulation::new(&Thrown { m, l, t_1 }).unwrap().start(start()).unwrap();
    let thrown = thrown.limit(2.0).run().unwrap();
    let [_, event, end] = thrown.events() else { panic!("{:?}", thrown.events()) };
    assert_eq!((event.kind, event.t), (EventKind::Disarm, t_1));
    assert_eq!(&event.supports[..], ["drive x(O)", "drive y(O)"]);
    let rest = 2.0 - t_1;
    let middle = |t: f64| [0.5 * l * (omega * t).cos(), 0.5 * l * (omega * t).sin()];
    let [x, y] = middle(t_1);
    let along = [x - omega * y * rest, y + omega * x * rest];
    let [u, v] = middle(2.0);
    assert!((end["phi"] - 2.0 * omega).abs() < 1e-12, "{end}");
    assert!((end["x_O"] - (along[0] - u)).abs() < 1e-12 && (end["y_O"] - (along[1] - v)).abs() < 1e-12);
    let pull = m * omega * omega * l / 2.0;
    assert!((value(&thrown, "fx(O)", 0.2) + pull * (omega * 0.2).cos()).abs() < 1e-11);
    assert!((value(&thrown, "fy(O)", 0.2) + pull * (omega * 0.2).sin()).abs() < 1e-11);
    assert!((value(&thrown, "N(O)", 0.2) - pull).abs() < 1e-11);
    assert_eq!(["fx(O)", "fy(O)", "N(O)"].map(|output| value(&thrown, output, 1.0)), [0.0; 3]);
    assert!((value(&thrown, "Lz", 2.0) - m * l * l / 3.0 * omega).abs() < 1e-11);
    let driven = Simulation::new(&Driven { m, l, t_1 }).unwrap().start(start()).unwrap();
    assert_eq!(driven.limit(2.0).run().unwrap().final_state(), thrown.final_state());
}

/// A rod swings until its pin breaks.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0), breaks("N(O) > f"))]
#[force(A = (0, -p), while("t > t_1"))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Swinging {
    m: f64,
    l: f64,
    g: f64,
    f: f64,
    p: f64,
    t_1: f64,
}

const SWINGING: Swinging = Swinging { m: 2.0, l: 1.5, g: 9.81, f: 30.0, p: 0.0, t_1: 10.0 };

/// Along the rod the pin bears m g (5 cos φ − 3 cos φ₀)/2, across it m g (sin φ)/4: a quadratic
/// equation in cos φ where both together are f.
#[test]
fn a_pin_breaks_at_a_force() {
    let Swinging { m, l, g, f, .. } = SWINGING;
    let begin = 1.0_f64;
    let (c, strength) = (begin.cos(), f / (m * g));
    let [square, half, rest] = [99.0 / 16.0, 3.75 * c, 2.25 * c * c + 0.0625 - strength * strength];
    let cosine = (half + (half * half - square * rest).sqrt()) / square;
    let simulation = Simulation::new(&SWINGING).unwrap().start(Pose::new("phi", begin)).unwrap();
    let run = simulation.clone().limit(2.0).run().unwrap();
    let [start, event, end] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((event.kind, &event.supports[..]), (EventKind::Release, &["drive x(O)", "drive y(O)"][..]));
    assert!((event["phi"].cos() - cosine).abs() < 1e-12, "{} {cosine}", event["phi"].cos());
    let first = (m * g) * (c.powi(2) + (begin.sin() / 4.0).powi(2)).sqrt();
    assert!((value(&run, "N(O)", start.t) - first).abs() < 1e-11);
    // The middle falls freely, and nothing holds the rod again.
    let (t, rate) = (end.t - event.t, event["phi'"]);
    let height = |phi: f64, y: f64| y - 0.5 * l * phi.cos();
    let fallen = height(event["phi"], 0.0) + 0.5 * l * rate * event["phi"].sin() * t - 0.5 * g * t * t;
    assert!((end["phi"] - event["phi"] - rate * t).abs() < 1e-11, "{end}");
    assert!((height(end["phi"], end["y_O"]) - fallen).abs() < 1e-11, "{end}");
    // What has broken stays broken where the run is continued, and the event says so.
    let middle = event.t + 0.5 * t;
    let pose = Pose::of_state(Swinging::LAYOUT, &run.state(middle));
    let rest = simulation.continued(middle, &pose).unwrap().limit(2.0).run().unwrap();
    assert_eq!(rest.events()[1].kind, EventKind::Release);
    assert!((rest.final_state()[0] - run.final_state()[0]).abs() < 1e-10);
}

/// Beyond its strength at the start it breaks at once, and so it does where a load jumps; both of
/// its drives let go together.
#[test]
fn a_pin_breaks_where_its_force_jumps() {
    let weak = Swinging { f: 10.0, ..SWINGING };
    let loaded = Swinging { p: 15.0, t_1: 0.5, ..SWINGING };
    for (model, at) in [(weak, 0.0), (loaded, 0.5)] {
        let simulation = Simulation::new(&model).unwrap().start(Pose::new("phi", 0.0)).unwrap();
        let run = simulation.limit(1.0).run().unwrap();
        let broken: Vec<_> = run.events().iter().filter(|event| event.kind == EventKind::Release).collect();
        let [event] = broken[..] else { panic!("{:?}", run.events()) };
        assert_eq!((event.t, &event.supports[..]), (at, &["drive x(O)", "drive y(O)"][..]));
        // m ÿ = −m g − p of the middle.
        let fall = -0.5 * (model.g + model.p / model.m) * (1.0 - at) * (1.0 - at);
        assert!((value(&run, "y(O)", 1.0) - fall).abs() < 1e-11, "{at}");
    }
}

/// Two rods, stiff as one, until the moment between them breaks the weld.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[weld(AB, BC, angle = 0, breaks("abs(drive(angle(AB, BC))) > c"))]
#[figure(B = (l, 0), C = (2 * l, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(psi = angle(BC), from = right)]
struct Chimney {
    m: f64,
    l: f64,
    g: f64,
    c: f64,
}

/// In the middle of a falling chimney the moment is m g l (cos φ)/8, whatever its rate.
#[test]
fn a_weld_breaks_at_a_moment() {
    let (m, l, g, c) = (2.0, 1.5, 9.81, 3.0);
    let start = Pose::new("phi", 1.2).with("psi", 1.2);
    let simulation = Simulation::new(&Chimney { m, l, g, c }).unwrap().start(start).unwrap();
    let run = simulation.limit(2.0).run().unwrap();
    let event = &run.events()[1];
    assert_eq!((event.kind, &event.supports[..]), (EventKind::Release, &["drive angle(AB, BC)"][..]));
    assert!((event["phi"].cos() - 8.0 * c / (m * g * l)).abs() < 1e-12, "{event}");
    assert!((event["phi"] - event["psi"]).abs() < 1e-12);
    assert!((value(&run, "E", 2.0) - value(&run, "E", 0.0)).abs() < 1e-10);
}

/// A force decides whether a pin holds only once: `breaks`.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0), while("N(O) < f"))]
#[figure(A = (l, 0))]
struct Chattering {
    m: f64,
    l: f64,
    f: f64,
}

/// Nothing that is called Q bears anything.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0), breaks("N(Q) > f"))]
#[figure(A = (l, 0))]
struct Misnamed {
    m: f64,
    l: f64,
    f: f64,
}

#[test]
fn conditions_that_no_joint_has_are_refused() {
    let refused = |error: Result<Simulation, ModelError>| error.map(|_| ()).unwrap_err();
    let chattering = refused(Simulation::new(&Chattering { m: 1.0, l: 1.0, f: 1.0 }));
    assert!(matches!(&chattering, ModelError::SwitchedByForce { of } if of == "drive x(O)"), "{chattering}");
    assert!(chattering.to_string().ends_with("what lets go for good `breaks`"), "{chattering}");
    let misnamed = refused(Simulation::new(&Misnamed { m: 1.0, l: 1.0, f: 1.0 })).to_string();
    assert_eq!(
        misnamed,
        "the condition `breaks` of drive x(O): no support `Q`; known: drive x(O), drive y(O)"
    );
}

/// A rod turns about a pin that is taken away at 0.3 s, a mass on its middle lets go at 0.1 s.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (-1, 0), while("t < 0.3"))]
#[particle(P, mass = p)]
#[drive(along(P, AB) = l / 2, while("t < 0.1"))]
#[support(one = bar(AB), under = P, facing = left, while("t < 0.1"))]
#[support(two = bar(AB), under = P, facing = right, while("t < 0.1"))]
#[figure(B = (l - 1, 0), P = (l / 2 - 1, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(u = x(P))]
#[coordinate(v = y(P))]
struct Flung {
    m: f64,
    l: f64,
    p: f64,
}

/// As one body about A at 4/s, then the rod alone at the same rate, then free; the mass goes on at
/// 2 from its place at 0.1 s. A at 2 s by an integration of the whole in maximal coordinates.
#[test]
fn a_pin_and_a_held_mass_let_go() {
    let start = Pose::new("phi", 0.0).with("phi'", 4.0).with("u", -0.5).with("v", 0.0);
    let simulation = Simulation::new(&Flung { m: 12.0, l: 1.0, p: 2.0 }).unwrap();
    let start = start.with("u'", 0.0).with("v'", 2.0);
    let run = simulation.start(start).unwrap().limit(2.0).run().unwrap();
    for (output, expected) in
        [("x(A)", -3.915_004), ("y(A)", 1.203_357), ("x(P)", -2.019_259), ("y(P)", 3.694_741)]
    {
        assert!((value(&run, output, 2.0) - expected).abs() < 1e-6, "{output} {}", value(&run, output, 2.0));
    }
}
