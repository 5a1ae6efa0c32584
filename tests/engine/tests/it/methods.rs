//! The methods through a whole run: closed and projected phases, a lift-off, stiff springs.

use liftoff::LoggedDecision;
use liftoff::method::{Auto, Dop853, Gauss, Method, Radau, Taylor, Tsit5};
use liftoff::prelude::*;
use liftoff_fixtures::{HangingChain, PairOnCorners, SpringPendulum};

/// From φ = 0.1 at rest: lift-off and φ = π/2, by quadrature with 21 digits.
const OPENS: f64 = 0.829_361_847_228_260_4;
const ENDS: f64 = 1.244_461_483_164_527;

fn falls(method: impl Method, form: Form) {
    let (name, tolerance) = (method.name(), 1e-8);
    let pair = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    let simulation = Simulation::new(&pair).unwrap().method(method).tolerance(tolerance).form(form);
    let run = simulation.start(Pose::new("phi", 0.1)).unwrap().until("phi = pi/2").unwrap().run().unwrap();
    let opens = &run.events()[1];
    assert_eq!(opens.supports, ["P", "Q"]);
    let (first, last) = ((opens.t - OPENS).abs(), (run.events().last().unwrap().t - ENDS).abs());
    // Ten times the tolerance.
    assert!(first < 10.0 * tolerance && last < 10.0 * tolerance, "{name} {form:?}: {first:e}, {last:e}");
}

#[test]
fn each_method_finds_the_lift_off() {
    for form in [Form::Reduced, Form::Multipliers] {
        falls(Dop853, form);
        falls(Tsit5, form);
        falls(Gauss, form);
        falls(Radau, form);
    }
}

/// What integrates the pair's first phase.
fn find_method(method: impl Method, form: Form, tolerance: f64) -> &'static str {
    let pair = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    let simulation = Simulation::new(&pair).unwrap().method(method).tolerance(tolerance).form(form);
    let run = simulation.start(Pose::new("phi", 0.1)).unwrap().limit(0.1).run().unwrap();
    run.segments()[0].choice.method
}

#[test]
fn a_segment_tells_what_integrates_it() {
    assert_eq!(find_method(Taylor, Form::Reduced, 1e-8), "taylor");
    assert_eq!(find_method(Taylor, Form::Multipliers, 1e-8), "dop853");
    assert_eq!(find_method(Auto, Form::Reduced, 1e-8), "taylor");
    assert_eq!(find_method(Auto, Form::Multipliers, 1e-8), "dop853");
    assert_eq!(find_method(Auto, Form::Multipliers, 1e-4), "tsit5");
    assert_eq!(find_method(Gauss, Form::Multipliers, 1e-8), "gauss");
    let damped = SpringPendulum { m: 1.0, k: 1e6, l: 1.0, c: 2e3, g: 1.0 };
    let run = Simulation::new(&damped).unwrap().limit(1e-3).run().unwrap();
    assert_eq!(run.segments()[0].choice.method, "radau");
}

/// Where Auto leaves the series of a long chain for shorter work, its errors stay as small as
/// theirs: below the tolerance.
#[test]
fn long_series_are_left_without_loss_of_digits() {
    let chain = HangingChain { m: 0.7, l: 1.3, g: 9.81 };
    for k in 0..4 {
        let angle = |i: i32| 0.5 + (0.618 * f64::from(i + 7 * k)).fract();
        let first = Pose::new("phi_1", angle(1));
        let pose = (2..=7).fold(first, |pose, i| pose.with(format!("phi_{i}"), angle(i)));
        let swings = Simulation::new(&chain).unwrap().limit(2.0).start(pose).unwrap();
        let exact = swings.clone().method(Taylor).tolerance(1e-14).run().unwrap().final_state();
        for (tolerance, method) in
            [(1e-3, "dop853"), (1e-6, "dop853"), (1e-9, "dop853"), (1e-12, "taylor"), (1e-13, "taylor")]
        {
            let run = swings.clone().method(Auto).tolerance(tolerance).run().unwrap();
            let (choice, state) = (run.segments()[0].choice, run.final_state());
            assert_eq!(choice.method, method, "{}", choice.why);
            let size = exact.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let error = exact.iter().zip(&state).fold(0.0, |error: f64, (x, y)| error.max((x - y).abs()));
            assert!(error < tolerance.max(1e-12) * size, "{tolerance:e}: {error:e}");
        }
    }
}

/// One period of the rigid pendulum from 60°; the spring lengthens the period by some mg/kl.
#[test]
fn radau_passes_over_stiff_springs() {
    let start = 60f64.to_radians();
    let mean = (0..8).fold((1.0f64, (0.5 * start).cos()), |(a, b), _| (0.5 * (a + b), (a * b).sqrt())).0;
    for (k, damped) in [(1e6, true), (1e9, false), (1e12, true), (1e12, false)] {
        let c = if damped { 2.0 * f64::sqrt(k) } else { 0.0 };
        let model = SpringPendulum { m: 1.0, k, l: 1.0, c, g: 1.0 };
        let r = 1.0 + start.cos() / k;
        let pose = Pose::new("x", r * start.sin()).with("y", r * start.cos());
        let simulation = Simulation::new(&model).unwrap().method(Radau).tolerance(1e-6);
        let run = simulation.start(pose).unwrap().limit(core::f64::consts::TAU / mean).run().unwrap();
        let state = run.final_state();
        let error = (state[0].atan2(state[1]) - start).abs();
        assert!(error < 1e-5, "k = {k:e}: {error:e}");
        assert!(run.statistics().steps < 2500, "k = {k:e}: {:?}", run.statistics());
    }
}

