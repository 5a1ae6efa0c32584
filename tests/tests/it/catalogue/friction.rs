//! Dry friction: sticking, slipping, Painlevé's rod, and steps of a wheel without a rim.

use super::{CLOSE, evaluate_output, pose};
use crate::common::{kinds, prepared, run};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use core::f64::consts::{FRAC_PI_3, PI};
use liftoff::Note;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_core::model::Slip;
use liftoff_tests::catalogue::toppling_rod;
use liftoff_tests::numerics::{integral, root};

fn of_kind(run: &Trajectory, kind: EventKind) -> Vec<&Event> {
    run.events().iter().filter(|event| event.kind == kind).collect()
}

/// The rod of entry 16 as a thin plate whose first two points are close to each other, and a ball
/// that flies past.
#[derive(BarSystem)]
#[gravity(g)]
#[body(plate, points(A = (0, 0), B = (w, 0), C = (0, l)), mass = m, inertia = m * l * l / 12, centre = (0, l / 2))]
#[particle(Q, mass = m)]
#[support(A = floor, friction = mu)]
#[figure(A = (0, 0), B = (w, 0), Q = (l, l))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(psi = angle(plate), from = right)]
struct ThinPlate {
    m: f64,
    l: f64,
    w: f64,
    mu: f64,
    g: f64,
}

/// Where something that holds at one end of an interval comes to hold no more.
fn border(holds: impl Fn(f64) -> bool, [from, to]: [f64; 2]) -> f64 {
    root(|x| if holds(x) { 1.0 } else { -1.0 }, from, to).unwrap()
}

/// It slips at k x = μₛ m g and sticks again at k x = (2 μ − μₛ) m g, π/ω + (2/ω) atan k w/((μₛ −
/// μ) m g ω) later.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    let belt = Belt { m: 1.5, l: 1.0, k: 30.0, mu: 0.2, mu_s: 0.45, w: 0.3, g: 9.81 };
    let Belt { m, k, mu, mu_s, w, g, .. } = belt;
    let run = run(&belt, pose(&[("x", 0.0), ("x'", w)]), &["t = 10"]);
    let [slips, sticks] = [EventKind::Slip, EventKind::Stick].map(|kind| of_kind(&run, kind));
    assert!(slips.len() > 3 && sticks.len() > 3);
    let (omega, weight) = ((k / m).sqrt(), m * g);
    let slide = (PI + 2.0 * (k * w / ((mu_s - mu) * weight * omega)).atan()) / omega;
    for (slip, stick) in slips.iter().zip(&sticks) {
        assert_abs_diff_eq!(slip["x"], mu_s * weight / k, epsilon = CLOSE);
        assert_abs_diff_eq!(stick["x"], (2.0 * mu - mu_s) * weight / k, epsilon = CLOSE);
        assert_abs_diff_eq!(stick.t - slip.t, slide, epsilon = CLOSE);
        assert_abs_diff_eq!(slip.reactions[0].friction.unwrap(), mu * weight, epsilon = CLOSE);
        assert_abs_diff_eq!(
            evaluate_output(&run, "v(P)", 0.5 * (slip.t + stick.t)) + w,
            evaluate_output(&run, "x'", 0.5 * (slip.t + stick.t)),
            epsilon = CLOSE
        );
    }
    // A slide takes μ m g times its way along the belt, which the belt's work pays.
    let way = w * slide + 2.0 * (mu_s - mu) * weight / k;
    let lost = evaluate_output(&run, "D", sticks[0].t) - evaluate_output(&run, "D", slips[0].t);
    assert_abs_diff_eq!(lost, mu * weight * way, epsilon = CLOSE);
    let carried = |from: f64, to: f64| integral(|t| w * evaluate_output(&run, "R(P)", t), from, to);
    let work = carried(0.0, slips[0].t.next_down()) + carried(slips[0].t, sticks[0].t.next_down());
    let gained = evaluate_output(&run, "E + D", sticks[0].t) - evaluate_output(&run, "E + D", 0.0);
    assert_abs_diff_eq!(gained, work, epsilon = CLOSE);
    assert_abs_diff_eq!(
        evaluate_output(&run, "R(P)", 0.5 * slips[0].t),
        k * w * 0.5 * slips[0].t,
        epsilon = CLOSE
    );
    assert_eq!(evaluate_output(&run, "mu(P)", 0.5 * slips[0].t), mu_s);
}

