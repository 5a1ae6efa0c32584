//! Whole runs against closed forms: the catalogue, conservation of energy, mirrored against full.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::{FRAC_PI_2, PI};
use liftoff::prelude::*;
use liftoff::{Output, Trajectory};
use liftoff_models::*;
use liftoff_tests::catalogue::{
    a_frame, double_pendulum, hinged_bar, ladder, rod_on_floor, vanishing_support,
};

/// Runs are made at 1e-13; over some ten units of time errors grow to a hundred times that.
const RUN: f64 = 1e-11;

fn run<M: BarSystem>(model: &M, start: Pose, until: &[&str]) -> Trajectory<M> {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-13).start(start).unwrap();
    let simulation = until.iter().fold(simulation, |s, condition| s.until(condition).unwrap());
    simulation.run().unwrap()
}

/// Up to the first impact.
fn fall<M: BarSystem>(model: &M, start: Pose) -> Trajectory<M> {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-13).start(start).unwrap();
    simulation.stop_at_impacts().run().unwrap()
}

fn at<M: BarSystem>(run: &Trajectory<M>, output: &str, t: f64) -> f64 {
    run.value(&Output::parse::<M>(output).unwrap(), t)
}

fn kinds<M: BarSystem>(run: &Trajectory<M>) -> Vec<(EventKind, Vec<&'static str>)> {
    run.events().iter().map(|e| (e.kind, e.supports.clone())).collect()
}

#[test]
fn ladder_leaves_the_wall() {
    let start = 75.0_f64.to_radians();
    let run = run(&Ladder { m: 1.0, l: 1.0, g: 1.0 }, Pose::at("phi", start), &["phi = 0"]);
    assert_eq!(
        kinds(&run),
        [(EventKind::Start, vec![]), (EventKind::Open, vec!["B"]), (EventKind::Stop, vec![])]
    );
    let open = &run.events()[1];
    let theta = ladder::leaving_angle(start);
    assert_abs_diff_eq!(open.state[0], theta, epsilon = RUN);
    assert_abs_diff_eq!(open.t, ladder::time(start, theta), epsilon = RUN);
    let (floor, drift) = (at(&run, "N(A)", open.t), at(&run, "vx(B)", open.t));
    assert_abs_diff_eq!(floor, 0.25, epsilon = RUN);
    assert!(drift.abs() < RUN, "B still touches the wall: {drift}");
    assert_abs_diff_eq!(run.end_time() - open.t, ladder::free_time(start, 0.0), epsilon = RUN);
    let omega = *run.final_state().get(3).unwrap();
    assert_abs_diff_eq!(omega, -ladder::free_rate_squared(start, 0.0).sqrt(), epsilon = RUN);
    for theta in [0.6, 0.3] {
        let t = open.t + ladder::free_time(start, theta);
        assert_abs_diff_eq!(
            at(&run, "N(A)", t),
            ladder::free_floor_reaction(start, theta),
            epsilon = 10.0 * RUN
        );
    }
}

#[test]
fn rod_topples_without_lifting() {
    let start = 0.01;
    let run =
        run(&RodOnFloor { m: 1.0, l: 1.0, g: 1.0 }, Pose::at("phi", start).with("x", 0.0), &["phi = pi/2"]);
    assert_eq!(kinds(&run), [(EventKind::Start, vec![]), (EventKind::Stop, vec![])]);
    assert_abs_diff_eq!(run.end_time(), rod_on_floor::time(start, FRAC_PI_2), epsilon = 10.0 * RUN);
    let rate = at(&run, "phi'", run.end_time());
    assert_relative_eq!(rate * rate, rod_on_floor::rate_squared(start, FRAC_PI_2), max_relative = RUN);
    let least = run.extrema(&Output::parse::<RodOnFloor>("N(A)").unwrap());
    let least = least.iter().filter(|e| e.minimum).map(|e| e.value).fold(f64::INFINITY, f64::min);
    assert!(least > 0.165 && least < 0.166, "{least}");
}

