//! First integrals along motions: what the formulas say stays constant does, in runs of the
//! compiled models.

use liftoff::Trajectory;
use liftoff_compiled::models;
use liftoff_conditions::{FirstIntegrals, Kind, first_integrals};
use liftoff_studio::registry::Entry;
use std::collections::BTreeSet;

/// Of a segment so many places are looked at.
const PLACES: usize = 25;

/// Errors of the runs.
const DRIFT: f64 = 100.0 * TOLERANCE;
/// The most that rounding may add to them.
const COARSE: f64 = 2e-9;
/// The tolerance of the runs.
const TOLERANCE: f64 = 1e-12;

/// Roundings of each entry of a state.
const ROUNDINGS: u32 = 16;

/// How far an integral strays within the segments of its contact set, over its natural unit or its
/// own size; none where the run has no such segment.
fn drift(
    run: &Trajectory,
    analysis: &liftoff_codegen::Analysis,
    of: &FirstIntegrals,
    units: [f64; 3],
) -> Vec<(Kind, f64)> {
    let n = run.layout().coordinates.len();
    let set = Some((of.set.closed, of.set.stick));
    let segments = run.segments();
    let same =
        segments.iter().filter(|s| s.set.bits_and_stick() == set && s.acting.is_empty() && s.t1 > s.t0);
    let [length, time, mass] = units;
    let mut found = Vec::new();
    for segment in same {
        for integral in &of.integrals {
            let at = |k: usize| segment.t0 + (segment.t1 - segment.t0) * (k as f64 + 0.5) / PLACES as f64;
            let value = |state: &[f64]| integral.evaluate(&analysis.system, run.parameters(), n, state);
            let states: Vec<Vec<f64>> = (0..PLACES).map(|k| run.state(at(k))).collect();
            let values: Vec<f64> = states.iter().map(|state| value(state)).collect();
            let rounding = states.iter().map(|state| rounding(&value, state)).fold(0.0, f64::max);
            let unit = match &integral.kind {
                Kind::Energy | Kind::InternalEnergy => mass * length * length / (time * time),
                // Of an angle times a length.
                Kind::Momentum(_) => mass * length.max(length * length) / time,
            };
            let size = values.iter().fold(unit, |most, value| most.max(value.abs()));
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            assert!(values.iter().all(|value| value.is_finite()), "{} {:?}", of.phase, integral.kind);
            assert!((most - least) / size < COARSE, "{} {:?}: {least} to {most}", of.phase, integral.kind);
            found.push((integral.kind.clone(), (most - least - rounding) / size));
        }
    }
    found
}

/// The most that the rounding of a state changes in a function of it, whose terms cancel near the
/// pole of a closed form: sums over cos⁴ φ of 0.01 keep eight digits.
fn rounding(value: &dyn Fn(&[f64]) -> f64, state: &[f64]) -> f64 {
    let changed = |i: usize| {
        let by = |k: u32| {
            let mut rounded = state.to_vec();
            rounded[i] *= 1.0 + f64::from(k) * f64::EPSILON;
            (value(&rounded) - value(state)).abs()
        };
        (1..=ROUNDINGS).map(by).fold(0.0, f64::max)
    };
    (0..state.len()).map(changed).sum()
}

fn of_model(entry: &Entry) -> Vec<(Kind, f64)> {
    let tokens = entry.layout().declaration.parse().expect("tokens");
    let analysis = liftoff_codegen::analyse(tokens).expect("a model");
    let spec = entry.default_run().tolerance(TOLERANCE);
    let Ok(run) = entry.run(&spec) else { return Vec::new() };
    let units = entry.units(&spec).expect("units");
    let all = first_integrals(&analysis);
    all.iter().flat_map(|of| drift(&run, &analysis, of, units)).collect()
}

#[test]
fn first_integrals_stay_constant_along_the_default_runs() {
    let (mut kept, mut models_with) = (0, BTreeSet::new());
    let mut momenta = 0;
    for entry in models().iter() {
        for (kind, drift) in of_model(entry) {
            assert!(drift < DRIFT, "{} {kind:?}: {drift:e}", entry.name());
            kept += 1;
            momenta += usize::from(matches!(kind, Kind::Momentum(_)));
            models_with.insert(entry.name().to_owned());
        }
    }
    // Nearly every model without damping or drives has some: a list that lost its segments would be
    // shorter.
    assert!(kept > 20 && momenta > 0 && models_with.len() > 10, "{kept} {momenta} {models_with:?}");
}