/// On a belt at rest it is the oscillator of entry 18: each amplitude about ∓F/k is less by 2F/k,
/// and the rest comes after atan(6/13) + 7π at 15 − √205.
#[test]
fn the_friction_oscillator_comes_to_rest() {
    let oscillator = Belt { m: 1.0, l: 50.0, k: 1.0, mu: 0.1, mu_s: 0.1, w: 0.0, g: 10.0 };
    let run = run(&oscillator, pose(&[("x", 12.0), ("x'", 6.0)]), &["t = 30"]);
    assert_eq!(of_kind(&run, EventKind::Reverse).len(), 7);
    let [rest] = of_kind(&run, EventKind::Stick)[..] else { panic!("{:?}", kinds(&run)) };
    assert_abs_diff_eq!(rest["x"], 15.0 - 205.0_f64.sqrt(), epsilon = CLOSE);
    assert_abs_diff_eq!(rest.t, (6.0_f64 / 13.0).atan() + 7.0 * PI, epsilon = CLOSE);
}

/// How close the first two points of a body are to each other does not tell how large it is.
#[test]
fn a_thin_plate_slips_as_the_rod_does() {
    let plate = ThinPlate { m: 1.0, l: 1.0, w: 1e-6, mu: 0.5, g: 1.0 };
    let rate = toppling_rod::rate_squared(0.1).sqrt();
    let start = [
        ("psi", -0.1),
        ("psi'", -rate),
        ("x", 0.0),
        ("x'", 0.0),
        ("y", 0.0),
        ("x_Q", 1.0),
        ("y_Q", 1.0),
        ("x_Q'", 10.0),
    ];
    let run = run(&plate, pose(&start), &["psi = -1.2"]);
    let slip = of_kind(&run, EventKind::Slip)[0];
    assert_abs_diff_eq!(-slip["psi"], toppling_rod::slip_angle(0.5).unwrap(), epsilon = CLOSE);
}

/// Entry 16.
#[test]
fn a_toppling_rod_slips_at_known_angles() {
    for mu in [0.1, 0.2, 0.3, 0.35, 0.4, 0.5, 1.0, 10.0] {
        let rod = SlippingRod { m: 1.0, l: 1.0, mu, g: 1.0 };
        let rate = toppling_rod::rate_squared(0.1).sqrt();
        let run = run(&rod, pose(&[("phi", 0.1), ("phi'", rate), ("x'", 0.0)]), &["phi = pi/2"]);
        let slip = of_kind(&run, EventKind::Slip)[0];
        assert_abs_diff_eq!(slip["phi"], toppling_rod::slip_angle(mu).unwrap(), epsilon = CLOSE);
        let [normal, friction] = ["N(A)", "R(A)"].map(|force| evaluate_output(&run, force, 0.9 * slip.t));
        let phi = evaluate_output(&run, "phi", 0.9 * slip.t);
        assert_abs_diff_eq!(normal, toppling_rod::reaction(phi), epsilon = CLOSE);
        assert_abs_diff_eq!(friction, toppling_rod::friction(phi), epsilon = CLOSE);
    }
}

/// With both friction forces at their limits tan φ = (1 − μ ν)/2μ.
#[test]
fn a_ladder_stays_above_the_angle_of_its_friction() {
    for (mu, nu) in [(0.3, 0.3), (0.5, 0.2), (0.25, 0.8), (0.4, 0.0)] {
        let ladder = SlippingLadder { m: 2.0, l: 1.5, mu, nu, g: 9.81 };
        let slips = |phi: f64| {
            let start = prepared(&ladder, pose(&[("phi", phi)]), &["t = 0.01"]);
            start.run().unwrap().segments()[0].set.slip(0) != Slip::Stick
        };
        let least = ((1.0 - mu * nu) / (2.0 * mu)).atan();
        // What lacks less than some 1e-9 of its weight to stay is taken to stay.
        assert_abs_diff_eq!(border(slips, [0.3, 1.5]), least, epsilon = 1e-8);
    }
}

/// Whether it begins with an impact without collision; outside, the slip may end so on its way.
fn jams(run: &Trajectory) -> bool {
    run.events().iter().any(|event| event.t == 0.0 && event.note == Some(Note::WithoutCollision))
}

/// Entry 19: the paradox begins and ends at tan θ = (3 μ ± √(9 μ² − 16))/2, and there is none for μ
/// < 4/3.
#[test]
fn painleves_rod_is_in_paradox_between_known_angles() {
    let slid = |mu: f64, theta: f64| {
        let rod = Painleve { m: 1.3, l: 0.7, mu, e: 0.0, g: 9.81 };
        let start = pose(&[("theta", theta), ("x'", -2.0), ("theta'", 0.0)]);
        // Beside the border the reaction grows beyond what a run can follow; it has begun all the
        // same.
        prepared(&rod, start, &["t = 1e-6"]).run().unwrap_or_else(|error| error.into_trajectory())
    };
    for mu in [1.4_f64, 2.0] {
        let root = (9.0 * mu * mu - 16.0).sqrt();
        let [first, last] = [3.0 * mu - root, 3.0 * mu + root].map(|tangent| (0.5 * tangent).atan());
        // So near to the border the reaction, some 1e8 weights, counts as beyond all bounds.
        assert_abs_diff_eq!(border(|theta| !jams(&slid(mu, theta)), [0.2, 1.1]), first, epsilon = 1e-8);
        assert_abs_diff_eq!(border(|theta| jams(&slid(mu, theta)), [1.1, 1.5]), last, epsilon = 1e-8);
    }
    for mu in [0.5, 1.0, 1.3333] {
        assert!((1..30).all(|k| !jams(&slid(mu, 0.05 * f64::from(k)))), "{mu}");
    }
    let critical = border(|mu| !jams(&slid(mu, 2.0_f64.atan())), [1.0, 2.0]);
    assert_abs_diff_eq!(critical, 4.0 / 3.0, epsilon = 1e-8);
}

