//! Random trees by recursion over their bodies, written out entry by entry, and by the oracle.

use crate::pair::Pair;
use liftoff_codegen::Analysis;
use liftoff_codegen::functions::{Functions, JointSolution, Mass, recursion};
use liftoff_codegen::motion::{Scene, Tree};
use liftoff_codegen::program::Factored;
use liftoff_tests::random::{Source, Vocabulary};

/// The same system, its functions by recursion; `None` for what is no tree from fixed points.
fn by_recursion(pair: Pair) -> Option<Pair> {
    let Analysis { system, kinematics, motion, .. } = &pair.analysis;
    let tree = Tree::of(&Scene { system, kinematics }, motion)?;
    if !(tree.bases.is_empty() && kinematics.joints.is_empty()) {
        return None;
    }
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

/// Accelerations without contacts of every system that a tree underlies, with free points and joints, from the leaves
/// and by entries; how many of each were compared, and how many had joints.
fn held(seeds: core::ops::Range<u64>, vocabulary: Vocabulary) -> [usize; 2] {
    let mut compared = [0; 2];
    for seed in seeds {
        let pair = Pair::without_phases(seed, vocabulary);
        let mut source = Source::new(seed ^ 0x4e1d);
        let Some(state) = pair.sample.state(&mut source) else { continue };
        let Analysis { system, kinematics, motion, functions, .. } = &pair.analysis;
        let Some(tree) = &motion.tree else { continue };
        let joints = motion.contacts.len()..motion.rows.len() - motion.tangents.len();
        let (rows, bias) =
            (&functions.kernel.jacobian[joints.clone()], &functions.kernel.bias[joints.clone()]);
        let mut program = functions.program.clone();
        let from_leaves = recursion(&mut program, system, kinematics, motion, tree, rows);
        let Mass::Entries(mass) = &functions.kernel.mass else { panic!("a small system") };
        let factored = Factored::of(&mut program, mass);
        let forces = core::iter::once(&functions.kernel.force).chain(rows);
        let by_entries: Vec<_> = forces.map(|force| factored.solve(&mut program, force)).collect();
        let both = [from_leaves, by_entries].map(|free| JointSolution::of(&mut program, &free, rows, bias));
        let functions = Functions { program, ..functions.clone() };
        let pair = Pair { analysis: Analysis { functions, ..pair.analysis.clone() }, ..pair };
        let agree = both.iter().filter(|held| pair.held(held, &state)).count();
        compared[0] += agree;
        compared[1] += if joints.is_empty() { 0 } else { agree };
    }
    compared
}

#[test]
fn joints() {
    let [compared, with_joints] = held(0..600, Vocabulary::BARS);
    assert!(compared >= 700 && with_joints >= 60, "{compared}, {with_joints} with joints");
}

#[test]
fn joints_of_the_whole_vocabulary() {
    let [compared, with_joints] = held(0..600, Vocabulary::ALL);
    assert!(compared >= 280 && with_joints >= 140, "{compared}, {with_joints} with joints");
}

#[test]
fn bars() {
    let [compared, free] = trees(0..800, Vocabulary::BARS);
    assert!(compared >= 100 && free >= 100, "{compared}, {free} free");
}

#[test]
fn vocabulary() {
    let [compared, free] = trees(0..800, Vocabulary::ALL);
    assert!(compared >= 30 && free >= 30, "{compared}, {free} free");
}
