//! All contact sets, each from the figure that is given.

use liftoff::model::ContactSet;
use liftoff::scalar::DoubleDouble;

use super::Equilibrium;
use super::bearing::loads;
use super::newton::equilibrium;
use crate::local::Local;
use crate::{AnalysisError, Linearisation, Subject};

/// Of so many contacts all subsets are tried.
const ALL: usize = 8;
/// Equilibria nearer to each other, in natural units, are one.
const SAME: f64 = 1e-8;
/// How deep an open contact may be penetrated, in natural lengths.
const DEEP: f64 = 1e-9;

/// The equilibria that are found from the position of the subject: of all subsets of up to eight contacts, else of those that touch
/// there and of their subsets without one.
///
/// # Errors
/// None is found, or there can be none.
pub fn equilibria(subject: &Subject) -> Result<Vec<Equilibrium>, AnalysisError> {
    subject.refuse_unsuited()?;
    let sets = sets(subject);
    let mut found: Vec<Equilibrium> = Vec::new();
    for set in &sets {
        let Some(state) = equilibrium(subject, *set, &subject.state) else { continue };
        if !is_possible(subject, &state) || found.iter().any(|known| is_same(subject, known, &state)) {
            continue;
        }
        found.extend(described(subject, &state)?);
    }
    if found.is_empty() { Err(AnalysisError::NotFound { tried: sets.len() }) } else { Ok(found) }
}

fn sets(subject: &Subject) -> Vec<ContactSet> {
    let (candidates, guides) = (subject.candidates(), subject.layout().guides());
    let of = |chosen: ContactSet| subject.sticking(chosen.union(guides));
    if candidates.len() <= ALL {
        let subset = |bits: usize| -> ContactSet {
            let chosen = candidates.iter().enumerate().filter(|(k, _)| bits >> k & 1 == 1);
            chosen.map(|(_, &contact)| contact).collect()
        };
        return (0..1_usize << candidates.len()).map(|bits| of(subset(bits))).collect();
    }
    let touching = subject.touching();
    let fewer = candidates.iter().filter(|&&i| touching.contains(i)).map(|&i| touching.without(i));
    [touching].into_iter().chain(fewer).map(of).collect()
}

/// Whether no contact is penetrated.
pub(super) fn is_possible(subject: &Subject, state: &[DoubleDouble]) -> bool {
    let gaps = subject.gaps(state);
    let feet = subject.feet(state);
    let bound = DEEP * subject.scales.length;
    subject.candidates().into_iter().all(|i| {
        let foot = subject.layout().contacts[i].foot;
        let beyond = foot.is_some_and(|k| feet[2 * k..2 * k + 2].iter().any(|margin| *margin < -bound));
        beyond || gaps[i] >= -bound
    })
}

fn is_same(subject: &Subject, known: &Equilibrium, state: &[DoubleDouble]) -> bool {
    let units = subject.layout().coordinates.iter().map(|c| subject.scales.coordinate(c));
    let mut entries = known.positions.iter().zip(state).zip(units);
    entries.all(|((a, b), unit)| (a - b.hi()).abs() <= SAME * unit.max(a.abs()))
}

/// All coordinates, zero where they are less than a rounding of their unit.
fn positions(subject: &Subject, state: &[DoubleDouble]) -> Vec<f64> {
    let units = subject.layout().coordinates.iter().map(|c| subject.scales.coordinate(c));
    units.zip(state).map(|(unit, q)| if q.hi().abs() < f64::EPSILON * unit { 0.0 } else { q.hi() }).collect()
}

/// An equilibrium with what its contacts bear; none if they cannot hold it.
pub(super) fn described(
    subject: &Subject,
    state: &[DoubleDouble],
) -> Result<Option<Equilibrium>, AnalysisError> {
    let layout = subject.layout();
    let touching = subject.touching_at(state);
    let Some(loads) = loads(subject, touching, state) else { return Ok(None) };
    let idle = touching.iter().zip(&loads).filter(|(_, load)| !load.bears).map(|(i, _)| i);
    let bearing = touching.difference(idle.collect()).union(layout.guides());
    let local = Local::of(subject, subject.sticking(bearing), state)?;
    Ok(Some(Equilibrium {
        closed: touching.iter().flat_map(|i| layout.contacts[i].supports).copied().collect(),
        positions: positions(subject, state),
        loads,
        linear: Linearisation::at(subject, &local),
        time: subject.scales.time,
        coordinates: layout.coordinates,
    }))
}
