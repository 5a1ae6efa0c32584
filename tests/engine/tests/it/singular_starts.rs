//! Starts at positions where a closed contact does not hold the rates that are left open.

use core::f64::consts::{FRAC_PI_2, PI};

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff::{RunCause, StartError};
use liftoff_core::system::Model;
use liftoff_fixtures::AFrame;
use liftoff_fixtures::{RodOnSupports, TwoBalls, Zigzag};

/// Rates at the start and behind its impact, if it begins with one.
fn rates<M: BarSystem>(model: &M, pose: Pose, names: &[&str]) -> Vec<f64> {
    let run = Simulation::new(model).unwrap().start(pose).unwrap().limit(1e-3);
    let run = run.run().unwrap_or_else(|error| panic!("{error}"));
    let value = |name: &&str| run.value(&Output::parse(run.layout(), name).unwrap(), 0.0);
    names.iter().map(value).collect()
}

/// Upright, the rod's lower end keeps y′ from nothing: it takes off with the rates given, the
/// others zero.
#[test]
fn a_rod_on_its_end_takes_off() {
    let rod = RodOnSupports { m: 2.0, l: 3.0, g: 10.0 };
    for theta in [FRAC_PI_2, FRAC_PI_2 + 1e-12] {
        let pose = Pose::new("theta", theta).with("y'", 0.1);
        let found = rates(&rod, pose, &["theta'", "x'", "y'"]);
        // Least energy: θ and x have no inertia in common with y.
        assert_eq!(found, [0.0, 0.0, 0.1], "{theta}");
    }
}

/// Its feet below its apex, the frame's fall is stopped by an impact: J = (0, 1), so that nothing
/// of it is left.
#[test]
fn an_upright_frame_is_struck() {
    let frame = AFrame { m: 1.0, l: 1.0, g: 1.0 };
    let start = Pose::new("phi", FRAC_PI_2).with("h", 1.0).with("h'", -1.0);
    let run = Simulation::new(&frame).unwrap().start(start).unwrap().limit(0.01).run();
    let run = run.unwrap_or_else(|error| panic!("{error}"));
    let kinds: Vec<_> = run.events().iter().map(|event| event.kind).collect();
    assert_eq!(kinds[..2], [EventKind::Start, EventKind::Impact], "{kinds:?}");
    let phi = Output::parse(AFrame::LAYOUT, "phi'").unwrap();
    assert!(run.value(&phi, 0.0).abs() < 1e-12);
}

/// Off the singular position by more than poses are known, the constraint l cos φ φ′ = h′ gives the
/// rate.
#[test]
fn a_steep_frame_moves() {
    let frame = AFrame { m: 1.0, l: 1.0, g: 1.0 };
    let phi = FRAC_PI_2 - 1e-3;
    let found = rates(&frame, Pose::new("phi", phi).with("h'", -1e-3), &["phi'"]);
    // cos φ is good to 1e-16 of 1e-3.
    assert!((found[0] + 1e-3 / phi.cos()).abs() < 1e-11, "{found:?}");
}

/// Four bars in the shape of an M, the thread slack while they are upright.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[thread(BD, length = s)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
struct Folded {
    m1: f64,
    m2: f64,
    l: f64,
    s: f64,
    g: f64,
}

/// At φ = π/2 the gaps of A and C have one Jacobian, and from there on both hold all bars at one
/// angle: the motion has the energy
///
/// ```text
/// l² φ′² (m₁/3 + m₂ (1/12 + ¼ cos² φ + (9/4) sin² φ)) + (m₁ + m₂) g l sin φ,
/// ```
///
/// and C stays on the floor.
#[test]
fn bars_folded_upright_stay_together() {
    let [m1, m2, l, s, g] = [0.5, 0.7, 1.0, 0.6, 9.81];
    let energy = |phi: f64, rate: f64| {
        let moments = m1 / 3.0 + m2 * (1.0 / 12.0 + 0.25 * phi.cos().powi(2) + 2.25 * phi.sin().powi(2));
        (l * rate).powi(2) * moments + (m1 + m2) * g * l * phi.sin()
    };
    for (tolerance, start) in [(1e-6, -1.5), (1e-10, -1.5), (1e-8, 0.4)] {
        let pose = Pose::new("phi_inner", FRAC_PI_2).with("phi_outer", FRAC_PI_2);
        let pose = pose.with("phi_inner'", start).with("phi_outer'", start);
        let models: [Model; 2] = [(&Folded { m1, m2, l, s, g }).into(), (&Zigzag { m1, m2, l, g }).into()];
        for run in models.map(|model| Simulation::new(model).unwrap().tolerance(tolerance)) {
            let run = run.start(pose.clone()).unwrap().limit(0.15).run().unwrap();
            let kinds: Vec<_> = run.events().iter().map(|event| event.kind).collect();
            assert_eq!(kinds, [EventKind::Start, EventKind::End], "{tolerance:e}");
            let end = run.events().last().unwrap();
            assert_eq!(
                [end["phi_outer"], end["phi_outer'"]],
                [end["phi_inner"], end["phi_inner'"]],
                "{tolerance:e}"
            );
            assert_eq!([end["y"], end["y'"]], [0.0; 2], "{tolerance:e}");
            let drift = energy(end["phi_inner"], end["phi_inner'"]) / energy(FRAC_PI_2, start) - 1.0;
            // Ten steps of the tolerance.
            assert!(drift.abs() < 10.0 * tolerance, "{tolerance:e}: {drift:e}");
        }
    }
}

