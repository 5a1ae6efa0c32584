//! A bounded run of the fuzzer of runs, in this process.

use std::collections::BTreeMap;

use liftoff_fuzz::run::Runs;
use liftoff_fuzz::{Subject, judge};

/// So many cases take some seconds.
const CASES: u64 = 150;

#[test]
fn runs_are_sound_or_refused() {
    let mut fates = BTreeMap::new();
    for seed in 0..CASES {
        let case = Runs.generate(seed);
        match judge(&Runs, &case) {
            Ok(fate) => fate.into_iter().for_each(|word| *fates.entry(word).or_insert(0) += 1),
            Err(finding) => panic!("seed {seed}: {finding}\n{case}\n{}", Runs.details(&case)),
        }
    }
    let count = |word: &str| fates.get(word).copied().unwrap_or(0);
    assert!(
        count("ran") > CASES / 2 && count("compared: units") > 0 && count("compared: method") > 0,
        "{fates:?}"
    );
}

#[test]
fn a_seed_is_one_run() {
    assert!((0..200).all(|seed| Runs.generate(seed).to_string() == Runs.generate(seed).to_string()));
}
