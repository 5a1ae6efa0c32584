//! Random trees by recursion over their bodies, written out entry by entry, and by the oracle.

mod pair;

use liftoff_codegen::functions::Functions;
use liftoff_codegen::motion::Scene;
use liftoff_codegen::{Analysis, motion::Tree};
use liftoff_tests::random::{Source, Vocabulary};
use pair::Pair;

/// The same system, its functions by recursion; `None` for what is no tree.
fn by_recursion(pair: Pair) -> Option<Pair> {
    let Analysis { system, kinematics, motion, .. } = &pair.analysis;
    let tree = Tree::of(&Scene { system, kinematics }, motion)?;
    let functions = Functions::of_tree(system, kinematics, motion, &tree);
    Some(Pair { analysis: Analysis { functions, ..pair.analysis.clone() }, ..pair })
}

/// Points, energies, gaps, joint forces and momenta, M and f with a random contact set, and the free accelerations.
fn trees(seeds: core::ops::Range<u64>, vocabulary: Vocabulary) -> [usize; 2] {
    let (mut compared, mut free) = (0, 0);
    for seed in seeds {
        let Some(pair) = by_recursion(Pair::without_phases(seed, vocabulary)) else { continue };
        let mut source = Source::new(seed ^ 0x7e3e);
        let Some(state) = pair.sample.state(&mut source) else { continue };
        pair.positions(&state);
        pair.energies(&state);
        pair.gaps(&state);
        let sets = 1 << pair.analysis.motion.contacts.len();
        let touching = pair.touching(&state, source.below(sets) as u64);
        compared += usize::from(touching.is_some_and(|state| pair.kernel(&state, 0)));
        free += usize::from(pair.closed_form(&pair.analysis.functions.phases[0], &state));
    }
    [compared, free]
}

#[test]
fn bars() {
    let [compared, free] = trees(0..2000, Vocabulary::BARS);
    assert!(compared >= 100 && free >= 100, "{compared}, {free} free");
}

#[test]
fn vocabulary() {
    let [compared, free] = trees(0..2000, Vocabulary::ALL);
    assert!(compared >= 100 && free >= 100, "{compared}, {free} free");
}