/// A ball on another one, above whose top it is put.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = circle((0, 0), r))]
#[figure(P = (3 * r / 5, 4 * r / 5))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Marble {
    m: f64,
    r: f64,
    g: f64,
}

/// At the top the gap (x² + y² − r²)/2r is flat along x, which its rounding leaves unknown by 1e-8:
/// the top is x = 0, where the ball stays. Beside it, as far as numbers tell y from r, x² = r² −
/// y².
#[test]
fn what_is_left_open_at_a_fold_is_on_the_fold() {
    let ball = Marble { m: 1.0, r: 2.0, g: 9.81 };
    let start = |y: f64| Simulation::new(&ball).unwrap().start(Pose::new("y", y)).unwrap();
    let top = start(2.0);
    assert!(top.start_state().unwrap()[0].abs() < 1e-15, "{:?}", top.start_state());
    assert_eq!(*top.run().unwrap_err().cause(), RunCause::Start(StartError::Equilibrium));
    for below in [1e-12_f64, 1e-10, 1e-4] {
        let y = 2.0 - below;
        let x = (4.0 - y * y).sqrt();
        let found = start(y).start_state().unwrap()[0];
        // Roundings of y² against x².
        assert!((found - x).abs() < 4.0 * f64::EPSILON * 4.0 / x, "{below:e}: {found} {x}");
    }
}

/// A ball that is put into the floor by less than the bound of its tolerance is lifted onto it:
/// that takes nothing of its given rate.
#[test]
fn a_start_below_the_floor_keeps_its_rates() {
    let balls = TwoBalls { m: 1.0, e: 0.0, g: 10.0, h: 1.0 };
    let start = Pose::new("y", -0.0005).with("x", 0.0).with("x'", 0.1).with("z", 1.0).with("w", 1.0);
    let run =
        Simulation::new(&balls).unwrap().tolerance(1e-4).start(start).unwrap().limit(0.1).run().unwrap();
    let end = run.events().last().unwrap();
    assert_eq!([end["y"], end["x'"]], [0.0, 0.1]);
}

/// Upright, with B and D at one place, the row of the slack thread is rounding over rounding. It
/// takes no part: the bars that turn faster pull their feet up, ÿ = l (φ̇² − ψ̇²).
#[test]
fn a_slack_thread_whose_points_meet_decides_nothing() {
    for ([inner, outer], bearing) in [([0.98, -2.7], vec!["C"]), ([2.7, -0.98], vec!["A", "E"])] {
        let run = Simulation::new(&Folded { m1: 0.5, m2: 0.5, l: 1.0, s: 0.6, g: 9.81 }).unwrap();
        let start = Pose::new("phi_inner", FRAC_PI_2).with("phi_inner'", inner).with("phi_outer'", outer);
        let run = run.start(start).unwrap().limit(0.05).run().unwrap();
        assert_eq!(run.segments()[0].closed, bearing);
        assert!(run.audit().is_clean(), "{}", run.audit());
    }
}

