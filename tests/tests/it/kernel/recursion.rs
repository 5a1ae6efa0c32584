//! Random trees by recursion over their bodies, written out entry by entry, and by the oracle.

use super::pair::Pair;
use liftoff_codegen::Analysis;
use liftoff_codegen::functions::{Functions, HeldSolution, Mass, recursion};
use liftoff_codegen::motion::{Scene, Tree};
use liftoff_tests::random::{Source, Vocabulary};

/// The same system, its functions by recursion; `None` for what is no tree from fixed points.
fn by_recursion(pair: Pair) -> Option<Pair> {
    let Analysis { system, kinematics, motion, .. } = &pair.analysis;
    let tree = Tree::recognise(&Scene { system, kinematics }, motion)?;
    if !(tree.bases.is_empty() && kinematics.joints.is_empty()) {
        return None;
    }
    let functions = Functions::of_tree(system, kinematics, motion, &tree);
    Some(Pair { analysis: Analysis { functions, ..pair.analysis.clone() }, ..pair })
}

/// Points, energies, gaps, joint forces and momenta, M and f with a random contact set, and the
/// free accelerations.
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

/// Motions that joints and random contacts hold, of every system that a tree underlies, with free
/// points and joints, from the leaves and by entries; how many of each were compared, how many had
/// joints, and how many had contacts.
fn held(seeds: core::ops::Range<u64>, vocabulary: Vocabulary) -> [usize; 3] {
    let mut compared = [0; 3];
    for seed in seeds {
        let pair = Pair::without_phases(seed, vocabulary);
        let mut source = Source::new(seed ^ 0x4e1d);
        let Some(state) = pair.sample.state(&mut source) else { continue };
        let motion = &pair.analysis.motion;
        let (joints, sets) = (motion.slips() - motion.contacts.len(), 1 << motion.contacts.len());
        for set in [0, source.below(sets) as u64] {
            let Some(state) = pair.touching(&state, set) else { continue };
            let agree = both(&pair, set).map_or(0, |(pair, both)| {
                both.iter().filter(|solution| pair.held(solution, set, &state)).count()
            });
            compared[0] += agree;
            compared[1] += if joints == 0 { 0 } else { agree };
            compared[2] += if set == 0 { 0 } else { agree };
        }
    }
    compared
}

/// The solutions from the leaves and by entries with the rows that are closed in a set.
fn both(pair: &Pair, set: u64) -> Option<(Pair, [HeldSolution; 2])> {
    let Analysis { system, kinematics, motion, functions, .. } = &pair.analysis;
    let (kernel, mut program) = (&functions.kernel, functions.program.clone());
    let rows = pair.rows(set);
    let jacobian: Vec<_> = rows.iter().map(|&row| kernel.jacobian[row].clone()).collect();
    let bias: Vec<_> = rows.iter().map(|&row| kernel.bias[row]).collect();
    let free = recursion(&mut program, system, kinematics, motion, motion.tree.as_ref()?, &jacobian);
    let from_leaves = HeldSolution::from_free(&mut program, &free, &jacobian, &bias);
    let Mass::Entries(mass) = &kernel.mass else { panic!("a small system") };
    let by_entries = HeldSolution::by_entries(&mut program, mass, &kernel.force, &jacobian, &bias);
    let functions = Functions { program, ..functions.clone() };
    let analysis = Analysis { functions, ..pair.analysis.clone() };
    Some((
        Pair { analysis, sample: pair.sample.clone(), parameters: pair.parameters.clone(), ..*pair },
        [from_leaves, by_entries],
    ))
}

#[test]
fn held_bars() {
    let [compared, joints, contacts] = held(0..600, Vocabulary::BARS);
    assert!(compared >= 700 && joints >= 60 && contacts >= 200, "{compared}, {joints}, {contacts}");
}

#[test]
fn held_systems_of_the_whole_vocabulary() {
    let [compared, joints, contacts] = held(0..600, Vocabulary::ALL);
    assert!(compared >= 280 && joints >= 140 && contacts >= 80, "{compared}, {joints}, {contacts}");
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
