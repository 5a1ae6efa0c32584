//! Contacts with Coulomb friction against closed forms.

use core::f64::consts::PI;

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_fixtures::Belt;

/// A block on a slope.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = slope(alpha), friction = mu, static = mu_s)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Block {
    m: f64,
    g: f64,
    alpha: f64,
    mu: f64,
    mu_s: f64,
}

/// A mass on a rough floor that a spring pulls at.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, friction = mu)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 0))]
struct Oscillator {
    m: f64,
    g: f64,
    k: f64,
    mu: f64,
}

/// A rod that topples from the upright about its rough foot.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = up)]
#[figure(A = (0, 0), B = (0.1, 1))]
struct Toppling {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
}

pub fn run(simulation: Simulation) -> Trajectory {
    simulation.run().unwrap_or_else(|error| panic!("{error}"))
}

/// Up a slope with the speed v it stops after v²/2g(sin α + μ cos α), and slides back where tan α >
/// μₛ.
#[test]
fn a_block_slides_up_stops_and_slides_back_or_stays() {
    let (g, v) = (9.81, 2.0);
    for (alpha, mu, mu_s) in [(0.3_f64, 0.2, 0.25), (0.5, 0.2, 0.3), (0.3, 0.4, 0.5)] {
        let block = Block { m: 1.3, g, alpha, mu, mu_s };
        let pose = Pose::new("x", 0.0).with("x'", v * alpha.cos());
        let record = run(Simulation::new(&block).unwrap().start(pose).unwrap().limit(2.0).tolerance(1e-10));
        let deceleration = g * (alpha.sin() + mu * alpha.cos());
        let event = &record.events()[1];
        assert!((event.t - v / deceleration).abs() < 1e-10, "{event}");
        let way = v * v / (2.0 * deceleration);
        assert!((event["x"] - way * alpha.cos()).abs() < 1e-10);
        if alpha.tan() > mu_s {
            assert_eq!(event.kind, EventKind::Reverse);
            let (t, a) = (2.0 - event.t, g * (alpha.sin() - mu * alpha.cos()));
            let end = record.events().last().unwrap();
            assert!((end["x"] - (way - 0.5 * a * t * t) * alpha.cos()).abs() < 1e-9);
        } else {
            assert_eq!(event.kind, EventKind::Stick);
        }
    }
}

/// Eight turning points, each amplitude less by 2μg m/k, rest at 15 − √205 after atan(6/13) + 7π
/// (Leine and Nijmeijer).
#[test]
fn the_friction_oscillator_comes_to_rest() {
    let oscillator = Oscillator { m: 1.0, g: 10.0, k: 1.0, mu: 0.1 };
    let pose = Pose::new("x", 12.0).with("x'", 6.0);
    for method in MethodId::ALL {
        let simulation = Simulation::new(&oscillator).unwrap().start(pose.clone()).unwrap();
        let record = run(simulation.limit(40.0).tolerance(1e-10).method(method));
        let kinds: Vec<EventKind> = record.events().iter().map(|event| event.kind).collect();
        assert_eq!(
            kinds.iter().filter(|kind| **kind == EventKind::Reverse).count(),
            7,
            "{}: {kinds:?}",
            method.name()
        );
        let rest = record.events().iter().find(|event| event.kind == EventKind::Stick).expect("rest");
        assert!((rest.t - (6.0_f64 / 13.0).atan() - 7.0 * PI).abs() < 1e-8, "{}: {rest}", method.name());
        assert!((rest["x"] - 15.0 + 205.0_f64.sqrt()).abs() < 1e-8, "{}: {rest}", method.name());
        assert_eq!(record.events().last().unwrap().kind, EventKind::End);
    }
}

/// Angles at which it slips, computed by other codes.
#[test]
fn a_toppling_rod_slips_at_known_angles() {
    let angles = [
        (0.1, 7.663_677_462_733_18),
        (0.2, 15.519_254_335_380_93),
        (0.3, 24.165_715_024_631_55),
        (0.35, 29.812_809_570_843_07),
        (0.4, 51.422_928_484_361_59),
        (0.5, 51.977_855_451_506_29),
        (1.0, 54.047_854_471_404_08),
        (10.0, 62.197_657_220_704_1),
    ];
    for (mu, degrees) in angles {
        let rod = Toppling { m: 1.0, l: 1.0, g: 1.0, mu };
        let start = 1e-3_f64;
        let pose = Pose::new("theta", start)
            .with("x'", 0.0)
            .with("theta'", (6.0 * (0.5 * start).sin().powi(2)).sqrt());
        let record = run(Simulation::new(&rod).unwrap().start(pose).unwrap().limit(60.0).tolerance(1e-14));
        let slip = record.events().iter().find(|event| event.kind == EventKind::Slip).expect("a slip");
        assert!((slip["theta"].to_degrees() - degrees).abs() < 1e-11, "{mu}: {slip}");
    }
}

