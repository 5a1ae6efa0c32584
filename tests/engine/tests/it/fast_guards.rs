//! Guards that turn often within one step, or in a small part of it.

use liftoff::method::{Dop853, Gauss, Method, MethodId, Radau, Taylor, Tsit5};
use liftoff::prelude::*;
use liftoff::{LogEntry, LoggedDecision};
use liftoff_fixtures::DoublePendulum;
use liftoff_fixtures::RodOnSupports;

/// When a condition ends a run of the pendulum from a = 1 at rest, and a then. a falls from 1
/// through zero.
fn end(condition: &str) -> [f64; 2] {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    let start = Pose::new("a", 1.0).with("b", 1.0);
    let run = Simulation::new(&model).unwrap().start(start).unwrap().limit(3.0);
    let run = run.until(condition).unwrap().run().unwrap();
    let a = Output::parse(DoublePendulum::LAYOUT, "a").unwrap();
    [run.end_time(), run.value(&a, run.end_time())]
}

/// The bound of a condition is 1e-12 of its sides (the default tolerance), the time of a root that
/// over its rate.
#[test]
fn the_first_of_many_roots() {
    for omega in [300.0, 1000.0, 1e5] {
        let [t, _] = end(&format!("sin({omega}*t)=0.5"));
        assert!((t - 0.5f64.asin() / omega).abs() < 1e-11 / omega, "{omega}: {t}");
    }
}

#[test]
fn a_part_of_a_step_in_which_a_condition_holds() {
    for (omega, height) in [(300.0, 0.99), (1000.0, 0.99999)] {
        let [t, _] = end(&format!("sin({omega}*t)>{height}"));
        // The rate is ω cos: 4.5e-3 ω at the lesser.
        assert!((t - f64::asin(height) / omega).abs() < 1e-9 / omega, "{omega}: {t}");
    }
}

/// An exponential that is 0 to all digits where the step begins.
#[test]
fn an_exponential_that_begins_at_zero() {
    for steep in [1e2, 1e3, 1e4, 1e6] {
        let [t, _] = end(&format!("exp({steep}*(t-1))>0.5"));
        assert!((t - 1.0 + 2f64.ln() / steep).abs() < 1e-11, "{steep}: {t}");
        let [t, _] = end(&format!("tanh({steep}*(t-1))>0.5"));
        assert!((t - 1.0 - 0.5f64.atanh() / steep).abs() < 1e-11, "{steep}: {t}");
    }
}

#[test]
fn a_spike() {
    for steep in [1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8] {
        let [_, a] = end(&format!("1/(1+({steep}*(a-0.5))^2)=0.5"));
        assert!((a - 0.5 - 1.0 / steep).abs() < 1e-11, "{steep}: {a}");
    }
}

/// The same by a method that has no series of its own; a condition on a reaction that is made of
/// other functions.
#[test]
fn a_spike_by_every_method() {
    spikes(Tsit5);
    spikes(Dop853);
    spikes(Taylor);
    spikes(Radau);
}

fn spikes(method: impl Method + Clone) {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    for steep in [1e3, 1e6] {
        let run = Simulation::new(&model).unwrap().method(method.clone()).tolerance(1e-9);
        let run = run.start(Pose::new("a", 1.0).with("b", 1.0)).unwrap().limit(3.0);
        let run = run.until(&format!("1 - abs(a - 0.5)*{steep} > 0")).unwrap().run().unwrap();
        let a = run.final_state()[0];
        assert!((a - 0.5 - 1.0 / steep).abs() < 1e-7, "{} {steep} {a}", method.name());
    }
}

/// Functions of a sawtooth of any steepness: nothing is found where there is nothing.
#[test]
fn nothing_is_found_that_is_not_there() {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    for condition in
        ["1/(1+(1e6*(a-0.5))^2)=1.1", "sin(1e5*t) > 1.0000001", "1/(2+sin(1e4*a)) < 0.3333", "a^2 < -1e-9"]
    {
        let run =
            Simulation::new(&model).unwrap().start(Pose::new("a", 1.0).with("b", 1.0)).unwrap().limit(3.0);
        let run = run.until(condition).unwrap().run().unwrap();
        assert_eq!(run.events().last().unwrap().kind, EventKind::End, "{condition}");
    }
}

#[test]
fn a_root_beside_a_pole() {
    let [_, a] = end("tan(10*a)=100");
    // The rate of tan is 1e4 · 10 there, the bound 1e-12 of values that poles make large.
    let expected = 0.1 * (100f64.atan() + 2.0 * core::f64::consts::PI);
    assert!((a - expected).abs() < 1e-11, "{a} {expected}");
}

/// tan(ω a) = C has a root 1/ωC before each pole, nearer to it than the tolerance. It is met there,
/// or it is told that this is not decided. From rest at 1 the pendulum falls to −1 and comes back.
#[test]
fn a_root_nearer_to_a_pole_than_the_tolerance() {
    close_to_poles(Tsit5);
    close_to_poles(Dop853);
    close_to_poles(Taylor);
    close_to_poles(Radau);
    close_to_poles(Gauss);
}

