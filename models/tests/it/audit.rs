//! All models audited: their default runs, and starts at random rates.

use std::f64::consts::{FRAC_PI_2, PI};

use liftoff::EventKind;
use liftoff_models::models;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_studio::run_spec::RunSpec;

#[test]
fn default_runs_are_clean() {
    for model in models().iter() {
        let audit = model.run(&model.default_run()).unwrap().audit();
        assert!(audit.is_clean() && !audit.worst().is_empty(), "{}:\n{audit}", model.name());
    }
}

/// Without loads, drives and moving surfaces E + D is constant, whatever friction, dampers and
/// impacts take; of an applied impulse it has the work.
#[test]
fn lost_energy_is_accounted_for() {
    let mut lossy = 0;
    for model in models().iter().filter(|model| !["belt"].contains(&model.name())) {
        let layout = model.layout();
        let spec = model.default_run();
        if layout.timed || layout.loaded || !spec.impulses.is_empty() {
            continue;
        }
        let run = model.run(&spec).unwrap();
        let [sum, lost, kinetic] = ["E + D", "D", "T"].map(|text| run.output(text).unwrap());
        let [start, end] = run.interval();
        let scales = run.scales();
        let most = run.range(&kinetic).unwrap()[1].max(1e-3 * scales.force() * scales.length);
        let begun = run.value(&sum, start);
        lossy += u32::from(run.value(&lost, end) > 1e-3 * most);
        for k in 0..=50 {
            let t = start + (end - start) * f64::from(k) / 50.0;
            let off = (run.value(&sum, t) - begun).abs() / most;
            assert!(off < 1e-9, "{} at {t}: {off:e}", model.name());
        }
        let losses: Vec<f64> = run.times().iter().map(|&t| run.value(&lost, t)).collect();
        assert!(losses.windows(2).all(|pair| pair[1] - pair[0] > -1e-9 * most), "{}", model.name());
    }
    assert!(lossy > 8, "{lossy}");
}

/// A number in −1..1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// What was given is what the run starts with, before any impact, or it is refused.
#[test]
fn given_rates_are_kept_or_refused() {
    let mut seed = 3;
    for model in models().iter() {
        for _ in 0..4 {
            let names: Vec<String> =
                model.layout().coordinates.iter().map(|c| format!("{}'", c.name)).collect();
            let given: Vec<(&str, f64)> = names
                .iter()
                .map(|name| (name.as_str(), random(&mut seed), 3.0 * random(&mut seed)))
                .filter(|(_, chosen, _)| *chosen < 0.0)
                .map(|(name, _, value)| (name, value))
                .collect();
            let spec = RunSpec::with(&[]).start(&given).limit(0.3);
            let run = match model.run(&spec) {
                Ok(run) => run,
                Err(MotionError::Run { trajectory, .. }) => *trajectory,
                Err(_) => continue,
            };
            let Some(start) = run.events().first() else { continue };
            for (name, value) in &given {
                let place = names.iter().position(|known| known == name).unwrap() + names.len();
                let kept = (start.state[place] - value).abs();
                assert!(kept < 1e-9, "{} {given:?}: {name} off by {kept:e}", model.name());
            }
            assert!(run.audit().is_clean(), "{} {given:?}:\n{}", model.name(), run.audit());
        }
    }
}

/// On straight legs the gaps of both feet have one gradient, so that either bears. The foot whose
/// knee bends faster is off the floor at once, whatever the tolerance at which that is seen.
#[test]
fn a_foot_that_depends_on_the_other_only_at_the_start_opens_there() {
    let model = models().find("walker").unwrap();
    for (tolerance, method) in [
        (1e-4, MethodId::Tsit5),
        (1e-5, MethodId::Dop853),
        (1e-6, MethodId::Auto),
        (1e-8, MethodId::Tsit5),
        (1e-11, MethodId::Dop853),
    ] {
        let start = [("lean", PI), ("lean'", 10.0), ("theta_right", -FRAC_PI_2), ("x'", -2.0), ("y'", 0.0)];
        let mut spec = model.default_run().start(&start).tolerance(tolerance).limit(0.02);
        spec.until.clear();
        let run = model.simulation(&spec).unwrap().method(method).run().unwrap();
        let [_, open, ..] = run.events() else { panic!("{:?}", run.events()) };
        assert_eq!(
            (open.t, open.kind, &open.supports[..]),
            (0.0, EventKind::Open, &["Q"][..]),
            "{tolerance:e}"
        );
        assert_eq!(run.segments()[0].closed, ["P"]);
        assert!(run.audit().is_clean(), "{tolerance:e}:\n{}", run.audit());
    }
}
