//! A bounded run of the declaration fuzzer, in this process.

use liftoff_fuzz::declaration::Declarations;
use liftoff_fuzz::{Subject, judge};

/// So many cases take some seconds.
const CASES: u64 = 600;

#[test]
fn declarations_are_derived_or_refused() {
    let subject = Declarations::default();
    for seed in 0..CASES {
        let case = subject.generate(seed);
        if let Err(finding) = judge(&subject, &case) {
            panic!("seed {seed}: {finding}\n{case}");
        }
    }
}

#[test]
fn a_seed_is_one_case() {
    let [one, other] = [Declarations::default(), Declarations::default()];
    assert!((0..50).all(|seed| one.generate(seed) == other.generate(seed)));
}

/// A struct that a keyword names was repeated in what stands for it.
#[test]
fn known_findings_are_fixed() {
    let subject = Declarations::default();
    for seed in [777_010_005, 777_011_433] {
        let case = subject.generate(seed);
        if let Err(finding) = judge(&subject, &case) {
            panic!("seed {seed}: {finding}\n{case}");
        }
    }
}