/// A table's edge under a rod.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(CD, mass = m, length = 2 * a)]
#[support(E = corner(0, 0), under = CD, friction = mu)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
#[coordinate(theta = angle(CD), from = right)]
#[figure(C = (-(a - b), 0), D = (a + b, 0))]
struct Edge {
    m: f64,
    a: f64,
    b: f64,
    g: f64,
    mu: f64,
}

/// A rod tipping over a rough edge slips at tan θ = μ a² / (a² + 9 b²).
#[test]
fn a_rod_on_an_edge_slips_at_a_known_angle() {
    for (a, b, mu) in [(1.0, 0.3, 0.4), (2.0, 0.1, 0.7), (1.0, 0.5, 0.2)] {
        let edge = Edge { m: 2.0, a, b, g: 9.81, mu };
        let record = run(Simulation::new(&edge).unwrap().limit(5.0).tolerance(1e-12));
        let slip = record.events().iter().find(|event| event.kind == EventKind::Slip).expect("a slip");
        let expected = (mu * a * a / (a * a + 9.0 * b * b)).atan();
        assert!((slip["theta"].abs() - expected).abs() < 1e-9, "{slip} {expected}");
    }
}

/// Stick and slip by turns: it slips at k x = μₛ m g, sticks again where its velocity is that of
/// the belt.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    let belt = Belt { m: 1.0, g: 10.0, k: 4.0, mu: 0.2, mu_s: 0.5, w: 0.7 };
    let pose = Pose::new("x", 0.1).with("x'", 0.7);
    let record = run(Simulation::new(&belt).unwrap().start(pose).unwrap().limit(20.0).tolerance(1e-11));
    let events = record.events();
    let slips: Vec<&Event> = events.iter().filter(|event| event.kind == EventKind::Slip).collect();
    let sticks: Vec<&Event> = events.iter().filter(|event| event.kind == EventKind::Stick).collect();
    assert!(slips.len() > 3 && sticks.len() > 3, "{events:?}");
    assert!((slips[0].t - (1.25 - 0.1) / 0.7).abs() < 1e-9);
    // Sliding: x = x_m + A cos(ω t + φ) about x_m = μ m g / k.
    let (middle, omega) = (0.5_f64, 2.0_f64);
    let amplitude = ((1.25 - middle).powi(2) + (0.7 / omega).powi(2)).sqrt();
    for (slip, stick) in slips.iter().zip(&sticks) {
        assert!((slip["x"] - 1.25).abs() < 1e-9 && (slip["x'"] - 0.7).abs() < 1e-9, "{slip}");
        assert!((stick["x"] - (2.0 * middle - 1.25)).abs() < 1e-8, "{stick}");
        let turn = PI + 2.0 * (0.7 / omega / amplitude).asin();
        assert!((stick.t - slip.t - turn / omega).abs() < 1e-8, "{} {}", stick.t - slip.t, turn / omega);
    }
}

/// Friction that grows weaker with the slip velocity.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu / (1 + (v / s).powi(2)))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Weakening {
    m: f64,
    g: f64,
    mu: f64,
    s: f64,
}

/// From v₀ it takes (v₀ + v₀³/3s²)/μg to stop.
#[test]
fn friction_may_depend_on_the_slip_velocity() {
    let block = Weakening { m: 3.0, g: 9.81, mu: 0.3, s: 0.8 };
    let pose = Pose::new("x", 0.0).with("x'", -2.0);
    let record = run(Simulation::new(&block).unwrap().start(pose).unwrap().limit(10.0).tolerance(1e-11));
    let stick = record.events().iter().find(|event| event.kind == EventKind::Stick).expect("rest");
    let expected = (2.0 + 8.0 / (3.0 * 0.64)) / (0.3 * 9.81);
    assert!((stick.t - expected).abs() < 1e-9, "{stick} {expected}");
}

