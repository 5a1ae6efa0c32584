//! Loops with more joints than needed: rows that depend on each other wherever the loops are
//! closed.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff::{LoggedDecision, RunCause, StartError};

/// A rod on three equal cranks between pins on a slope, the figure drawn from rounded numbers. The
/// pin of the middle one is `e` off.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AE, mass = m, length = 3 * l)]
#[point(C = AE, at = l)]
#[bar(OA, mass = m, length = r)]
#[bar(PC, mass = 2 * m, length = r)]
#[bar(QE, mass = 3 * m, length = r)]
#[pin(O = (0, 0))]
#[pin(P = (0.96 * l + e, 0.28 * l))]
#[pin(Q = (2.88 * l, 0.84 * l))]
#[figure(A = (0.02, -r), C = (0.95 * l, 0.27 * l - r), E = (2.9 * l, 0.86 * l - r))]
#[coordinate(phi = angle(OA), from = down)]
struct ThreeCranks {
    #[value(1)]
    m: f64,
    #[value(1)]
    l: f64,
    #[value(0.5)]
    r: f64,
    #[value(9.81)]
    g: f64,
    #[value(0)]
    e: f64,
}

/// The same without the middle crank, the first one as heavy as both.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AE, mass = m, length = 3 * l)]
#[bar(OA, mass = 3 * m, length = r)]
#[bar(QE, mass = 3 * m, length = r)]
#[pin(O = (0, 0))]
#[pin(Q = (2.88 * l, 0.84 * l))]
#[figure(A = (0, -r), E = (2.88 * l, 0.84 * l - r))]
#[coordinate(phi = angle(OA), from = down)]
struct TwoCranks {
    m: f64,
    l: f64,
    r: f64,
    g: f64,
}

const THREE: ThreeCranks = ThreeCranks { m: 1.0, l: 1.0, r: 0.5, g: 9.81, e: 0.0 };
const TWO: TwoCranks = TwoCranks { m: 1.0, l: 1.0, r: 0.5, g: 9.81 };

fn run<M: BarSystem>(model: &M, pose: Pose) -> Trajectory {
    let run = Simulation::new(model).unwrap().start(pose).unwrap().limit(3.0).run();
    run.unwrap_or_else(|error| panic!("{error}"))
}

fn value(run: &Trajectory, output: &str, t: f64) -> f64 {
    run.value(&Output::parse(run.layout(), output).unwrap(), t)
}

/// Past the position in which rod and cranks are in line too, at the start and in motion.
#[test]
fn a_third_crank_is_as_a_heavier_one() {
    for (phi, rate) in [(1.0, 0.0), (2.0, 0.0), (-3.0, 0.0), (1.0, 9.0)] {
        let pose = || Pose::new("phi", phi).with("phi'", rate);
        let [three, two] = [run(&THREE, pose()), run(&TWO, pose())];
        for t in [0.0, 0.7, 1.9, 3.0] {
            for output in ["phi", "phi'"] {
                let [a, b] = [&three, &two].map(|run| value(run, output, t));
                assert!((a - b).abs() < 1e-9, "{phi} {rate} {t} {output}: {a} {b}");
            }
            // All that the ground carries, whoever of the pins has it: some 70 N.
            for force in ["fx", "fy"] {
                let sum = |run: &Trajectory, pins: &[&str]| -> f64 {
                    pins.iter().map(|pin| value(run, &format!("{force}({pin})"), t)).sum()
                };
                let [a, b] = [sum(&three, &["O", "P", "Q"]), sum(&two, &["O", "Q"])];
                assert!((a - b).abs() < 1e-7, "{phi} {rate} {t} {force}: {a} {b}");
            }
        }
        let not_unique = |entry: &liftoff::LogEntry| entry.decision == LoggedDecision::ReactionsNotUnique;
        assert!(three.log().iter().any(not_unique) && !two.log().iter().any(not_unique));
    }
}