#[test]
fn a_frame_reaches_the_floor() {
    let start = 80.0_f64.to_radians();
    let run = run(&AFrame { m: 1.0, l: 1.0, g: 1.0 }, Pose::at("phi", start), &["phi = 0"]);
    assert_abs_diff_eq!(run.end_time(), a_frame::time(start, 0.0), epsilon = RUN);
    assert_abs_diff_eq!(at(&run, "y'", run.end_time()).abs(), a_frame::landing_speed(start), epsilon = RUN);
    let least = run.extrema(&Output::parse::<AFrame>("N(A)").unwrap());
    let least = least.iter().find(|e| e.minimum).unwrap();
    assert_abs_diff_eq!(least.value, a_frame::least_reaction(start), epsilon = RUN);
    assert_abs_diff_eq!(at(&run, "sin(phi)", least.t), start.sin() / 3.0, epsilon = 1e-8);
}

#[test]
fn pendulum_has_its_period() {
    let run = run(&Pendulum { m: 1.0, l: 1.0, g: 1.0 }, Pose::at("phi", FRAC_PI_2), &["phi = 0"]);
    assert_abs_diff_eq!(4.0 * run.end_time(), hinged_bar::period(FRAC_PI_2), epsilon = RUN);
}

/// A hinged bar with its centre named (catalogue 5).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[point(G = OA, at = l / 2)]
#[coordinate(theta = angle(OA), from = right)]
struct Hinged {
    m: f64,
    l: f64,
    g: f64,
}

/// The hinge bears what the centre's acceleration leaves of the weight.
#[test]
fn released_level_the_hinge_force_follows() {
    let run = run(&Hinged { m: 1.0, l: 1.0, g: 1.0 }, Pose::at("theta", 0.0), &["theta = -pi/2"]);
    for part in 1..=8 {
        let t = run.end_time() * f64::from(part) / 8.0;
        let below = -at(&run, "theta", t);
        let (sin, cos) = below.sin_cos();
        let force = [at(&run, "ax(G)", t), at(&run, "ay(G)", t) + 1.0];
        let along = -(force[0] * cos - force[1] * sin);
        let across = force[0] * sin + force[1] * cos;
        assert_abs_diff_eq!(along, hinged_bar::force_along(below), epsilon = RUN);
        assert_abs_diff_eq!(across, hinged_bar::force_across(below), epsilon = RUN);
    }
}

/// The table has eight digits.
#[test]
fn double_pendulum_follows_the_table() {
    let model = DoublePendulum { m: 0.5, l: 0.5, g: 1.0 };
    let run = run(&model, Pose::at("phi_1", 0.0).with("phi_2", PI - 0.1), &["t = 10"]);
    for (t, expected) in double_pendulum::TABLE {
        for (value, expected) in run.state(t).iter().zip(expected) {
            assert_abs_diff_eq!(*value, expected, epsilon = 6e-9);
        }
    }
}

/// A level bar on two points; one vanishes (catalogue 4).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(P = AB, at = l / 2 - d)]
#[point(Q = AB, at = l / 2 + d)]
#[support(P = floor)]
#[support(Q = floor)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
struct Shelf {
    m: f64,
    l: f64,
    d: f64,
    g: f64,
}

#[test]
fn a_support_vanishes() {
    for d in [0.5, 0.3, 0.1] {
        let model = Shelf { m: 1.0, l: 1.0, d, g: 1.0 };
        let start = || Simulation::new(&model).unwrap().start(Pose::at("theta_AB", 0.0)).unwrap();
        let error = start().run().unwrap_err();
        let cause = error.cause().to_string();
        assert!(cause.contains("equilibrium"), "{cause}");
        let run = start().release("Q", 0.5).unwrap().until("t = 0.6").unwrap().run().unwrap();
        let release = &run.events()[1];
        assert_eq!((release.kind, &release.supports[..], release.t), (EventKind::Release, &["Q"][..], 0.5));
        assert_abs_diff_eq!(at(&run, "N(P)", 0.25), 0.5, epsilon = 1e-14);
        assert_abs_diff_eq!(at(&run, "N(P)", 0.5), vanishing_support::reaction(d, 1.0), epsilon = 1e-14);
    }
}