/// It does so at a loose tolerance too, where the place at which friction is located at its limit
/// and the state that is on the contact are apart by more than rounding.
#[test]
fn a_rod_on_an_edge_slips_at_every_tolerance() {
    for (m, a, b, mu) in [
        (1.184141574796735, 1.766208063882506, 0.4268165328783644, 0.22963297652102072),
        (1.3942412379678313, 1.329271836345074, 0.6106694476056916, 0.9274321072076587),
        (1.5127592367619407, 1.491928883058999, 1.1197900084608476, 2.7151586382235546),
    ] {
        let edge = Edge { m, a, b, g: 9.81, mu };
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let record = run(Simulation::new(&edge).unwrap().limit(0.5).tolerance(tolerance));
            let slip = record.events().iter().find(|event| event.kind == EventKind::Slip).expect("a slip");
            let expected = (mu * a * a / (a * a + 9.0 * b * b)).atan();
            assert!((slip["theta"].abs() - expected).abs() < tolerance, "{tolerance}: {slip} {expected}");
        }
    }
}

/// A block that falls on a fast belt is thrown along: P_t = μ P at the impact, which does work on
/// it. At k x = μₛ m g, carried on, it slips from the start: x = x_m + (x₀ − x_m) cos ω t + (w/ω)
/// sin ω t. At the other limit it sticks.
#[test]
fn a_block_that_starts_at_its_static_limit_slips_or_stays() {
    let belt = Belt { m: 1.0, g: 10.0, k: 4.0, mu: 0.2, mu_s: 0.5, w: 0.7 };
    for part in [-1e-14, -1e-16, 0.0, 1e-16, 1e-14] {
        for side in [1.0, -1.0] {
            let pose = Pose::new("x", side * 1.25 * (1.0 + part)).with("x'", 0.7);
            let record =
                run(Simulation::new(&belt).unwrap().start(pose).unwrap().limit(0.1).tolerance(1e-11));
            let x = match side > 0.0 {
                true => 0.5 + 0.75 * 0.2_f64.cos() + 0.35 * 0.2_f64.sin(),
                false => -1.25 + 0.07,
            };
            let found = record.final_state()[0];
            assert!((found - x).abs() < 1e-10, "{side} {part}: {found}, not {x}: {:?}", record.events());
        }
    }
}

#[test]
fn a_belt_does_work_at_an_impact() {
    let belt = Belt { m: 2.0, g: 10.0, k: 1e-9, mu: 0.5, mu_s: 0.5, w: 20.0 };
    let pose = Pose::new("x", 0.0).with("y", 0.1).with("x'", 0.0).with("y'", -3.0);
    let record = run(Simulation::new(&belt).unwrap().start(pose).unwrap().limit(0.2).tolerance(1e-10));
    let impact = &record.events()[1];
    assert_eq!(impact.kind, EventKind::Impact, "{impact}");
    let fall = 11.0_f64.sqrt();
    assert!((impact["x'"] - 0.5 * fall).abs() < 1e-9 && impact["y'"] == 0.0, "{impact}");
    assert!(record.audit().is_clean(), "{:?}", record.audit());
}

/// A rod with one end in a rough slot, pulled at by a spring.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[ground(O = (0, 0))]
#[spring(OB, stiffness = k)]
#[support(a = slot(alpha, (0, 0), w), under = A, friction = mu)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct Slotted {
    m: f64,
    l: f64,
    w: f64,
    g: f64,
    k: f64,
    alpha: f64,
    mu: f64,
}

/// After the end has turned back its slip is so slow that it lies within the tolerance until it
/// sticks: the run goes on, and comes to what a tight tolerance gives.
#[test]
fn a_slip_slower_than_the_tolerance_goes_on() {
    let (l, w, alpha) = (0.8128000759287005, 0.08128000759287006, -0.5_f64);
    let rod = Slotted { m: 1.4597626227738725, l, w, g: 9.81, k: 5.544747600083331, alpha, mu: 0.5 };
    let pose = Pose::new("x", -0.4 * w * alpha.sin()).with("y", 0.4 * w * alpha.cos()).with("theta", PI);
    let pose = pose.with("x'", 0.2109352412635388).with("y'", 0.0).with("theta'", 2.0);
    let at = |tolerance: f64| {
        let simulation = Simulation::new(&rod).unwrap().start(pose.clone()).unwrap();
        run(simulation.limit(0.4).tolerance(tolerance))
    };
    let told = |record: &Trajectory| {
        let events = record.events().iter().filter(|event| event.kind != EventKind::Touch);
        events.map(|event| event.kind).collect::<Vec<_>>()
    };
    let tight = at(1e-10);
    for tolerance in [1e-4, 1e-7] {
        let record = at(tolerance);
        assert_eq!(told(&record), told(&tight), "{tolerance}");
        for (one, other) in record.final_state().iter().zip(tight.final_state()) {
            assert!((one - other).abs() < 100.0 * tolerance, "{tolerance}: {one} {other}");
        }
    }
}

