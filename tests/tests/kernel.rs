//! What the generator derives of random systems, by its interpreter, against the oracle: positions, energies,
//! gaps, accelerations, reactions, forces inside; the full kernel and the closed forms.

mod pair;

use std::ops::Range;

use liftoff_tests::random::{Source, Vocabulary};
use pair::Pair;

/// Checks the kernel of each system with a random contact set; how many comparisons were made.
fn kernels(seeds: Range<u64>, vocabulary: Vocabulary) -> usize {
    let mut compared = 0;
    for seed in seeds {
        let pair = Pair::without_phases(seed, vocabulary);
        let mut source = Source::new(seed ^ 0x5eed);
        let Some(state) = pair.sample.state(&mut source) else {
            continue;
        };
        pair.positions(&state);
        pair.energies(&state);
        pair.gaps(&state);
        let sets = 1 << pair.analysis.motion.contacts.len();
        for set in [0, source.below(sets) as u64] {
            let touching = pair.touching(&state, set);
            compared += usize::from(touching.is_some_and(|state| pair.kernel(&state, set)));
        }
    }
    compared
}

/// Every seed is one system; a test of a thousand takes some ten seconds of one core.
macro_rules! kernels {
    ($($name:ident: $seeds:expr, $vocabulary:ident;)*) => {$(
        #[test]
        fn $name() {
            let seeds: Range<u64> = $seeds;
            let least = (seeds.end - seeds.start) as usize;
            let compared = kernels(seeds, Vocabulary::$vocabulary);
            assert!(compared >= least, "only {compared} comparisons were made");
        }
    )*};
}

kernels! {
    bars_0_to_999: 0..1000, BARS;
    bars_1000_to_1999: 1000..2000, BARS;
    vocabulary_0_to_999: 0..1000, ALL;
    vocabulary_1000_to_1999: 1000..2000, ALL;
    vocabulary_2000_to_2999: 2000..3000, ALL;
    vocabulary_3000_to_3999: 3000..4000, ALL;
    vocabulary_4000_to_4999: 4000..5000, ALL;
    vocabulary_5000_to_5999: 5000..6000, ALL;
    vocabulary_6000_to_6999: 6000..7000, ALL;
    vocabulary_7000_to_7999: 7000..8000, ALL;
}

/// Collides the smooth contacts of each system without a mirror in random sets; how many impacts there were.
fn impacts(seeds: Range<u64>) -> usize {
    let mut done = 0;
    for seed in seeds {
        let pair = Pair::without_phases(seed, Vocabulary { rough: 0.0, ..Vocabulary::ALL });
        let contacts = pair.analysis.motion.contacts.len();
        let mut source = Source::new(seed ^ 0x1ac7);
        let idle = contacts == 0 || pair.sample.is_mirrored();
        for _ in 0..if idle { 0 } else { 20 } {
            let set = 1 + source.below((1 << contacts) - 1) as u64;
            let state = pair.colliding(set, &mut source);
            done += usize::from(state.is_some_and(|state| pair.impact(&state, set)));
        }
    }
    done
}

#[test]
fn random_impacts_0_to_499() {
    let done = impacts(0..500);
    assert!(done >= 5000, "only {done} impacts");
}

#[test]
fn random_impacts_500_to_999() {
    let done = impacts(500..1000);
    assert!(done >= 5000, "only {done} impacts");
}

#[test]
fn closed_forms_of_random_systems() {
    let (mut compared, mut reduced) = (0, 0);
    for seed in 0..300 {
        let pair = Pair::new(seed, Vocabulary::BARS);
        let mut source = Source::new(seed ^ 0xc105ed);
        for phase in &pair.analysis.functions.phases {
            let start = pair.sample.state(&mut source);
            let settled = start.and_then(|s| pair.sample.assembly.settle(s, &pair.supports(phase.set)));
            if settled.is_some_and(|state| pair.closed_form(phase, &state)) {
                compared += 1;
                reduced += usize::from(phase.set != 0);
            }
        }
    }
    assert!(compared >= 300 && reduced >= 150, "{compared} forms compared, {reduced} with contacts");
}
