//! All contact sets, each from the figure that is given.

use core::f64::consts::{FRAC_PI_2, TAU};

use liftoff_core::model::{ContactSet, Coordinate};
use liftoff_core::scalar::{DoubleDouble, Real};

use super::Equilibrium;
use super::bearing::loads;
use super::newton::equilibrium;
use crate::local::Local;
use crate::{AnalysisError, Linearisation, Subject};

/// Of so many contacts all subsets are tried.
const ALL: usize = 8;
/// Of so many angles all combinations of quarter turns are tried.
const TURNED: usize = 3;
/// Equilibria nearer to each other, in natural units, are one.
const SAME: f64 = 1e-8;
/// How deep an open contact may be penetrated, in natural lengths.
const DEEP: f64 = 1e-9;

/// The equilibria that are found from the position of the subject: of all subsets of up to eight
/// contacts, else of those that touch there and of their subsets without one. The nearest is the
/// first; angles are between −π and π where whole turns make no difference. Of a model without
/// contacts and loops, and where nothing is found, they are looked for from that position with
/// angles turned by quarters too.
///
/// # Errors
/// None is found, or there can be none.
pub fn equilibria(subject: &Subject) -> Result<Vec<Equilibrium>, AnalysisError> {
    subject.refuse_unsuited()?;
    let sets = sets(subject);
    let mut found: Vec<Equilibrium> = Vec::new();
    let is_free = subject.layout().contacts.is_empty() && subject.layout().joints.is_empty();
    for start in turned(subject) {
        for set in &sets {
            let Some(state) = equilibrium(subject, *set, &start, 1.0) else { continue };
            let state = without_turns(subject, *set, state);
            if !is_possible(subject, &state) || found.iter().any(|known| is_same(subject, known, &state)) {
                continue;
            }
            found.extend(described(subject, &state)?);
        }
        if !is_free && !found.is_empty() {
            break;
        }
    }
    found.sort_by(|one, other| distance(subject, one).total_cmp(&distance(subject, other)));
    if found.is_empty() { Err(AnalysisError::NotFound { tried: sets.len() }) } else { Ok(found) }
}

/// The position of the subject; then it with its angles turned by quarters, all combinations of up
/// to three of them, else each alone.
fn turned(subject: &Subject) -> impl Iterator<Item = Vec<DoubleDouble>> {
    let coordinates = subject.layout().coordinates.iter().enumerate();
    let angles: Vec<usize> = coordinates.filter(|(_, c)| c.is_angle).map(|(i, _)| i).collect();
    let count = angles.len();
    let (turns, all) =
        if count <= TURNED { (4_usize.pow(count as u32), true) } else { (1 + 3 * count, false) };
    let quarters = move |turn: usize, k: usize| match turn.checked_sub(1) {
        _ if all => turn >> (2 * k) & 3,
        Some(other) if other / 3 == k => 1 + other % 3,
        _ => 0,
    };
    (0..turns).map(move |turn| {
        let mut state = subject.state.clone();
        for (k, &i) in angles.iter().enumerate() {
            // Up to half a turn in either direction.
            let quarters = [0.0, 1.0, -1.0, 2.0][quarters(turn, k)];
            state[i] = state[i] + DoubleDouble::from_f64(quarters * FRAC_PI_2);
        }
        state
    })
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
        beyond || gaps[i] >= -DEEP * subject.layout().unit(i, subject.scales.length)
    })
}

/// The same position with angles between −π and π, unless it is no equilibrium there, as with a
/// torsion spring.
fn without_turns(subject: &Subject, set: ContactSet, state: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
    let coordinates = subject.layout().coordinates;
    let turned = |(coordinate, q): (&Coordinate, &DoubleDouble)| match coordinate.is_angle {
        // Half a turn is π, whatever the rounding.
        true => *q - DoubleDouble::from_f64(TAU * (q.hi() / TAU - 0.5 - SAME).ceil()),
        false => *q,
    };
    let mut moved = state.clone();
    let positions: Vec<_> = coordinates.iter().zip(&state).map(turned).collect();
    moved[..positions.len()].copy_from_slice(&positions);
    let is_near = |found: &Vec<DoubleDouble>| {
        let mut entries = coordinates.iter().zip(found.iter().zip(&moved));
        entries.all(|(coordinate, (a, b))| {
            (*a - *b).hi().abs() <= SAME * subject.scales.coordinate(coordinate).max(a.hi().abs())
        })
    };
    equilibrium(subject, set, &moved, 1.0).filter(is_near).unwrap_or(state)
}

/// How far a value of a coordinate is from another; whole turns of an angle do not count.
fn difference(coordinate: &Coordinate, a: f64, b: f64) -> f64 {
    let apart = a - b;
    if coordinate.is_angle { apart - TAU * (apart / TAU).round() } else { apart }
}

/// How far it is from the position of the subject, in natural units; whole turns do not count.
fn distance(subject: &Subject, found: &Equilibrium) -> f64 {
    let entries = subject.layout().coordinates.iter().zip(found.positions.iter().zip(&subject.state));
    let parts = entries.map(|(coordinate, (a, b))| {
        (difference(coordinate, *a, b.hi()) / subject.scales.coordinate(coordinate)).powi(2)
    });
    parts.sum()
}

/// Whether positions differ by whole turns at most.
fn is_same(subject: &Subject, known: &Equilibrium, state: &[DoubleDouble]) -> bool {
    let mut entries = subject.layout().coordinates.iter().zip(known.positions.iter().zip(state));
    entries.all(|(coordinate, (a, b))| {
        difference(coordinate, *a, b.hi()).abs() <= SAME * subject.scales.coordinate(coordinate).max(a.abs())
    })
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
    let Some((loads, joint_forces)) = loads(subject, touching, state) else { return Ok(None) };
    let idle = touching.iter().zip(&loads).filter(|(_, load)| !load.bears).map(|(i, _)| i);
    let bearing = touching.difference(idle.collect()).union(layout.guides());
    let local = Local::new(subject, subject.sticking(bearing), state)?;
    Ok(Some(Equilibrium {
        closed: touching.iter().flat_map(|i| layout.contacts[i].supports).copied().collect(),
        positions: positions(subject, state),
        loads,
        joint_forces,
        linear: Linearisation::from_local(subject, &local),
        time: subject.scales.time,
        coordinates: layout.coordinates,
    }))
}