/// From rest at 60°, the spring longer by this than on the slow manifold; k in mg/l, undamped.
fn swung(k: f64, longer: f64, method: impl Method, limit: f64) -> Trajectory {
    let start = 60f64.to_radians();
    let model = SpringPendulum { m: 1.0, k, l: 1.0, c: 0.0, g: 1.0 };
    let r = 1.0 + start.cos() / k + longer;
    let pose = Pose::new("x", r * start.sin()).with("y", r * start.cos());
    let simulation = Simulation::new(&model).unwrap().method(method).tolerance(1e-6);
    simulation.start(pose).unwrap().limit(limit).run().unwrap()
}

#[test]
fn auto_leaves_stiff_springs_that_hardly_oscillate_to_radau() {
    let start = 60f64.to_radians();
    let mean = (0..8).fold((1.0f64, (0.5 * start).cos()), |(a, b), _| (0.5 * (a + b), (a * b).sqrt())).0;
    for k in [1e8, 1e10, 1e12] {
        let run = swung(k, 0.0, Auto, core::f64::consts::TAU / mean);
        let state = run.final_state();
        let error = (state[0].atan2(state[1]) - start).abs();
        assert!(error < 1e-5, "k = {k:e}: {error:e}");
        assert!(run.statistics().steps < 2500, "k = {k:e}: {:?}", run.statistics());
        let changes = changes(&run);
        assert!(changes[0] == "radau" && changes.len() <= 3, "k = {k:e}: {:?}", run.log());
    }
}

/// What oscillates has to be resolved by any method: the explicit one takes less work. Along the
/// rod r″ = −k (r − r₀), up to g/k.
#[test]
fn auto_resolves_stiff_springs_that_oscillate() {
    let (k, longer, limit) = (1e8, 1e-3, 0.05);
    let [auto, taylor] = [swung(k, longer, Auto, limit), swung(k, longer, Taylor, limit)];
    let [steps, others] = [&auto, &taylor].map(|run| run.statistics().steps);
    assert!(steps < others + others / 4 + 200, "{steps}, {others}: {:?}", auto.log());
    let length = |run: &Trajectory| run.final_state()[0].hypot(run.final_state()[1]);
    let expected = 1.0 + longer * (k.sqrt() * limit).cos();
    for run in [&auto, &taylor] {
        assert!((length(run) - expected).abs() < 2e-5, "{} for {expected}", length(run));
    }
}

/// Two masses below each other, on a soft spring and a stiff one.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[particle(Q, mass = m)]
#[ground(O = (0, 0))]
#[slider(P = vertical(0))]
#[slider(Q = vertical(0))]
#[figure(P = (0, -l), Q = (0, -2 * l))]
#[spring(OP, stiffness = c, length = l)]
#[spring(PQ, stiffness = k, damping = d, length = l)]
#[coordinate(y = -y(P))]
#[coordinate(z = -y(Q))]
struct TwoMasses {
    m: f64,
    l: f64,
    g: f64,
    c: f64,
    k: f64,
    d: f64,
}

fn hung(k: f64, d: f64, [longer, limit]: [f64; 2], tolerance: f64) -> Trajectory {
    let model = TwoMasses { m: 1.0, l: 1.0, g: 1.0, c: 1.0, k, d };
    let pose = Pose::new("y", 3.5).with("z", 4.5 + longer);
    let simulation = Simulation::new(&model).unwrap().start(pose).unwrap();
    simulation.limit(limit).tolerance(tolerance).run().unwrap()
}

/// Radau is tried once: its steps are as short as explicit ones, and nothing damps the spring.
#[test]
fn auto_settles_on_one_method_for_an_undamped_spring() {
    for (k, limit) in [(1e6, 6.0), (1e8, 1.0), (1e12, 0.02)] {
        let run = hung(k, 0.0, [0.0, limit], 1e-12);
        let changes = changes(&run);
        assert!(changes.is_empty() || changes == ["radau", "taylor"], "k = {k:e}: {:?}", run.log());
    }
}

/// The stiff spring's speed, up to 2.5/√(2 k), is below the tolerance.
#[test]
fn auto_passes_over_an_oscillation_below_the_tolerance() {
    let run = hung(1e12, 0.0, [0.0, 1.0], 1e-4);
    assert_eq!(changes(&run), ["radau"], "{:?}", run.log());
    assert!(run.statistics().steps < 500, "{:?}", run.statistics());
}

