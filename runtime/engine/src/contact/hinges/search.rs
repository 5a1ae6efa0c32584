//! Motions that satisfy the law: all of them, or with many hinges at rest one for each combination
//! of the other contacts.

use super::choices::{HingeChoice, Options};
use super::place::{HingeCandidate, HingeProblem};
use super::policy;

/// The motions of all combinations.
pub(super) fn all(place: &HingeProblem, options: &[Options]) -> Vec<HingeCandidate> {
    let lawful = |choice| place.answer(choice).filter(|found| place.is_lawful(found));
    combinations(options).filter_map(lawful).collect()
}

/// Motions whose hinges at rest have been [improved](policy::improve) until all obey; nothing where
/// some combination of the other contacts may have motions that this does not find, where these are
/// more than `most`, or where a motion does not last.
pub(super) fn improved(
    place: &HingeProblem,
    options: &[Options],
    most: usize,
) -> Option<Vec<HingeCandidate>> {
    let rests = |it: &&Options| place.context.layout().contacts[it.0].is_hinge() && it.1.len() > 1;
    let (hinges, others): (Vec<&Options>, Vec<&Options>) = options.iter().partition(rests);
    let others: Vec<Options> = others.into_iter().cloned().collect();
    if super::trials(&others).is_none_or(|count| count > most) {
        return None;
    }
    let obeying = |choice: Vec<(usize, HingeChoice)>| {
        policy::improve(hinges.len(), |senses| {
            let rubbing = hinges.iter().zip(senses).map(|(it, sense)| (it.0, HingeChoice::of_hinge(*sense)));
            let found = place.answer(choice.iter().copied().chain(rubbing).collect())?;
            let next = hinges.iter().zip(senses).map(|(it, sense)| place.obeyed(&found, it.0, *sense));
            let next = next.collect();
            Some((found, next))
        })
    };
    let found: Option<Vec<HingeCandidate>> = combinations(&others).map(obeying).collect();
    let found: Vec<HingeCandidate> = found?.into_iter().filter(|it| place.is_lawful(it)).collect();
    let lasts = !found.is_empty() && found.iter().all(|it| place.lasts(it));
    lasts.then_some(found)
}

/// A choice of each contact, the first ones vary fastest.
fn combinations(options: &[Options]) -> impl Iterator<Item = Vec<(usize, HingeChoice)>> {
    let mut next = Some(vec![0; options.len()]);
    core::iter::from_fn(move || {
        let chosen = next.take()?;
        let choice = options.iter().zip(&chosen).map(|((contact, of), &k)| (*contact, of[k])).collect();
        let place = (0..options.len()).find(|&k| chosen[k] + 1 < options[k].1.len());
        next = place.map(|place| {
            let mut following: Vec<usize> = chosen;
            following[place] += 1;
            following[..place].fill(0);
            following
        });
        Some(choice)
    })
}
