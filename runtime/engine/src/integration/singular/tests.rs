//! Linkages that flatten: bars of one length, so that the motion along the smooth branch is that of
//! one crank.

use crate::RunCause;
use crate::integration::method::MethodId;
use crate::prelude::*;

/// The smooth branch keeps the coupler level: T = (2/6 + 1/2) m l² θ̇², V = 2 m g l sin θ.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = c)]
#[bar(CB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(C = (d, 0))]
#[figure(A = (0, l), B = (d, l))]
#[coordinate(theta = angle(OA), from = right)]
#[coordinate(psi = angle(CB), from = right)]
#[coordinate(chi = angle(AB), from = right)]
struct Parallelogram {
    m: f64,
    l: f64,
    c: f64,
    d: f64,
    g: f64,
}

/// Two rhombi side by side: T = 3/2 m l² θ̇², V = 7/2 m g l sin θ (IFToMM benchmark A02, N = 2).
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[bar(PB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[bar(QC, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(P = (l, 0))]
#[pin(Q = (2 * l, 0))]
#[figure(A = (0, l), B = (l, l), C = (2 * l, l))]
#[coordinate(theta = angle(OA), from = right)]
#[coordinate(beta = angle(PB), from = right)]
#[coordinate(gamma = angle(QC), from = right)]
struct FourBars {
    m: f64,
    l: f64,
    g: f64,
}

/// A bar about O: θ̈ = −(3/2) (g/l) cos θ.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, l))]
#[coordinate(theta = angle(OA), from = right)]
struct Crank {
    m: f64,
    l: f64,
    g: f64,
}

/// The largest change of the energy, between the steps too.
fn drift(run: &Trajectory) -> f64 {
    let energy = Output::parse(run.layout(), "E").unwrap();
    let at = |t: f64| run.value(&energy, t) - run.value(&energy, 0.0);
    let between = run.times().windows(2).map(|t| 0.5 * (t[0] + t[1])).collect::<Vec<_>>();
    run.times().into_iter().chain(between).map(|t| at(t).abs()).fold(0.0, f64::max)
}

fn crank(g: f64, l: f64, rate: f64, t: f64) -> Vec<f64> {
    let run = Simulation::new(&Crank { m: 1.0, l, g }).unwrap().tolerance(1e-13);
    run.start(Pose::new("theta'", rate)).unwrap().limit(t).run().unwrap().final_state()
}

/// Ten passes in ten seconds from a speed of 1 m/s at the top; the smooth branch is a crank in 7/9
/// of the gravity.
#[test]
fn two_coupled_four_bars_keep_their_energy_through_every_pass() {
    for (l, m) in [(1.0, 1.0), (1e-6, 1e3)] {
        let (time, g) = (f64::sqrt(l), 9.81);
        let run = Simulation::new(&FourBars { m, l, g }).unwrap();
        let run = run.start(Pose::new("theta'", -1.0 / time)).unwrap().limit(10.0 * time).run().unwrap();
        let lost = drift(&run) / (3.5 * m * g * l);
        assert!(lost < 1e-9, "{lost:e}");
        assert_eq!(run.log().len(), 10);
        let expected = crank(7.0 / 9.0 * g, l, -1.0 / time, 10.0 * time);
        let state = run.final_state();
        assert!((state[0] - expected[0]).abs() < 1e-9, "{state:?} {expected:?}");
        assert!(((state[5] - expected[1]) * time).abs() < 1e-8, "{state:?} {expected:?}");
    }
}

/// θ̈ = −(2/(5/3)) (g/l) cos θ.
#[test]
fn a_parallelogram_flattens_and_goes_on_from_near_and_far() {
    for (theta, rate) in [(1.5, -1.0), (0.1, -1.0), (1e-2, -1.0), (1e-3, -1.0), (0.1, -0.1), (1e-3, 1.0)] {
        let run = Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6, g: 9.81 }).unwrap();
        let pose = Pose::new("theta", theta).with("theta'", rate);
        let run = run.start(pose).unwrap().limit(5.0).run().unwrap();
        let (lost, state) = (drift(&run), run.final_state());
        assert!(run.log().len() >= 5 && lost < 1e-8, "{theta} {rate} {lost:e}");
        assert!((state[0] - state[1]).abs() < 1e-12 && state[2].abs() < 1e-12, "{state:?}");
    }
}

/// With the pins a little farther apart than the coupler is long there is no singular position, but
/// a sharp turn into the crossed branch; the motion is not continued straight on.
#[test]
fn a_near_miss_is_no_singular_position() {
    for delta in [1e-3, 1e-5, 1e-7] {
        let run =
            Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6 + delta, g: 9.81 }).unwrap();
        let run = run.start(Pose::new("theta'", -1.0)).unwrap().limit(2.0).run().unwrap();
        let (lost, state) = (drift(&run), run.final_state());
        // As a turn of radius √δ is sharp, a step there loses more.
        assert!(run.log().is_empty() && lost < 1e-9 * 9.81, "{delta:e} {lost:e}");
        assert!((state[0] - state[1]).abs() > 1.0, "{state:?}");
    }
}

