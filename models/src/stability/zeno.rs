//! A ball dropped from h = 1 under g = 1 rests after (1 + e)/(1 − e) √(2h/g) and infinitely many
//! impacts; with e = 1 never.

use super::run;
use liftoff::prelude::*;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::MethodId;
use liftoff_verification::cases::{Case, Effort, expect};

const CLOSED: &str = "geometric series";

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let resting = ["0", "0.5", "0.8", "0.95", "0.99"].map(rests);
    resting.into_iter().chain([elastic()]).collect()
}

fn dropped(e: f64) -> RunSpec {
    RunSpec::with(&[("m", 1.0), ("g", 1.0), ("e", e)]).start(&[("y", 1.0), ("x", 0.0)])
}

fn rests(text: &str) -> Case {
    let e: f64 = text.parse().unwrap_or(f64::NAN);
    let rest = (1.0 + e) / (1.0 - e) * 2.0_f64.sqrt();
    let spec = dropped(e).until(&format!("t = {}", rest + 1.0));
    let scene = format!("bouncing-ball, restitution {text}");
    // An impact is located to the tolerance relative to the flight; the sum of all flights is known
    // as well as they are.
    let expectations = vec![expect("t of rest", rest, 1e-11 * rest), expect("height at the end", 0.0, 1e-14)];
    Case::numbers(format!("zeno.e={text}"), scene, CLOSED, expectations, move |by| {
        let record = run("bouncing-ball", by, &spec)?;
        let closed = [EventKind::Settle, EventKind::Impact];
        let settled = record.events().iter().rev().find(|event| closed.contains(&event.kind));
        let end = record.state(record.interval()[1]);
        Ok(vec![settled.map_or(f64::NAN, |event| event.t), end[1]])
    })
}

fn elastic() -> Case {
    let spec = dropped(1.0).until("t = 283");
    // The first at √2, the others 2√2 apart: the hundredth at 199 √2 = 281.4.
    let expectations =
        vec![expect("impacts", 100.0, 0.0), expect("t of the last", 199.0 * 2.0_f64.sqrt(), 1e-9)];
    Case::numbers("zeno.e=1", "bouncing-ball, restitution 1, t = 283", CLOSED, expectations, move |by| {
        let record = run("bouncing-ball", by, &spec)?;
        let impacts = record.events().iter().filter(|event| event.kind == EventKind::Impact);
        let last = impacts.clone().next_back().map_or(f64::NAN, |event| event.t);
        Ok(vec![impacts.count() as f64, last])
    })
}
