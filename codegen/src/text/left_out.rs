//! What a scene does not have, and its code hence does not contain.

use crate::Analysis;
use crate::algebra::Series;
use crate::motion::Dense;
use crate::phases::Phase;

/// A sentence for each thing left out, each read off the analysis that the code is made from.
pub(super) fn describe_omissions(analysis: &Analysis, dense: &Dense, phases: &[Phase]) -> Vec<String> {
    let mut all = Vec::new();
    mass_and_loads(analysis, &mut all);
    contacts(analysis, phases, &mut all);
    entries(dense, &mut all);
    all
}

fn mass_and_loads(analysis: &Analysis, all: &mut Vec<String>) {
    let Analysis { system, kinematics, motion, .. } = analysis;
    let mut absent = |absent: bool, text: &str| {
        if absent {
            all.push(text.to_owned());
        }
    };
    absent(system.gravity.is_none(), "No gravity: no weight in V or Q.");
    let driven = system.springs.iter().map(|s| &s.damping).chain(system.torsions.iter().map(|t| &t.damping));
    let damped = driven.flatten().next().is_some();
    let loaded = !motion.loads.actions.is_empty();
    absent(!loaded && system.gravity.is_some(), "No springs, dampers, forces or couples: Q is weight alone.");
    absent(!loaded && system.gravity.is_none(), "No springs, dampers, forces or couples: Q vanishes.");
    absent(loaded && !damped, "No dampers.");
    absent(!motion.is_timed(), "Nothing depends on time: it is no part of the state.");
    absent(
        kinematics.joints.is_empty(),
        "No constraint is left over: no multipliers of joints, nothing to drift.",
    );
    if system.mirror.is_some() {
        let images = system.bodies.len();
        let text = "Mirror symmetry: of each pair of images only one is computed";
        all.push(format!("{text}; {images} bodies move by {} coordinates.", motion.n));
    }
}

fn contacts(analysis: &Analysis, phases: &[Phase], all: &mut Vec<String>) {
    let Analysis { system, motion, .. } = analysis;
    if motion.contacts.is_empty() {
        all.push("No one-sided contacts: no gaps, no reactions, no impacts, one phase.".to_owned());
        return;
    }
    if motion.tangents.is_empty() {
        all.push("No contact is rough: no tangential rows.".to_owned());
    }
    let supports = motion.contacts.iter().map(|contact| contact.support(system));
    if supports.clone().all(|support| support.restitution.is_none()) {
        all.push("No restitution: impacts are plastic, no coefficients.".to_owned());
    }
    let sets = 1_u128.checked_shl(motion.contacts.len() as u32).unwrap_or(u128::MAX);
    let own = phases.len() as u128;
    if own < sets {
        let text =
            "contact sets have code of their own; the others share the full equations with multipliers";
        all.push(format!("{own} of {sets} {text}."));
    }
}

fn entries(dense: &Dense, all: &mut Vec<String>) {
    let n = dense.mass.len();
    let below = (0..n).flat_map(|i| dense.mass[i][..=i].iter());
    let mut vanishing = |name: &str, zero: usize, of: usize| {
        if zero > 0 {
            let verb = if zero == 1 { "vanishes" } else { "vanish" };
            all.push(format!("{zero} of {of} entries of {name} {verb}."));
        }
    };
    let zeros = |entries: &mut dyn Iterator<Item = &Series>| entries.filter(|entry| entry.is_zero()).count();
    vanishing("the lower triangle of M", zeros(&mut below.clone()), n * (n + 1) / 2);
    vanishing("h", zeros(&mut dense.velocity_terms.iter()), n);
    vanishing("Q", zeros(&mut dense.forces.iter()), n);
}
