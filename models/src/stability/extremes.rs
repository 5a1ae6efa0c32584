//! Numbers near the ends of floating point, steps that cannot be made, times beyond all others: the
//! right answer or a typed error with what was computed, never a panic or a run without end.

use super::reference::{MPMATH, reference};
use super::{run, run_unjudged};
use liftoff::Trajectory;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_verification::cases::event_summary::{event, event_summary, last};
use liftoff_verification::cases::{Answer, Case, Effort, Expectation, Expected, at_most, expect};

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let masses = ["1e300", "1e-300"].map(|text| pair("m", text, [1.0, number(text), 1.0]));
    let lengths = ["1e200", "1e-200"].map(|text| pair("l", text, [number(text), 1.0, number(text)]));
    let slow = ["1e-200", "1e200"].map(|text| pair("g", text, [1.0, 1.0, number(text)]));
    let rates = [spin(), spins(), throw()];
    let tolerances = ["1e-15", "1e-16", "1e-30", "1e-2", "0.5"].map(tolerance);
    let rest = [pole(), floor(), long_rest(), long_flight()];
    let all = masses.into_iter().chain(lengths).chain(slow);
    all.chain(rates).chain(tolerances).chain(rest).collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or(f64::NAN)
}

fn either(
    id: String,
    scene: String,
    expectations: Vec<Expectation>,
    measure: impl FnOnce(MethodId) -> Result<Vec<f64>, MotionError> + Send + 'static,
) -> Case {
    Case::new(id, scene, MPMATH, Expected::Either(expectations), move |by| {
        Ok(Answer { text: String::new(), numbers: measure(by)? })
    })
}

/// Fig. 1a with these l, m and g.
fn pair(name: &str, text: &str, [l, m, g]: [f64; 3]) -> Case {
    let unit = (l / g).sqrt();
    let spec = RunSpec::with(&[("m", m), ("l", l), ("g", g)]).start(&[("phi", 0.1)]).until("phi = pi/2");
    let scene = format!("falling-pair, {name} = {text}");
    either(format!("extremes.pair {name}={text}"), scene, lift_off(1e-11), move |by| {
        let record = run("falling-pair", by, &spec)?;
        let open = event(&record, 0);
        Ok(vec![open.state[0], open.t / unit])
    })
}

fn lift_off(within: f64) -> Vec<Expectation> {
    let [phi, t] = ["lift-off", "time"].map(|what| reference(&format!("falling-pair.{what}[1e-1]")));
    vec![expect("φ", phi, within), expect("t", t, 10.0 * within)]
}

/// φ̇² overflows; what gravity does in so short a turn is nothing.
fn spin() -> Case {
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 1.0)];
    let spec = RunSpec::with(&parameters).start(&[("phi", 0.0), ("phi'", 1e155)]).until("t = 1e-150");
    let expectations = vec![expect("φ'/1e155", 1.0, 1e-11), expect("φ/1e5", 1.0, 1e-11)];
    either(
        "extremes.pendulum φ'=1e155".into(),
        "pendulum, φ' = 1e155, for 1e5 radians".into(),
        expectations,
        move |by| {
            let state = last(&run("pendulum", by, &spec)?);
            Ok(vec![state[1] / 1e155, state[0] / 1e5])
        },
    )
}

/// Centrifugal forces overflow.
fn spins() -> Case {
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 1.0)];
    let start = [("phi_1", 0.0), ("phi_2", 1.0), ("phi_1'", 1e155), ("phi_2'", -1e155)];
    let spec = RunSpec::with(&parameters).start(&start).until("t = 1");
    let scene = "double-pendulum, φ' = ±1e155: forces overflow";
    Case::refused("extremes.double pendulum φ'=1e155", scene, "beyond the range of f64", move |by| {
        run("double-pendulum", by, &spec)
    })
}

fn throw() -> Case {
    let spec = RunSpec::with(&[("m", 1.0), ("g", 1.0), ("e", 0.5)])
        .start(&[("y", 1.0), ("x", 0.0), ("y'", 1e155)])
        .until("t = 1");
    let expectations = vec![expect("y/1e155", 1.0, 1e-11)];
    either(
        "extremes.ball y'=1e155".into(),
        "bouncing-ball thrown at 1e155, t = 1".into(),
        expectations,
        move |by| Ok(vec![last(&run("bouncing-ball", by, &spec)?)[1] / 1e155]),
    )
}

