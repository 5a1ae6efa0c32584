//! Loads that are not analytic in the motion: drag of the square of the speed, a one-sided spring,
//! by every method.

use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A ball with drag −c v |v|.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (-c * vx(P) * sqrt(vx(P) * vx(P) + vy(P) * vy(P)), -c * vy(P) * sqrt(vx(P) * vx(P) + vy(P) * vy(P))))]
struct Drag {
    m: f64,
    c: f64,
    g: f64,
}

/// The same over a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 1))]
#[force(P = (-c * vx(P) * sqrt(vx(P) * vx(P) + vy(P) * vy(P)), -c * vy(P) * sqrt(vx(P) * vx(P) + vy(P) * vy(P))))]
struct Dropped {
    m: f64,
    c: f64,
    g: f64,
}

/// A block under dry friction, −μ v/|v|, which has no motion once it stops.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (-mu * vx(P) / sqrt(vx(P) * vx(P)), 0))]
struct Friction {
    m: f64,
    mu: f64,
}

/// A ball over a spring that only pushes: k (|y| − y)/2.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (0, k * (sqrt(y * y) - y) / 2))]
struct Bumper {
    m: f64,
    k: f64,
    g: f64,
}

/// A mass on a spring that may pass its anchor, whose force then changes at once from a push to the
/// one side to one to the other.
#[derive(BarSystem)]
#[ground(O = (0, 0))]
#[particle(P, mass = m)]
#[spring(OP, stiffness = k, length = l, damping = 0)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, l))]
struct Anchored {
    m: f64,
    k: f64,
    l: f64,
}

/// The book's pendulum with drag at its end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[force(drag = (-c * vx(A) * sqrt(vx(A) * vx(A) + vy(A) * vy(A)), -c * vy(A) * sqrt(vx(A) * vx(A) + vy(A) * vy(A))), at = A)]
#[couple(OA = -k * sin(phi) / (1 + phi * phi))]
struct Magnet {
    m: f64,
    l: f64,
    c: f64,
    k: f64,
    g: f64,
}

const G: f64 = 9.81;
/// φ(3) from φ = 0, φ̇ = 0.5.
const MOVING: f64 = 0.067_133_874_144_802_93;
/// φ(2) from φ = 0.4 at rest.
const AT_REST: f64 = -0.200_653_886_466_304_75;
const MAGNET: Magnet = Magnet { m: 1.0, l: 1.0, c: 0.2, k: 3.0, g: G };

fn ran<M: BarSystem>(model: &M, method: MethodId, tolerance: f64, start: Pose, t: f64) -> Trajectory {
    let simulation = Simulation::new(model).unwrap().tolerance(tolerance).method(method);
    simulation
        .start(start)
        .unwrap()
        .limit(t)
        .run()
        .unwrap_or_else(|error| panic!("{} at {tolerance:e}: {error}", method.name()))
}