/// −tr ∂f/∂y = 2 d/m, and the stiff spring's speed falls from 1e-3 √(2 k/m) by e^(−d t/m): below
/// the tolerance at t = 2.4.
#[test]
fn auto_tries_radau_again_once_damping_had_time() {
    let run = hung(1e10, 10.0, [1e-3, 20.0], 1e-8);
    assert_eq!(changes(&run), ["radau", "taylor", "radau"], "{:?}", run.log());
    assert!(run.log().last().is_some_and(|entry| (2.4..4.0).contains(&entry.t)), "{:?}", run.log());
}

/// A bar whose bearing seizes twice a turn of the time: c sin⁸(t + lead).
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[couple(OA = -c * sin(t + lead).powi(8) * rate(phi))]
#[torsion(OA, damping = d)]
#[liftoff(dimensionless)]
struct Seizing {
    m: f64,
    l: f64,
    c: f64,
    lead: f64,
    d: f64,
    g: f64,
}

fn seized(model: &Seizing, method: impl Method) -> Trajectory {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-7).method(method);
    simulation.start(Pose::new("phi", 1.0)).unwrap().limit(6.8).run().unwrap()
}

/// To which methods a run has changed.
fn changes(run: &Trajectory) -> Vec<&'static str> {
    let method = |entry: &liftoff::LogEntry| match &entry.decision {
        LoggedDecision::Method(choice) => Some(choice.method),
        _ => None,
    };
    run.log().iter().filter_map(method).collect()
}

/// One phase, of which no step is lost or made twice where the method changes: the state a little
/// before and a little behind is one.
fn goes_through(run: &Trajectory) {
    assert_eq!(run.segments().len(), 1);
    assert_eq!(run.times().len() as u64, run.statistics().steps + 1);
    for entry in run.log().iter().filter(|entry| matches!(entry.decision, LoggedDecision::Method(_))) {
        assert!(run.times().contains(&entry.t), "{entry:?}");
        let [before, behind] = [-1e-12, 1e-12].map(|dt| run.state(entry.t + dt));
        for (a, b) in before.iter().zip(&behind) {
            assert!((a - b).abs() < 1e-6 * a.abs().max(1.0), "{entry:?}: {before:?} {behind:?}");
        }
    }
}

#[test]
fn auto_leaves_the_implicit_method_that_it_began_with() {
    let model = Seizing { m: 1.0, l: 1.0, c: 1e5, lead: core::f64::consts::FRAC_PI_2, d: 1e-3, g: 9.81 };
    let [auto, implicit, explicit] = [seized(&model, Auto), seized(&model, Radau), seized(&model, Dop853)];
    assert_eq!(auto.segments()[0].choice.method, "radau");
    assert_eq!(changes(&auto), ["taylor", "radau", "taylor", "radau"], "{:?}", auto.log());
    goes_through(&auto);
    let [steps, implicit, others] = [&auto, &implicit, &explicit].map(|run| run.statistics().steps);
    assert!(3 * steps < 2 * implicit && 20 * steps < others, "{steps}, {implicit}, {others}");
    for (a, b) in auto.final_state().iter().zip(explicit.final_state()) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
}

/// Van der Pol's oscillator: negative damping in the middle, stiff outside.
#[derive(BarSystem)]
#[particle(P, mass = 1)]
#[slider(P = horizontal(0))]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[force(P = (((1 - x * x) * vx(P) - x) / eps, 0))]
#[liftoff(dimensionless)]
struct VanDerPol {
    eps: f64,
}

/// Problem `vdpol` of the Test Set for IVP Solvers (Mazzia & Magherini, release 2.4), ε = 1e-6:
/// crawls by the implicit method, jumps by the explicit one.
#[test]
fn auto_changes_its_method_at_each_jump_of_a_relaxation_oscillation() {
    let model = VanDerPol { eps: 1e-6 };
    let simulation = Simulation::new(&model).unwrap().tolerance(1e-9);
    let run = simulation.start(Pose::new("x", 2.0).with("x'", 0.0)).unwrap().limit(2.0).run().unwrap();
    let changes = changes(&run);
    // x = ±2 to ±1 three times.
    assert!(changes.len() >= 5 && changes.chunks(2).all(|pair| pair[0] == "radau"), "{changes:?}");
    goes_through(&run);
    let (end, published) = (run.final_state(), [1.706_167_732_170_483, -0.892_809_701_024_797_5]);
    for (found, published) in [end[0], end[2]].iter().zip(published) {
        assert!((found - published).abs() < 1e-6, "{found} {published}");
    }
}

#[test]
fn auto_changes_its_method_as_damping_comes_and_goes() {
    let model = Seizing { m: 1.0, l: 1.0, c: 1e5, lead: 0.0, d: 0.0, g: 9.81 };
    let (auto, explicit) = (seized(&model, Auto), seized(&model, Dop853));
    assert_eq!(auto.segments()[0].choice.method, "taylor");
    assert_eq!(changes(&auto), ["radau", "taylor", "radau", "taylor"], "{:?}", auto.log());
    goes_through(&auto);
    let [steps, others] = [&auto, &explicit].map(|run| run.statistics().steps);
    assert!(20 * steps < others, "{steps}, {others}");
    for (a, b) in auto.final_state().iter().zip(explicit.final_state()) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
}
