//! Names of the contact sets that have code of their own.

use crate::Analysis;
use crate::motion::{ClosedSet, contains};

/// A name for each closed form, then for each motion that is held without one, no two alike:
/// `On_A_and_E`, `On_sliding_A`, `Free`.
pub(crate) fn phase_names(analysis: &Analysis) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let (phases, held) = (&analysis.functions.phases, &analysis.functions.held);
    for set in phases.iter().map(|phase| phase.set).chain(held.iter().map(|motion| motion.set)) {
        let name = name(analysis, set);
        let taken = names.contains(&name);
        let ClosedSet { closed, stick } = set;
        names.push(if taken { format!("{name}_{closed}_{stick}") } else { name });
    }
    names
}

fn name(analysis: &Analysis, set: ClosedSet) -> String {
    let labels: Vec<String> = analysis
        .motion
        .contacts
        .iter()
        .enumerate()
        .filter(|(i, _)| contains(set.closed, *i))
        .map(|(i, contact)| {
            let label = contact.word(&analysis.system);
            match contact.friction {
                None => label,
                Some(_) if contains(set.stick, i) => format!("sticking_{label}"),
                Some(_) => format!("sliding_{label}"),
            }
        })
        .collect();
    if labels.is_empty() { "Free".to_owned() } else { format!("On_{}", labels.join("_and_")) }
}