/// At rest in a singular position the branch is not determined, nor by rates that satisfy none to
/// second order.
#[test]
fn a_start_without_a_branch_is_refused() {
    for rate in [0.0, -1.0] {
        let run = Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6, g: 9.81 }).unwrap();
        let run = run.start(Pose::new("theta", 0.0).with("theta'", rate)).unwrap();
        let error = run.limit(5.0).run().unwrap_err();
        let RunCause::Loop { joints, t: 0.0 } = error.cause() else { panic!("{error}") };
        assert!(!joints.is_empty());
    }
}

/// A number in 0..1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// One of the linkages with all cranks at an angle and a rate.
fn level(four: bool, theta: f64, rate: f64) -> Simulation {
    let names: &[&str] = if four { &["theta", "beta", "gamma"] } else { &["theta", "psi"] };
    let given = |pose: Pose, name: &&str| pose.with(*name, theta).with(format!("{name}'"), rate);
    let pose = names.iter().fold(Pose::nominal(), given);
    let run = if four {
        Simulation::new(&FourBars { m: 1.0, l: 1.0, g: 9.81 })
    } else {
        Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6, g: 9.81 })
    };
    run.unwrap().start(pose).unwrap()
}

/// Speeds from 0.1 to 100, positions anywhere and near the singular ones, all methods, tolerances
/// from 1e-4 to 1e-14. Near singular positions loops are integrated at 1e-10 at the loosest, before
/// that as was asked: each of some hundred steps loses no more, relative to the kinetic energy or
/// the weight. Where a slow motion begins so near a singular position that rounding hides its
/// branch, the run says so.
#[test]
fn random_runs_keep_their_energy_or_say_why_not() {
    let (mut seed, mut refused, runs) = (1, 0, 100);
    for k in 0..runs {
        let near = [0.0, core::f64::consts::PI, 6.0 * random(&mut seed) - 3.0][k % 3];
        let theta = near + 10.0_f64.powf(-6.0 * random(&mut seed));
        let rate = (random(&mut seed) - 0.5).signum() * 10.0_f64.powf(3.0 * random(&mut seed) - 1.0);
        let tolerance = 10.0_f64.powf(-4.0 - 10.0 * random(&mut seed));
        let method = MethodId::ALL[(6.0 * random(&mut seed)) as usize];
        let run = level(k % 2 == 0, theta, rate).method(method).tolerance(tolerance);
        let run = run.limit((20.0 / rate.abs()).min(5.0)).run().unwrap_or_else(|error| {
            assert!(matches!(error.cause(), RunCause::Loop { .. }), "{error}");
            refused += 1;
            error.into_trajectory()
        });
        if run.segments().is_empty() {
            continue;
        }
        let kinetic = run.value(&Output::parse(run.layout(), "T").unwrap(), 0.0);
        let lost = drift(&run) / kinetic.max(7.0 * 9.81);
        assert!(
            lost < 100.0 * tolerance.max(1e-10),
            "{} at {tolerance:e} from {theta} at {rate}: {lost:e}",
            method.name()
        );
    }
    assert!(refused <= runs / 20, "{refused}");
}

/// In a singular position rates determine the branch that they satisfy to second order; here the
/// level one.
#[test]
fn a_start_in_a_singular_position_follows_its_rates() {
    for (four, theta) in [(false, 0.0), (true, 0.0), (false, core::f64::consts::PI)] {
        let run = level(four, theta, -1.0).limit(2.0).run().unwrap();
        assert!(drift(&run) < 1e-9, "{:e}", drift(&run));
        let state = run.final_state();
        assert!((state[0] - state[1]).abs() < 1e-9, "{state:?}");
    }
}

/// Loose tolerances come off the branch further.
#[test]
fn loose_tolerances_pass_too() {
    for tolerance in [1e-10, 1e-8, 1e-6, 1e-3] {
        let run = Simulation::new(&FourBars { m: 1.0, l: 1.0, g: 9.81 }).unwrap().tolerance(tolerance);
        let run = run.start(Pose::new("theta'", -1.0)).unwrap().limit(10.0).run().unwrap();
        let lost = drift(&run) / (3.5 * 9.81);
        assert_eq!(run.log().len(), 10);
        assert!(lost < 1e-7, "{tolerance:e} {lost:e}");
    }
}