/// Nearly upright, and moved onto its feet, the frame has rates that keep them there: 170 rad/s
/// times the angle by which it has been moved are an impact otherwise.
#[test]
fn a_start_that_is_moved_onto_its_contacts_does_not_strike_them() {
    let zigzag = Simulation::new(&Zigzag { m1: 0.9, m2: 0.5, l: 1.0, g: 9.81 }).unwrap();
    let start = Pose::new("phi_inner", 1.56000001).with("phi_outer", 1.56).with("phi_outer'", -3.0);
    let run = zigzag.tolerance(1e-9).start(start.with("y'", 1.8)).unwrap();
    let state = run.start_state().unwrap();
    let value = |name: &str| state[run.layout().coordinates.iter().position(|c| c.name == name).unwrap()];
    let rate = |name: &str| {
        let place = run.layout().coordinates.iter().position(|c| c.name == name).unwrap();
        state[place + run.layout().coordinates.len()]
    };
    let side = |name: &str| value(name).cos() * rate(name);
    let gap = rate("y") + side("phi_inner") - side("phi_outer");
    assert!(gap.abs() < 1e-14 * rate("phi_inner").abs(), "{gap:e} of {state:?}");
}

/// Upright, the gaps of A, C and E have one Jacobian. With A and E to bear light legs fall apart
/// below a heavy middle and C sinks into the floor; with C to bear, nothing does.
#[test]
fn what_depends_on_others_upright_does_not_sink() {
    let upright = || Pose::new("phi_inner", FRAC_PI_2).with("phi_outer", 2.5 * PI);
    let [heavy, even] = [500.0, 0.5].map(|m1| Zigzag { m1, m2: 0.5, l: 1.0, g: 9.81 });
    let falling = (&heavy, upright().with("y", 1.0));
    let tilting = (&even, upright().with("phi_inner'", 0.0).with("phi_outer'", 1e-8));
    for (zigzag, start) in [falling, tilting] {
        for method in [MethodId::Gauss, MethodId::Tsit5, MethodId::Radau] {
            for tolerance in [1e-5, 1e-8, 1e-11] {
                let run = Simulation::new(zigzag).unwrap().method(method).tolerance(tolerance).limit(1.6);
                let run = run.start(start.clone()).unwrap().run().unwrap_or_else(|error| panic!("{error}"));
                let audit = run.audit();
                assert!(audit.is_clean(), "{} at {tolerance:e}: {audit}", method.name());
                let late = |event: &&Event| event.kind == EventKind::Impact && event.t > 0.5;
                assert!(run.events().iter().find(late).is_none(), "{} at {tolerance:e}", method.name());
            }
        }
    }
}

/// A bar that fits between its pin and a wall in one position alone.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[support(A = wall(l), facing = right)]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
struct Wedged {
    m: f64,
    l: f64,
    g: f64,
}

/// Its gap is −l (1 − cos φ): no reaction along it bears the weight, which is told or holds it.
#[test]
fn a_bar_without_room_ends_in_an_error_or_rests() {
    let wedged = Wedged { m: 1.0, l: 2.0, g: 10.0 };
    let start = Pose::new("phi", 0.0).with("phi'", 0.0);
    let run = Simulation::new(&wedged).unwrap().start(start).unwrap().limit(1.0).run();
    let trajectory = run.unwrap_or_else(|error| error.into_trajectory());
    assert!(trajectory.final_state()[0].abs() < 1e-3, "{:?}", trajectory.final_state());
}

/// A bar on a rough foot.
#[derive(BarSystem)]
#[gravity(10)]
#[bar(AB, mass = 2, length = 1)]
#[support(A = floor, rough)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(p = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.6, 0.8))]
struct OnRoughFoot;

/// A rough foot that is said to slip is stopped at once: m l²/3 p′ = −½ m l sin p x′ about it. None
/// is stopped that is pulled by what stops it.
#[test]
fn a_rough_foot_that_slips_is_struck() {
    let start = |slip: f64| {
        let pose = Pose::new("x", 0.0).with("y", 0.0).with("p", 1.0);
        Simulation::new(&OnRoughFoot).unwrap().start(pose.with("x'", slip).with("p'", 0.0)).unwrap()
    };
    let run = start(-0.2).limit(0.1).run().unwrap();
    let struck = &run.events()[1];
    assert_eq!((struck.t, struck.kind), (0.0, EventKind::Impact));
    let rate = run.value(&run.output("p'").unwrap(), 0.0);
    assert!((rate - 1.5 * 0.2 * f64::sin(1.0)).abs() < 1e-12, "{rate}");
    let refused = start(0.2).limit(0.1).run().unwrap_err();
    assert_eq!(refused.trajectory().end_time(), 0.0, "{refused}");
}