/// Held, a support would pull, and the friction of what pulls is none that the law of a support
/// knows: it has driven a ladder on.
#[test]
fn a_support_with_friction_is_not_held() {
    let belt = Belt { m: 2.0, g: 10.0, k: 1e-9, mu: 0.5, mu_s: 0.5, w: 20.0 };
    let held = Simulation::new(&belt).unwrap().hold("P").err().expect("it has friction");
    assert!(held.to_string().starts_with("support `P` has friction"), "{held}");
}

/// A bar between a rough floor and a rough wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), facing = right, friction = nu)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct LowLadder {
    m: f64,
    l: f64,
    mu: f64,
    nu: f64,
    g: f64,
}

/// φ̈ of a bar with m = l = 1 that slides at both ends, from Newton's equations about its centre:
/// with N = p + q φ̈ at the floor,
///
/// ```text
/// N_B − μ N = −½ (s φ̈ + c φ̇²)    N + ν N_B = g + ½ (c φ̈ − s φ̇²)    −φ̈/6 = N (c − μ s) − N_B (ν c + s)
/// ```
fn slide((mu, nu, g): (f64, f64, f64), phi: f64, rate: f64) -> f64 {
    let ((s, c), square) = (phi.sin_cos(), rate * rate);
    let p = (g - 0.5 * s * square + 0.5 * nu * c * square) / (1.0 + mu * nu);
    let q = 0.5 * (c + nu * s) / (1.0 + mu * nu);
    let (floor, wall) = (c - mu * s, nu * c + s);
    let known = p * floor - (mu * p - 0.5 * c * square) * wall;
    -known / (1.0 / 6.0 + q * floor - (mu * q - 0.5 * s) * wall)
}

/// Runge and Kutta's method for φ = φ₀ s, t = √φ₀ τ up to s = 0.
fn landing(coefficients: (f64, f64, f64), start: f64) -> f64 {
    let (h, mut tau, mut y) = (1e-4, 0.0, [1.0, 0.0]);
    let f = |y: [f64; 2]| [y[1], slide(coefficients, start * y[0], start.sqrt() * y[1])];
    let moved = |y: [f64; 2], by: f64, k: [f64; 2]| [y[0] + by * k[0], y[1] + by * k[1]];
    loop {
        let k = f(y);
        let l = f(moved(y, 0.5 * h, k));
        let m = f(moved(y, 0.5 * h, l));
        let n = f(moved(y, h, m));
        let next = [0, 1].map(|i| y[i] + h / 6.0 * (k[i] + 2.0 * l[i] + 2.0 * m[i] + n[i]));
        if next[0] <= 0.0 {
            // s = 0 of s + ṡ θ + ½ s̈ θ².
            let theta = 2.0 * y[0] / (-y[1] + (y[1] * y[1] - 2.0 * k[1] * y[0]).sqrt());
            return start.sqrt() * (tau + theta);
        }
        (tau, y) = (tau + h, next);
    }
}

/// A bar all but flat slides down: a floor that holds its end would hold it altogether, by rows
/// that differ by φ. Below 1e-12 the slip acceleration is within the roundoff of a decision, and
/// the run may say so.
#[test]
fn a_bar_all_but_flat_slides_from_its_rough_wall() {
    let bar = LowLadder { m: 1.0, l: 1.0, mu: 0.3, nu: 0.3, g: 9.81 };
    for k in 12..=52 {
        let start = 10f64.powf(-0.25 * f64::from(k));
        let simulation = Simulation::new(&bar).unwrap().start(Pose::new("phi", start)).unwrap();
        match simulation.until("phi = 0").unwrap().limit(1.0).run() {
            Ok(run) => {
                let expected = landing((bar.mu, bar.nu, bar.g), start);
                assert!((run.end_time() / expected - 1.0).abs() < 1e-8, "{start:e}: {}", run.end_time());
            }
            Err(error) => {
                assert!(start < 1e-12 && error.to_string().contains("depends on roundoff"), "{error}")
            }
        }
    }
}
