//! Random systems: what holds for the oracle in any of them, and what the drawing promises.

use std::collections::BTreeSet;

use liftoff_tests::oracle::{Assembly, State};
use liftoff_tests::random::{Sample, Source, sample};

/// A closed set that leaves the system regular: supports are added while the rows stay independent.
fn closed(sample: &Sample, state: &State, source: &mut Source) -> Vec<usize> {
    let mut set = Vec::new();
    for support in 0..sample.assembly.supports.len() {
        let larger = [set.clone(), vec![support]].concat();
        let regular = sample.assembly.solve(state, &larger).is_ok_and(|m| m.pivots > 1e-6);
        if regular && source.chance(0.7) {
            set = larger;
        }
    }
    set
}

/// The state a time t later at constant accelerations.
fn later(state: &State, accelerations: &nalgebra::DVector<f64>, t: f64) -> State {
    State {
        positions: &state.positions + &state.rates * t + accelerations * (0.5 * t * t),
        rates: &state.rates + accelerations * t,
        time: state.time + t,
    }
}

/// g̈ by central differences of g alone.
fn second_difference(f: impl Fn(f64) -> f64, t: f64) -> f64 {
    (f(t) - 2.0 * f(0.0) + f(-t)) / (t * t)
}

fn check_rows(assembly: &Assembly, state: &State, set: &[usize]) {
    let motion = assembly.solve(state, set).expect("regular");
    let size = 1.0 + motion.accelerations.amax();
    for support in 0..assembly.supports.len() {
        let gap = |t: f64| assembly.gap(&later(state, &motion.accelerations, t), support)[0];
        let t = 1e-3 / size.sqrt();
        // truncation t² g⁗/12 with rates up to 2 and |q̈| < size, rounding 1e-15/t²
        let error = second_difference(gap, t) - motion.gap_accelerations[support];
        assert!(error.abs() < 1e-4 * size, "support {support}: {error:e} of {size:e}");
        if set.contains(&support) {
            assert!(motion.gap_accelerations[support].abs() < 1e-10 * size);
        }
    }
}

/// Without closed supports the joints do no work: q̇·M q̈ = q̇·Q, the power of gravity.
fn check_power(assembly: &Assembly, state: &State) {
    let motion = assembly.solve(state, &[]).expect("regular");
    let inertial = assembly.masses().component_mul(&motion.accelerations);
    let forces = assembly.forces(state);
    let scale = 1.0 + inertial.amax() + forces.amax();
    let power = state.rates.dot(&(inertial - forces)) / (1.0 + state.rates.norm());
    assert!(power.abs() < 1e-9 * scale, "{power:e} of {scale:e}");
}

/// All bodies together: Σ m C̈ = Σ m g + pins + supports.
fn check_momentum(assembly: &Assembly, state: &State, set: &[usize]) {
    let motion = assembly.solve(state, set).expect("regular");
    let inertial = assembly.masses().component_mul(&motion.accelerations) - assembly.forces(state);
    let rows = |support| assembly.support_row(state, support).gradient;
    let particles = 3 * assembly.bodies.len();
    for axis in 0..2 {
        let of = |index: usize| match index.checked_sub(particles) {
            None => index % 3 == axis,
            Some(index) => index % 2 == axis,
        };
        let total = |it: &dyn Fn(usize) -> f64| (0..inertial.len()).filter(|&i| of(i)).map(it).sum::<f64>();
        let carried: f64 = motion.pins.iter().map(|force| force[axis]).sum();
        let pushed = |&support: &usize| {
            let entries = rows(support).into_iter().filter(|&(index, _)| of(index));
            motion.reactions[support] * entries.map(|(_, entry)| entry).sum::<f64>()
        };
        let pushed: f64 = set.iter().map(pushed).sum();
        let scale = 1.0 + inertial.amax() + motion.reactions.iter().fold(0.0, |a: f64, r| a.max(r.abs()));
        let error = total(&|index| inertial[index]) - carried - pushed;
        assert!(error.abs() < 1e-9 * scale, "{error:e} of {scale:e}");
    }
}

#[test]
fn oracle_keeps_the_laws_in_random_systems() {
    for seed in 0..200 {
        let sample = sample(seed);
        let mut source = Source::new(seed ^ 1);
        let Some(state) = sample.state(&mut source) else {
            continue;
        };
        assert!(sample.assembly.residual(&state) < 1e-12, "seed {seed}");
        let set = closed(&sample, &state, &mut source);
        check_rows(&sample.assembly, &state, &set);
        check_power(&sample.assembly, &state);
        check_momentum(&sample.assembly, &state, &set);
    }
}

#[test]
fn the_same_seed_draws_the_same_system() {
    let [first, second] = [5, 5].map(|seed| sample(seed).declaration);
    assert_eq!(first, second);
}

#[test]
fn declarations_are_rust_and_use_every_parameter() {
    for seed in 0..100 {
        let sample = sample(seed);
        assert!(sample.tokens().is_ok(), "{}", sample.declaration);
        let body = sample.declaration.split("pub struct").next().unwrap_or_default();
        let words: BTreeSet<_> = body.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
        for (name, _) in &sample.parameters {
            assert!(words.contains(name.as_str()), "{name} is unused:\n{}", sample.declaration);
        }
    }
}

#[test]
fn drawing_reaches_every_kind_of_thing() {
    let wanted = [
        "#[chain(",
        "#[point(",
        "#[mass(",
        "#[pin(",
        "#[equal(angle(",
        "#[constant(",
        "#[gravity(",
        "= floor",
        "= wall(",
        "= slope(",
        "corner(",
        "over = ",
        "facing = ",
        "inertia = ",
        "centre = (",
        "from = horizontal",
        "from = vertical",
        "from = left",
        " -> ",
        "sqrt(",
        "mass = 0,",
        "= -y(",
        "#[mirror(x",
        "#[mirror(y",
        "swap(",
    ];
    let all: String = (0..400).map(|seed| sample(seed).declaration).collect();
    let missing: Vec<_> = wanted.into_iter().filter(|what| !all.contains(what)).collect();
    assert!(missing.is_empty(), "never drawn in 400 systems: {missing:?}");
}