/// At tolerance 1e-13 the energy of a smooth phase drifts by less than 1e-12 of its scale.
#[test]
fn energy_is_kept_in_smooth_phases() {
    fn drift<M: BarSystem>(run: &Trajectory<M>) -> f64 {
        let energy = Output::parse::<M>("E").unwrap();
        let potential = Output::parse::<M>("V").unwrap();
        let first = run.value(&energy, run.start_time());
        let times = run.times();
        let scale = times.iter().map(|&t| run.value(&potential, t).abs()).fold(0.0, f64::max);
        times.iter().map(|&t| (run.value(&energy, t) - first).abs()).fold(0.0, f64::max) / scale
    }
    let g = 9.81;
    let pair = FallingPair { m: 1.0, l: 1.0, g };
    assert!(drift(&run(&pair, Pose::at("phi", 0.1), &["phi = pi/2"])) < 1e-12);
    let chain = DoublePendulum { m: 1.0, l: 1.0, g };
    assert!(drift(&run(&chain, Pose::at("phi_1", 2.0).with("phi_2", 1.0), &["t = 2"])) < 1e-12);
    let zigzag = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g };
    assert!(drift(&fall(&zigzag, Pose::at("phi_inner", 1.5).with("phi_outer", 1.5))) < 1e-12);
}

/// The mirrored model is a substitution into the full one: the same events at the same states.
#[test]
fn mirrored_and_full_agree() {
    let (m1, m2, l, g) = (0.5, 0.5, 1.0, 9.81);
    let half = fall(&Zigzag { m1, m2, l, g }, Pose::at("phi_inner", 1.5).with("phi_outer", 1.5));
    let pose =
        ["phi_ab", "phi_bc", "phi_cd", "phi_de"].iter().fold(Pose::at("x", 0.0), |p, name| p.with(name, 1.5));
    let full = fall(&ZigzagFull { m1, m2, l, g }, pose);
    assert_eq!(kinds(&half), kinds(&full));
    for (a, b) in half.events().iter().zip(full.events()) {
        // 1.5 rad is near an unstable equilibrium: errors grow by some e^7 until the feet leave.
        assert_abs_diff_eq!(a.t, b.t, epsilon = 1e-10);
        assert_abs_diff_eq!(a.state[0], b.state[2], epsilon = 1e-10);
        assert_abs_diff_eq!(a.state[1], b.state[3], epsilon = 1e-10);
    }
}

/// Far below, a corner's gap is rounding of a large drop at each half turn: the search for its closing must go on.
#[test]
fn a_long_flight_ends() {
    let run = run(&FallingPair { m: 1.0, l: 1.0, g: 9.81 }, Pose::at("phi", 0.01), &["t = 60"]);
    assert_eq!(kinds(&run).last(), Some(&(EventKind::Stop, vec![])));
    assert_eq!(run.end_time(), 60.0);
}

/// Three feet leave a four-bar chain three degrees of freedom, which no energy level settles.
#[test]
fn an_energy_level_needs_one_degree_of_freedom() {
    let model = ZigzagFull { m1: 0.5, m2: 0.5, l: 1.0, g: 1.0 };
    let start = Simulation::new(&model).unwrap().start(Pose::at("phi_ab", 1.5)).unwrap();
    let error = start.on_energy_of(Pose::at("phi_ab", 1.57)).err().unwrap();
    assert!(matches!(error, liftoff::StartError::Degrees { degrees: 3 }), "{error}");
}