/// With a pin out of place the three hold the rod: there is a position, and no other.
#[test]
fn unequal_cranks_do_not_move() {
    let off = ThreeCranks { e: 0.05, ..THREE };
    let error = Simulation::new(&off).unwrap().limit(1.0).run().unwrap_err();
    let expected = StartError::Immobile { coordinates: 4, constraints: 4 };
    assert_eq!(*error.cause(), RunCause::Start(expected));
}

/// Three bars of length a between pins that are 4 apart.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = 1, length = a)]
#[bar(AB, mass = 1, length = a)]
#[bar(CB, mass = 1, length = a)]
#[pin(O = (0, 0))]
#[pin(C = (4, 0))]
#[figure(A = (1.25, 0.83), B = (2.75, 0.83))]
struct Bars {
    #[value(1.5)]
    a: f64,
    #[value(9.81)]
    g: f64,
}

/// What bars lack that are too short is the distance of the pins less their lengths.
#[test]
fn bars_that_are_too_short_are_reported_with_what_they_lack() {
    let from = |theta: f64, a: f64| (4.0 - a * theta.cos()).hypot(a * theta.sin());
    let nominal = |a: f64| (Pose::nominal(), a, 4.0 - 3.0 * a);
    let given = |theta: f64, a: f64| (Pose::new("theta_OA", theta), a, from(theta, a) - 2.0 * a);
    for (pose, a, expected) in [nominal(1.0), nominal(1.2), given(-1.0, 1.2), given(2.0, 1.5)] {
        let simulation = Simulation::new(&Bars { a, g: 9.81 }).unwrap();
        let error = simulation.start(pose).map(drop).unwrap_err();
        let StartError::Broken { joint, gap } = error else { panic!("{error}") };
        assert_eq!(joint, "pin C");
        // By the squares of the gaps, which are flat at their least.
        assert!((gap - expected).abs() < 1e-6, "{a}: {gap}");
    }
}

/// The middle of a trammel's bar moves on a circle: a crank there holds nothing.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = 2 * l)]
#[point(M = AB, at = l)]
#[bar(OM, mass = 2 * m, length = l)]
#[pin(O = (0, 0))]
#[slider(A = horizontal(0))]
#[slider(B = vertical(0))]
#[figure(A = (1.6 * l, 0), B = (0, 1.2 * l), M = (0.8 * l, 0.6 * l))]
#[coordinate(theta = angle(OM))]
struct Trammel {
    #[value(1)]
    m: f64,
    #[value(1)]
    l: f64,
    #[value(9.81)]
    g: f64,
}

/// θ″ = −(3/2) (g/l) cos θ.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OB, mass = 1, length = l)]
#[pin(O = (0, 0))]
#[figure(B = (l, 0))]
#[coordinate(theta = angle(OB))]
struct Pendulum {
    l: f64,
    g: f64,
}

/// T = m l² θ′², V = 2 m g l sin θ: as a bar of length 3 l/2.
#[test]
fn a_trammel_with_a_crank_is_a_pendulum() {
    let (trammel, pendulum) = (Trammel { m: 1.0, l: 1.0, g: 9.81 }, Pendulum { l: 1.5, g: 9.81 });
    for theta in [0.5, 2.0, 3.0, -1.0] {
        let [a, b] = [run(&trammel, Pose::new("theta", theta)), run(&pendulum, Pose::new("theta", theta))];
        for t in [0.3, 1.1, 3.0] {
            let [a, b] = [&a, &b].map(|run| value(run, "theta", t));
            assert!((a - b).abs() < 1e-9, "{theta} {t}: {a} {b}");
        }
    }
}