fn close_to_poles(method: impl Method + Clone) {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-12] {
        for (omega, height) in [(1302.37, 4593.7), (1302.37, 1e7), (10.0, 1e5), (10.0, 1e9), (10.0, 1e12)] {
            let run = Simulation::new(&model).unwrap().method(method.clone()).tolerance(tolerance);
            let run = run.start(Pose::new("a", 1.0).with("b", 1.0)).unwrap().limit(3.0);
            let run = run.until(&format!("tan({omega}*a)={height}")).unwrap().run();
            let run = run.unwrap_or_else(|e| panic!("{} {tolerance:e} {omega} {height}: {e}", method.name()));
            let turns = ((omega - f64::atan(height)) / core::f64::consts::PI).floor();
            let expected = (f64::atan(height) + turns * core::f64::consts::PI) / omega;
            let (a, name) = (run.final_state()[0], method.name());
            let undecided = |entry: &LogEntry| entry.decision == LoggedDecision::ConditionUndecided;
            // Rounding of the argument of tan, and of the time.
            assert!(
                (a - expected).abs() < 1e-14 || run.log().iter().any(undecided),
                "{name} {tolerance:e} tan({omega} a) = {height}: {a} for {expected}"
            );
            // What the pieces tell apart is decided.
            assert!(omega * height > 1e10 || (a - expected).abs() < 1e-13, "{name} {tolerance:e} {height}");
        }
    }
}

/// No number is as large as tan is at the root: it is told that the condition may have been met.
#[test]
fn a_root_that_a_pole_hides_is_undecided() {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    for tolerance in [1e-4, 1e-9] {
        let run = Simulation::new(&model).unwrap().method(Dop853).tolerance(tolerance);
        let run = run.start(Pose::new("a", 1.0).with("b", 1.0)).unwrap().limit(3.0);
        let undecided = |condition: &str| {
            let run = run.clone().until(condition).unwrap().run().unwrap();
            run.log().iter().filter(|entry| entry.decision == LoggedDecision::ConditionUndecided).count()
        };
        assert_eq!(undecided("tan(10*a)=1e18"), 1, "{tolerance:e}");
        // Poles of odd and of even order, and a kink, that hide nothing.
        for clear in
            ["1/(a-0.5) + 1/(a-0.5)^3 = 2", "1/(a-0.5)^2 < -3", "abs(a-0.5) < -1e-3", "sin(a)/(2+a) > 3"]
        {
            assert_eq!(undecided(clear), 0, "{clear} {tolerance:e}");
        }
    }
}

/// E is T + V: what is left of it is rounding, of no sign that would tell anything. A noise of
/// steep functions is not followed without end either.
#[test]
fn a_condition_of_rounding_is_undecided_and_soon() {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
    for method in [MethodId::Auto, MethodId::Dop853, MethodId::Gauss] {
        let run = Simulation::new(&model).unwrap().method(method).tolerance(1e-6);
        let run = run.start(Pose::new("a", 1.0).with("b", 1.0)).unwrap().limit(0.3);
        for noise in ["E - T - V", "T + V - E > 0", "E - T < V", "abs(E^(-1)) > tan(1e8*(a'')^(-1))"] {
            let begun = std::time::Instant::now();
            let run = run.clone().until(noise).unwrap().run().unwrap();
            let undecided = |entry: &LogEntry| entry.decision == LoggedDecision::ConditionUndecided;
            assert!(
                run.events().last().unwrap().kind != EventKind::End || run.log().iter().any(undecided),
                "{noise}"
            );
            // A fraction of a second on its own; without a bound it takes minutes.
            assert!(begun.elapsed().as_secs() < 20, "{noise} takes {:?}", begun.elapsed());
        }
    }
}

/// A rod falls from 5 with 1000 rad/s: its lower end is y − |sin ωt|/2 high, y = 5 − t²/2. Before t =
/// 3 it is above.
#[test]
fn a_spinning_rod_strikes_with_the_first_end_that_reaches() {
    let start = Pose::new("theta", 0.0).with("theta'", 1000.0).with("y", 5.0);
    let run = Simulation::new(&RodOnSupports { m: 1.0, l: 1.0, g: 1.0 }).unwrap().start(start).unwrap();
    let run = run.limit(4.0).until_event(EventKind::Impact, None).unwrap().run().unwrap();
    let height = |t: f64| 5.0 - 0.5 * t * t - 0.5 * (1000.0 * t).sin().abs();
    // A turn takes 6e-3, the height cannot dip under zero and come back within 1e-7.
    let below = (0..).map(|k| 3.0 + 1e-7 * f64::from(k)).find(|&t| height(t) < 0.0).unwrap();
    let t = run.end_time();
    assert!(t <= below && t > below - 1.1e-7, "{t} {below}");
}
