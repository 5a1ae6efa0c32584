//! Linkages that flatten: bars of one length, so that the motion along the smooth branch is that of one crank.

use crate::RunCause;
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
    run.start(Pose::at("theta'", rate)).unwrap().limit(t).run().unwrap().final_state()
}

/// Ten passes in ten seconds from a speed of 1 m/s at the top; the smooth branch is a crank in 7/9 of the gravity.
#[test]
fn two_coupled_four_bars_keep_their_energy_through_every_pass() {
    for (l, m) in [(1.0, 1.0), (1e-6, 1e3)] {
        let (time, g) = (f64::sqrt(l), 9.81);
        let run = Simulation::new(&FourBars { m, l, g }).unwrap();
        let run = run.start(Pose::at("theta'", -1.0 / time)).unwrap().limit(10.0 * time).run().unwrap();
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
        let pose = Pose::at("theta", theta).with("theta'", rate);
        let run = run.start(pose).unwrap().limit(5.0).run().unwrap();
        let (lost, state) = (drift(&run), run.final_state());
        assert!(run.log().len() >= 5 && lost < 1e-8, "{theta} {rate} {lost:e}");
        assert!((state[0] - state[1]).abs() < 1e-12 && state[2].abs() < 1e-12, "{state:?}");
    }
}

/// With the pins a little farther apart than the coupler is long there is no singular position, but a sharp turn into the
/// crossed branch; the motion is not continued straight on.
#[test]
fn a_near_miss_is_no_singular_position() {
    for delta in [1e-3, 1e-5, 1e-7] {
        let run =
            Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6 + delta, g: 9.81 }).unwrap();
        let run = run.start(Pose::at("theta'", -1.0)).unwrap().limit(2.0).run().unwrap();
        let (lost, state) = (drift(&run), run.final_state());
        assert!(run.log().is_empty() && lost < 1e-9, "{delta:e} {lost:e}");
        assert!((state[0] - state[1]).abs() > 1.0, "{state:?}");
    }
}

/// On the singular position itself the branch is not determined, nor, to the digits of a start, close to it.
#[test]
fn a_start_without_a_branch_is_refused() {
    for theta in [0.0, 1e-5] {
        let run = Simulation::new(&Parallelogram { m: 1.0, l: 1.0, c: 1.6, d: 1.6, g: 9.81 }).unwrap();
        let run = run.start(Pose::at("theta", theta).with("theta'", -1.0)).unwrap();
        let error = run.limit(5.0).run().unwrap_err();
        let RunCause::Loop { joints, t: 0.0 } = error.cause() else { panic!("{error}") };
        assert!(!joints.is_empty());
    }
}

/// Loose tolerances come off the branch further.
#[test]
fn loose_tolerances_pass_too() {
    for tolerance in [1e-10, 1e-8, 1e-6, 1e-3] {
        let run = Simulation::new(&FourBars { m: 1.0, l: 1.0, g: 9.81 }).unwrap().tolerance(tolerance);
        let run = run.start(Pose::at("theta'", -1.0)).unwrap().limit(10.0).run().unwrap();
        let lost = drift(&run) / (3.5 * 9.81);
        assert_eq!(run.log().len(), 10);
        assert!(lost < 1e-7, "{tolerance:e} {lost:e}");
    }
}