/// All methods at all tolerances, each within ten times of what it was given.
fn each<M: BarSystem>(model: &M, start: impl Fn() -> Pose, t: f64, (entry, exact): (usize, f64)) {
    let mut wrong = Vec::new();
    for method in MethodId::ALL {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let run = ran(model, method, tolerance, start(), t);
            let error = (run.final_state()[entry] - exact).abs();
            if error.is_nan() || error > 10.0 * tolerance {
                wrong.push(format!("{} at {tolerance:e}: {error:e}", method.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn thrown() -> Pose {
    Pose::new("x", 0.0).with("y", 0.0).with("y'", 5.0)
}

/// v̇ = −g − c v² up, v̇ = −g + c v² down, m = 1: the speed is √(g/c) tan, then √(g/c) tanh of √(g
/// c) times the time to and from the top.
#[test]
fn a_ball_thrown_up_through_air_turns_at_rest() {
    let (c, v): (f64, f64) = (0.5, 5.0);
    let pace = (G * c).sqrt();
    let up = (v * (c / G).sqrt()).atan() / pace;
    let top = (c * v * v / G).ln_1p() / (2.0 * c);
    let y = top - (pace * (1.0 - up)).cosh().ln() / c;
    // By the same formulas with 30 digits.
    assert!((y + 0.655_267_504_620_175_8).abs() < 1e-15);
    each(&Drag { m: 1.0, c, g: G }, thrown, 1.0, (1, y));
}

#[test]
fn a_ball_falls_from_rest_through_air() {
    let c: f64 = 0.5;
    let y = -(G * c).sqrt().cosh().ln() / c;
    each(&Drag { m: 1.0, c, g: G }, || Pose::new("x", 0.0).with("y", 0.0), 1.0, (1, y));
}

/// Parabolas above, arcs of an oscillation about −g/k below, from y = 1 at rest.
fn bounced(k: f64, t: f64) -> f64 {
    let (fall, pace) = ((2.0 / G).sqrt(), k.sqrt());
    let (speed, sag) = ((2.0 * G).sqrt(), G / k);
    // y = −s + s cos ωt − (v/ω) sin ωt is zero again at tan (ωt/2) = −v/(ω s).
    let contact = 2.0 * (core::f64::consts::PI - (speed / (pace * sag)).atan()) / pace;
    let t = t % (2.0 * fall + contact);
    let (above, below) = (
        |t: f64| 1.0 - 0.5 * G * t * t,
        |t: f64| sag * ((pace * t).cos() - 1.0) - speed / pace * (pace * t).sin(),
    );
    if t < fall {
        above(t)
    } else if t < fall + contact {
        below(t - fall)
    } else {
        above(2.0 * fall + contact - t)
    }
}

#[test]
fn a_ball_falls_on_a_one_sided_spring() {
    let bumper = Bumper { m: 1.0, k: 100.0, g: G };
    for t in [0.8, 1.0, 2.0] {
        each(&bumper, || Pose::new("x", 0.0).with("y", 1.0), t, (1, bounced(100.0, t)));
    }
}

/// |y| − l = R cos t from y = l + R at rest, m = k = 1, to the anchor at cos t = −l/R; beyond it the same on the other side,
/// back in time.
fn passed(l: f64, reach: f64, t: f64) -> f64 {
    let to_anchor = (-l / reach).acos();
    let (trips, rest) = ((t / (2.0 * to_anchor) + 0.5).floor(), t);
    let side = if trips % 2.0 == 0.0 { 1.0 } else { -1.0 };
    side * (l + reach * (rest - 2.0 * to_anchor * trips).cos())
}

/// Steps planned to end at the anchor may end just behind it, which made Gauss's method go on
/// without a word with what it had found beyond. The end of the run is within ten tolerances for
/// each passage.
#[test]
fn a_spring_passes_its_anchor() {
    let anchored = Anchored { m: 1.0, k: 1.0, l: 1.0 };
    let mut wrong = Vec::new();
    for method in MethodId::ALL {
        for (n, tolerance) in (0..24).zip([1e-5, 1e-6, 1e-8, 1e-9, 1e-11, 1e-12].into_iter().cycle()) {
            let reach = 1.5 + 0.37 * f64::from(n);
            let run = ran(&anchored, method, tolerance, Pose::new("x", 0.0).with("y", 1.0 + reach), 12.0);
            let error = (run.final_state()[1] - passed(1.0, reach, 12.0)).abs();
            if error.is_nan() || error > 50.0 * tolerance * reach {
                wrong.push(format!("{} at {tolerance:e}, {reach}: {error:e}", method.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// φ̈ = −3 g/2 sin φ − 3 c φ̇ |φ̇| − 3 k sin φ/(1 + φ²), m = l = 1. Its values by Taylor series
/// with 30 digits, begun anew at each zero of φ̇.
#[test]
fn a_pendulum_swings_through_air() {
    each(&MAGNET, || Pose::new("phi", 0.0).with("phi'", 0.5), 3.0, (0, MOVING));
    each(&MAGNET, || Pose::new("phi", 0.4), 2.0, (0, AT_REST));
}

/// v = √(g/c) tanh(√(g c) t) down to y = 0, where it stays at rest: what decides that asks for the
/// derivatives of the root at its zero.
#[test]
fn a_ball_lands_through_air_and_rests() {
    let c: f64 = 0.5;
    let lands = (c.exp().acosh()) / (G * c).sqrt();
    for method in MethodId::ALL {
        let dropped = Dropped { m: 1.0, c, g: G };
        let run = ran(&dropped, method, 1e-9, Pose::new("x", 0.0).with("y", 1.0), 2.0);
        let first = run.events().iter().map(|event| event.t).find(|t| *t > 0.0).unwrap();
        assert!((first - lands).abs() < 1e-8, "{}: {first} for {lands}", method.name());
        let [.., y, _, rate] = run.final_state()[..] else { panic!("four entries") };
        assert!(y.abs() < 1e-9 && rate.abs() < 1e-9, "{}: {y:e}, {rate:e}", method.name());
    }
}

/// Nearly upwards: the speed at the top is small and not zero, between the steps that a tolerance
/// tells apart.
#[test]
fn a_ball_passes_its_top_slowly() {
    let drag = Drag { m: 1.0, c: 0.5, g: G };
    for pace in [1e-9, 1e-6, 1e-3, 1e-1] {
        let start = || thrown().with("x'", pace);
        // Ten steps of each; DOP853's are short enough to see the top for all that they are not cut
        // there.
        let expected = ran(&drag, MethodId::Dop853, 1e-14, start(), 1.0).final_state();
        for method in [MethodId::Auto, MethodId::Tsit5, MethodId::Radau] {
            let state = ran(&drag, method, 1e-9, start(), 1.0).final_state();
            let error = (0..4).map(|i| (state[i] - expected[i]).abs()).fold(0.0, f64::max);
            assert!(error < 1e-8, "{} at {pace:e}: {error:e}", method.name());
        }
    }
}

/// v = 1 − μ t up to rest; beyond, the right-hand side points back from both sides, and the run
/// says that it does not go on.
#[test]
fn dry_friction_ends_with_what_was_computed() {
    let friction = Friction { m: 1.0, mu: 1.0 };
    let start = || Pose::new("x", 0.0).with("y", 0.0).with("x'", 1.0);
    for method in MethodId::ALL {
        let x = ran(&friction, method, 1e-8, start(), 0.9).final_state()[0];
        assert!((x - (0.9 - 0.5 * 0.81)).abs() < 1e-7, "{}: {x}", method.name());
        let simulation = Simulation::new(&friction).unwrap().tolerance(1e-8).method(method);
        let error = simulation.start(start()).unwrap().limit(1.1).run().unwrap_err();
        let x = error.trajectory().final_state()[0];
        assert!((x - 0.5).abs() < 1e-7, "{}: {x}, {error}", method.name());
    }
}

/// The speed of a pendulum's end is |l φ̇|; of a ball it is the root of a sum of squares.
#[test]
fn a_layout_lists_where_equations_are_not_analytic() {
    use liftoff_core::model::Kink;
    assert_eq!(Magnet::LAYOUT.kinks, [Kink::Sign]);
    assert_eq!(Bumper::LAYOUT.kinks, [Kink::Sign]);
    assert_eq!(Drag::LAYOUT.kinks, [Kink::Radicand]);
    assert_eq!(liftoff_fixtures::PairOnCorners::LAYOUT.kinks, []);
}