/// Rounding bounds what a tolerance finer than it can reach; a coarse one bounds each step's error
/// only.
fn tolerance(text: &str) -> Case {
    let tolerance = number(text);
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", 0.1)])
        .until("phi = pi/2")
        .tolerance(tolerance);
    let within = (10.0 * tolerance).max(1e-13);
    let scene = format!("falling-pair, tolerance {text}");
    either(format!("extremes.tolerance {text}"), scene, lift_off(within), move |by| {
        let record = run("falling-pair", by, &spec)?;
        let open = event(&record, 0);
        Ok(vec![open.state[0], open.t])
    })
}

/// A run that stops short, with what it kept.
fn kept(name: &str, by: MethodId, spec: &RunSpec) -> Result<(String, Trajectory), MotionError> {
    match run(name, by, spec) {
        Ok(record) => Ok((event_summary(&record), record)),
        Err(MotionError::Run { trajectory, .. }) => Ok(("stopped short".to_owned(), *trajectory)),
        Err(failure) => Err(failure),
    }
}

/// Massless inner bars pass the horizontal: det M = 0 there, φ̈ has a pole.
fn pole() -> Case {
    let spec = RunSpec::with(&[("m1", 0.0), ("m2", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi_inner", 0.8), ("phi_outer", 0.8)])
        .tolerance(1e-8);
    let expectations = vec![at_most("φ inner at the end of what is kept", 1e-3)];
    let scene = "zigzag without inner masses, into the pole at φ = 0";
    Case::text_and_numbers("extremes.pole", scene, "mechanics", ("stopped short", expectations), move |by| {
        let (outcome, record) = kept("zigzag", by, &spec)?;
        Ok((outcome, vec![last(&record)[0]]))
    })
}

/// A condition that is no number beyond φ = ½: its root is a branch point that no step can pass.
fn floor() -> Case {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", 0.1)])
        .until("sqrt(0.5 - phi) = -1");
    let expectations = vec![expect("φ at the end of what is kept", 0.4, 0.1)];
    let scene = "falling-pair, a condition that becomes undefined";
    Case::text_and_numbers(
        "extremes.undefined condition",
        scene,
        "mechanics",
        ("stopped short", expectations),
        move |by| {
            let (outcome, record) = kept("falling-pair", by, &spec)?;
            Ok((outcome, vec![last(&record)[0]]))
        },
    )
}

/// A ball at rest stays there.
fn long_rest() -> Case {
    let spec =
        RunSpec::with(&[("m", 1.0), ("g", 1.0), ("e", 0.0)]).start(&[("y", 1.0), ("x", 0.0)]).limit(1e300);
    let expectations = vec![expect("t", 1e300, 0.0), expect("y", 0.0, 1e-14)];
    let scene = "bouncing-ball, plastic, until t = 1e300";
    Case::text_and_numbers(
        "extremes.rest until 1e300",
        scene,
        "mechanics",
        ("impact P; end", expectations),
        move |by| {
            let record = run_unjudged("bouncing-ball", by, &spec)?;
            Ok((event_summary(&record), vec![record.interval()[1], last(&record)[1]]))
        },
    )
}

/// Thrown at v a ball is back at 2v/g.
fn long_flight() -> Case {
    let spec = RunSpec::with(&[("m", 1.0), ("g", 1e-9), ("e", 0.0)])
        .start(&[("y", 0.0), ("x", 0.0), ("y'", 1e9)])
        .limit(1e20);
    let expectations = vec![expect("t/2e18", 1.0, 1e-11)];
    let scene = "bouncing-ball thrown at 1e9 under g = 1e-9";
    Case::text_and_numbers(
        "extremes.flight of 2e18",
        scene,
        "closed form",
        ("impact P; end", expectations),
        move |by| {
            let record = run_unjudged("bouncing-ball", by, &spec)?;
            Ok((event_summary(&record), vec![event(&record, 0).t / 2e18]))
        },
    )
}
