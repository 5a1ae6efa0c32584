//! Stiff springs on one side, supports that bear more than they must, narrow loads, and very many
//! impacts.

use super::{run, run_unjudged};
use core::f64::consts::PI;
use liftoff::prelude::*;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_verification::cases::{Case, Effort, expect};

const CLOSED: &str = "closed form";

/// A mass from y = 1 falls onto a spring of stiffness k: below zero y″ = −1 − k y, for as long as
/// 2 (π − atan(√2 ω))/ω.
pub(super) fn buffers(_: MethodId, _: Effort) -> Vec<Case> {
    let case = |text: &str| {
        let k: f64 = text.parse().unwrap_or(f64::NAN);
        let fall = 2.0_f64.sqrt();
        let contact = 2.0 * (PI - (fall * k.sqrt()).atan()) / k.sqrt();
        let spec = RunSpec::with(&[("m", 1.0), ("k", k), ("g", 1.0)])
            .start(&[("y", 1.0)])
            .tolerance(1e-12)
            .until(&format!("t = {}", 2.0 * fall + contact));
        let expectations = vec![expect("y", 1.0, 1e-8), expect("y'", 0.0, 1e-8)];
        let scene = format!("a mass falls onto a spring, k = {text} mg/h, to its highest place");
        Case::numbers(format!("buffers.k={text}"), scene, CLOSED, expectations, move |by| {
            end(&run("buffer", by, &spec)?, &["y", "y'"])
        })
    };
    ["1", "1e3", "1e6", "1e9", "1e12"].map(case).into()
}

/// The last values of what is named.
fn end(record: &Trajectory, names: &[&str]) -> Result<Vec<f64>, MotionError> {
    let t = record.interval()[1];
    names.iter().map(|name| Ok(record.function(name)?(t))).collect()
}

/// A level rod on three supports: of all reactions that bear it the smallest are a third of its
/// weight each.
pub(super) fn redundant(_: MethodId, _: Effort) -> Vec<Case> {
    let case = |text: &str| {
        let m: f64 = text.parse().unwrap_or(f64::NAN);
        let spec = RunSpec::with(&[("m", m), ("l", 1.0), ("g", 9.81)])
            .start(&[("phi", 0.0), ("x", 0.0), ("y", 0.0), ("x'", 1.0)])
            .limit(1.0);
        let third = || 1.0 / 3.0;
        let expectations = vec![
            expect("N(A)/mg", third(), 1e-14),
            expect("N(C)/mg", third(), 1e-14),
            expect("N(B)/mg", third(), 1e-14),
        ];
        let scene = format!("rod-on-three that slides, mass {text}");
        Case::numbers(format!("redundant.m={text}"), scene, "statics", expectations, move |by| {
            let record = run("rod-on-three", by, &spec)?;
            ["N(A)", "N(C)", "N(B)"]
                .into_iter()
                .map(|name| Ok(record.function(name)?(0.5) / (m * 9.81)))
                .collect()
        })
    };
    ["1e-12", "1", "1e12"].map(case).into()
}

/// Over half a turn, n even, ∫ sinⁿ t dt = π Π (2 k − 1)/(2 k) for k = 1 … n/2.
pub(super) fn loads(_: MethodId, _: Effort) -> Vec<Case> {
    let case = |n: u32| {
        let pulse = (1..=n / 2).fold(PI, |product, k| product * f64::from(2 * k - 1) / f64::from(2 * k));
        let spec =
            RunSpec::with(&[("f", 1.0)]).start(&[("x", 0.0)]).tolerance(1e-10).until("t = 31.41592653589793");
        let expectations = vec![expect("x' after ten", 10.0 * pulse, 1e-8)];
        let scene = format!("a mass under sinⁿ t, n = {n}, ten times");
        Case::numbers(format!("loads.n={n}"), scene, CLOSED, expectations, move |by| {
            // The judge's own steps pass over narrow loads.
            end(&run_unjudged(&format!("pulses-{n}"), by, &spec)?, &["x'"])
        })
    };
    [32, 512, 8192].map(case).into()
}

/// A ball from h = 1 under g = 1 strikes for the n-th time at √2 (1 + 2 (e + e² + … + eⁿ⁻¹)).
pub(super) fn impacts(_: MethodId, effort: Effort) -> Vec<Case> {
    let count = if effort == Effort::Full { 100_000_u32 } else { 1000 };
    let case = |text: &str| {
        let e: f64 = text.parse().unwrap_or(f64::NAN);
        let flights = |n: u32| (1..n).fold((1.0, 0.0), |(power, sum), _| (power * e, sum + power * e)).1;
        let time = |n: u32| 2.0_f64.sqrt() * (1.0 + 2.0 * flights(n));
        let (last, next) = (time(count), time(count + 1));
        let spec = RunSpec::with(&[("m", 1.0), ("g", 1.0), ("e", e)])
            .start(&[("y", 1.0), ("x", 0.0)])
            .limit(0.5 * (last + next));
        // A tenth of the tolerance, of each flight.
        let expectations =
            vec![expect("impacts", count.into(), 0.0), expect("t of the last", last, 1e-10 * last)];
        let scene = format!("bouncing-ball, restitution {text}, {count} impacts");
        Case::numbers(format!("impacts.e={text}"), scene, "geometric series", expectations, move |by| {
            let record = run("bouncing-ball", by, &spec)?;
            let mut impacts = record.events().iter().filter(|event| event.kind == EventKind::Impact);
            Ok(vec![impacts.clone().count() as f64, impacts.next_back().map_or(f64::NAN, |event| event.t)])
        })
    };
    ["1", "0.99999"].map(case).into()
}
