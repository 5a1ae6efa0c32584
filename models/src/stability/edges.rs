//! Events in the first step, exactly at the end of a run, and at its start.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::event_summary::{event, event_summary, first, last};
use liftoff_verification::cases::{Case, Effort, expect};

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let before = ["1e-2", "1e-4", "1e-6", "1e-8"].map(lift_off);
    let drops = ["1e-3", "1e-6", "1e-9"].map(drop);
    let ends = [end("until", "stop"), end("limit", "end"), bare_end()];
    before.into_iter().chain(drops).chain(ends).chain([thrown(), condition()]).collect()
}

/// Fig. 1a on its limiting energy level, this much before the lift-off.
fn lift_off(text: &str) -> Case {
    let phi = reference("falling-pair.lift-off[1e-12]");
    let before: f64 = text.parse().unwrap_or(f64::NAN);
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)])
        .start(&[("phi", phi - before)])
        .energy_of(&[("phi", 0.0)])
        .until("phi = pi/2");
    let scene = format!("falling-pair, {text} before its lift-off");
    let expectations = vec![expect("φ", phi, 1e-11)];
    Case::text_and_numbers(
        format!("edges.first step, lift-off in {text}"),
        scene,
        MPMATH,
        ("open P, Q; stop", expectations),
        move |by| {
            let record = run("falling-pair", by, &spec)?;
            Ok((event_summary(&record), vec![event(&record, 0).state[0]]))
        },
    )
}

fn dropped(g: f64, height: f64, rate: f64) -> RunSpec {
    RunSpec::with(&[("m", 1.0), ("g", g), ("e", 0.5)]).start(&[("y", height), ("x", 0.0), ("y'", rate)])
}

fn drop(text: &str) -> Case {
    let height: f64 = text.parse().unwrap_or(f64::NAN);
    let t = (2.0 * height).sqrt();
    let spec = dropped(1.0, height, 0.0).until("t = 1");
    // The bound of a gap, ten tolerances, divided by the speed.
    let expectations = vec![expect("t", t, 1e-11 / t)];
    let scene = format!("bouncing-ball dropped from {text}");
    Case::text_and_numbers(
        format!("edges.first step, drop from {text}"),
        scene,
        "closed form",
        ("impact P", expectations),
        move |by| {
            let record = run("bouncing-ball", by, &spec)?;
            Ok((first(&record), vec![event(&record, 0).t]))
        },
    )
}

/// From h = 1 under g = 2 a ball falls for exactly 1.
fn end(by: &str, kind: &str) -> Case {
    let spec = dropped(2.0, 1.0, 0.0);
    let spec = if by == "until" { spec.until("t = 1") } else { spec.limit(1.0) };
    let scene = format!("bouncing-ball that strikes exactly at the end of the run, by `{by}`");
    let expectations = vec![expect("t", 1.0, 1e-15), expect("y' at the end", 1.0, 1e-11)];
    let outcome = format!("impact P; {kind}");
    Case::text_and_numbers(
        format!("edges.at the end, {by}"),
        scene,
        "closed form",
        (&outcome, expectations),
        move |by| {
            let record = run("bouncing-ball", by, &spec)?;
            Ok((event_summary(&record), vec![event(&record, 0).t, last(&record)[3]]))
        },
    )
}

/// Well before the impact nothing happens.
fn bare_end() -> Case {
    let spec = dropped(2.0, 1.0, 0.0).until("t = 0.999999");
    let expectations = vec![expect("y", 1.0 - 0.999_999_f64.powi(2), 1e-14)];
    let scene = "bouncing-ball, run ended 1e-6 before its impact";
    Case::text_and_numbers("edges.before the end", scene, "closed form", ("stop", expectations), move |by| {
        let record = run("bouncing-ball", by, &spec)?;
        Ok((event_summary(&record), vec![last(&record)[1]]))
    })
}

/// A gap that is zero at the start and grows.
fn thrown() -> Case {
    let spec = dropped(1.0, 0.0, 1.0).until("t = 2.5");
    let scene = "bouncing-ball thrown up from the floor";
    let expectations = vec![expect("t", 2.0, 1e-11)];
    Case::text_and_numbers(
        "edges.at the start, a gap",
        scene,
        "closed form",
        ("impact P; stop", expectations),
        move |by| {
            let record = run("bouncing-ball", by, &spec)?;
            Ok((event_summary(&record), vec![event(&record, 0).t]))
        },
    )
}

/// A condition that is met at the start is met again when the pendulum comes back.
fn condition() -> Case {
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 1.0)];
    let spec = RunSpec::with(&parameters).start(&[("phi", 0.25), ("phi'", 1.0)]).until("phi = 0.25");
    let scene = "pendulum at the angle that it is to be stopped at, rising";
    let expectations = vec![expect("φ'", -1.0, 1e-11)];
    Case::text_and_numbers(
        "edges.at the start, a condition",
        scene,
        "energy",
        ("stop", expectations),
        move |by| {
            let record = run("pendulum", by, &spec)?;
            Ok((event_summary(&record), vec![last(&record)[1]]))
        },
    )
}