/// Entry 21, for a wheel with a moment of inertia: an impact leaves η = (j + m l² cos 2α)/(j + m
/// l²) of the rate; ω² before it tends to 4 m g l sin α sin γ/(j + m l²)(1 − η²), differences
/// shrinking by η².
#[test]
fn a_wheel_without_a_rim_tends_to_its_steady_rate() {
    let (m, l, gamma, g) = (1.2, 0.8, 0.2_f64, 9.81);
    let j = 0.1 * m * l * l;
    let wheel = RimlessWheel { m, j, l, gamma, mu: 1.5, g };
    let (phi, rate) = (-gamma, -1.5);
    let [across, up] = [rate * l * (phi - FRAC_PI_3).sin(), -rate * l * (phi - FRAC_PI_3).cos()];
    let start = pose(&[("phi", phi), ("phi'", rate), ("x'", across), ("y'", up)]);
    let run = run(&wheel, start, &["t = 9"]);
    let about = j + m * l * l;
    let eta = (j + 0.5 * m * l * l) / about;
    let steady = 4.0 * m * g * l * 0.5 * gamma.sin() / (about * (1.0 - eta * eta));
    let impacts = of_kind(&run, EventKind::Impact);
    assert!(impacts.len() > 8 && of_kind(&run, EventKind::Slip).is_empty(), "{:?}", kinds(&run));
    let after: Vec<f64> = impacts.iter().map(|impact| impact["phi'"]).collect();
    let before: Vec<f64> =
        impacts.iter().map(|impact| evaluate_output(&run, "phi'", impact.t.next_down())).collect();
    for (after, before) in after.iter().zip(&before) {
        assert_abs_diff_eq!(after / before, eta, epsilon = CLOSE);
    }
    for pair in before.windows(2) {
        let [one, next] = [pair[0], pair[1]].map(|rate| rate * rate - steady);
        assert_abs_diff_eq!(next, eta * eta * one, epsilon = CLOSE);
    }
    assert_relative_eq!(before.last().unwrap().powi(2), steady, max_relative = 1e-3);
}

/// The toy finds its rhythm: wedged below, the sleeve sticks, slips, falls free, and the beak
/// strikes once a turn. No closed form is known; its turns are equal, and the weight's work of one
/// is what friction and impacts take.
#[test]
fn a_woodpecker_pecks_in_equal_turns() {
    let spec = models().find("woodpecker").unwrap().default_run().limit(3.0);
    let spec = liftoff_studio::RunSpec { until: vec!["t = 3".into()], ..spec };
    let run = models().find("woodpecker").unwrap().run(&spec).unwrap();
    let pecks: Vec<&Event> =
        of_kind(&run, EventKind::Impact).into_iter().filter(|e| e.supports == ["K"]).collect();
    let turns: Vec<[f64; 2]> =
        pecks.windows(2).map(|pair| [pair[1].t - pair[0].t, pair[1]["y"] - pair[0]["y"]]).collect();
    let [last, before] = [turns.len() - 1, turns.len() - 2].map(|k| turns[k]);
    assert_relative_eq!(last[0], before[0], max_relative = 1e-6);
    assert_relative_eq!(last[1], before[1], max_relative = 1e-6);
    let [old, new] = [pecks[pecks.len() - 2].t, pecks[pecks.len() - 1].t];
    let lost = evaluate_output(&run, "D", new) - evaluate_output(&run, "D", old);
    assert_relative_eq!(lost, -(3e-4 + 4.5e-3) * 9.81 * last[1], max_relative = 1e-3);
    let since = pecks[pecks.len() - 2].t;
    let turn: Vec<(EventKind, Vec<&str>)> = run
        .events()
        .iter()
        .filter(|e| e.t > since && e.t <= since + last[0])
        .map(|e| (e.kind, e.supports.clone()))
        .collect();
    use EventKind::{Impact, Open, Slip, Stick};
    let expected =
        [(Impact, "U"), (Open, "U"), (Impact, "L"), (Stick, "L"), (Slip, "L"), (Open, "L"), (Impact, "K")];
    assert_eq!(turn, expected.map(|(kind, support)| (kind, vec![support])));
}
