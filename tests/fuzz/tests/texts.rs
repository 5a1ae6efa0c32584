//! Bounded runs of the fuzzers of expressions, sweeps and journals, in this process.

use std::collections::BTreeMap;
use std::ops::Range;

use liftoff_fuzz::expression::Expressions;
use liftoff_fuzz::journal::Journals;
use liftoff_fuzz::sweep::Sweeps;
use liftoff_fuzz::{Subject, judge};

/// Tries these seeds: each of these fates is had by some of them.
fn tried(subject: &impl Subject, cases: Range<u64>, expected: &[&str]) {
    let mut fates = BTreeMap::new();
    for seed in cases {
        let case = subject.generate(seed);
        match judge(subject, &case) {
            Ok(fate) => fate.into_iter().for_each(|word| *fates.entry(word).or_insert(0) += 1),
            Err(finding) => panic!("seed {seed}: {finding}\n{case}"),
        }
    }
    assert!(expected.iter().all(|fate| fates.get(fate).is_some_and(|count: &u64| *count > 2)), "{fates:?}");
}

/// Between the first seeds whose conditions are zero but for rounding: those take longer than a
/// test may.
#[test]
fn expressions_are_read_or_refused() {
    tried(
        &Expressions::default(),
        22..60,
        &["output", "condition that ran", "no formula", "no output", "no condition"],
    );
}

#[test]
fn sweeps_are_planned_or_refused() {
    tried(&Sweeps, 0..20_000, &["planned", "refused"]);
}

#[test]
fn journals_are_read_as_they_were_written() {
    tried(&Journals::default(), 0..500, &["whole", "in part", "refused"]);
}