/// A rod on four equal cranks: more rows than coordinates.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(RS, mass = m, length = 2)]
#[point(K1 = RS, at = 0.5)]
#[point(K2 = RS, at = 1.1)]
#[bar(c0 = O0 -> R, mass = m, length = r)]
#[bar(c1 = O1 -> K1, mass = m, length = r)]
#[bar(c2 = O2 -> K2, mass = m, length = r)]
#[bar(c3 = O3 -> S, mass = m, length = r)]
#[pin(O0 = (0, 0))]
#[pin(O1 = (0.5, 0))]
#[pin(O2 = (1.1, 0))]
#[pin(O3 = (2, 0))]
#[figure(R = (0, -r), K1 = (0.5, -r), K2 = (1.1, -r), S = (2, -r))]
#[coordinate(phi = angle(c0), from = down)]
struct FourCranks {
    m: f64,
    r: f64,
    g: f64,
}

/// A rod on two cranks, as heavy as four.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(RS, mass = m, length = 2)]
#[bar(c0 = O0 -> R, mass = 2 * m, length = r)]
#[bar(c3 = O3 -> S, mass = 2 * m, length = r)]
#[pin(O0 = (0, 0))]
#[pin(O3 = (2, 0))]
#[figure(R = (0, -r), S = (2, -r))]
#[coordinate(phi = angle(c0), from = down)]
struct HeavyCranks {
    m: f64,
    r: f64,
    g: f64,
}

#[test]
fn four_cranks_move_as_two() {
    let start = || Pose::new("phi", 0.5).with("phi'", 1.0);
    let four = run(&FourCranks { m: 1.3, r: 0.5, g: 9.81 }, start());
    let two = run(&HeavyCranks { m: 1.3, r: 0.5, g: 9.81 }, start());
    for t in [0.5, 1.3, 2.9] {
        let [a, b] = [&four, &two].map(|run| value(run, "phi", t));
        assert!((a - b).abs() < 1e-9, "{t}: {a} {b}");
    }
}

/// A rod on three equal cranks of which one is driven.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(RS, mass = m, length = 2)]
#[point(K = RS, at = 0.7)]
#[bar(c0 = O0 -> R, mass = m, length = r)]
#[bar(c1 = O1 -> K, mass = m, length = r)]
#[bar(c2 = O2 -> S, mass = m, length = r)]
#[pin(O0 = (0, 0))]
#[pin(O1 = (0.7, 0))]
#[pin(O2 = (2, 0))]
#[drive(phi = 0.5 + w * t)]
#[figure(R = (0, -r), K = (0.7, -r), S = (2, -r))]
#[coordinate(phi = angle(c0), from = down)]
struct DrivenCranks {
    m: f64,
    r: f64,
    w: f64,
    g: f64,
}

/// The drive bears the weight's couple, m r g sin φ of the rod and m r g sin φ / 2 of each crank.
#[test]
fn one_of_three_cranks_is_driven() {
    let (m, r, w, g) = (1.3, 0.5, 3.0, 9.81);
    let run = run(&DrivenCranks { m, r, w, g }, Pose::new("phi", 0.5).with("phi'", w));
    for t in [0.1, 0.7, 1.9] {
        let phi = 0.5 + w * t;
        assert!((value(&run, "phi", t) - phi).abs() < 1e-9, "{t}");
        let couple = 2.5 * m * r * g * phi.sin();
        assert!((value(&run, "drive(phi)", t) - couple).abs() < 1e-8 * couple.abs().max(1.0), "{t}");
    }
}

/// Two bars between pins as far apart as they are long, and drawn so: they can only stretch.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(1)]
#[pin(O = (0, 0))]
#[pin(B = (2, 0))]
#[bar(OA, mass = 1, length = 1)]
#[bar(AB, mass = 1, length = 1)]
#[figure(A = (1, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(AB), from = right)]
struct Stretched;

/// No finite reactions hold them, and no motion satisfies the loop.
#[test]
fn stretched_bars_are_a_singular_position() {
    for method in MethodId::ALL {
        let run = Simulation::new(&Stretched).unwrap().method(method).limit(1.0);
        let error = run.start(Pose::new("phi", 0.0).with("psi", 0.0)).unwrap().run().unwrap_err();
        assert!(matches!(error.cause(), RunCause::Loop { t: 0.0, .. }), "{}: {error}", method.name());
    }
}
