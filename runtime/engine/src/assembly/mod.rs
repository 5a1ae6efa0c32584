//! From a partial pose to a consistent full state.

mod complete;
mod energy;
mod error;
mod fold;
mod path;
mod pose;
mod problem;
mod rates;
mod settle;

pub(crate) use energy::on_energy_of;
pub use error::StartError;
pub use pose::Pose;

use crate::context::{CLOSED, RunContext};
use crate::expression::Switches;
use crate::integration::chart;
use crate::model::{ContactSet, Joint};
use crate::numerics::decomposition::singular_values;
use crate::numerics::zero::{MARGIN, compute_place_error};
use crate::system::Equations;
use pose::GivenPose;
use problem::AssemblyProblem;
use settle::settled;

/// How deep contacts may be penetrated at a start, in natural lengths: ten local errors, as deep as
/// events leave them, so that a motion can be continued from its states. A contact that is
/// penetrated counts as closed. Onto it the pose moves by as much, and by the square root of that
/// where the gap has a fold.
pub(crate) fn deepest(tolerance: f64) -> f64 {
    compute_place_error(tolerance).max(CLOSED)
}

/// Whether a contact is penetrated and open by no more than so many of its units, or than the
/// rounding of its gap.
pub(crate) fn touches(
    context: &RunContext,
    equations: &Equations<f64>,
    (contact, positions): (usize, &[f64]),
    [deep, high]: [f64; 2],
) -> bool {
    let gap = equations.gap()[contact] / context.layout().unit(contact, context.scales.length);
    let rounding = context.rounding(equations, contact, positions);
    (-deep.max(rounding)..=high.max(rounding)).contains(&gap)
}

/// A consistent start.
#[derive(Clone)]
pub(crate) struct ConsistentStart {
    pub(crate) state: Vec<f64>,
    /// Contacts with g = 0 and ġ = 0.
    pub(crate) touching: ContactSet,
    /// How deep the pose that was asked for penetrates its contacts, m, ≥ 0.
    pub(crate) depth: f64,
}

/// The full state that `pose` asks for at a time; what it leaves open follows from the contacts of
/// the nominal figure.
pub(crate) fn start(
    (context, switches): (&RunContext, &Switches),
    pose: &Pose,
    tolerance: f64,
    t: f64,
) -> Result<ConsistentStart, StartError> {
    let given = pose.resolve(&context.model)?;
    refuse_lost_units(context)?;
    if let Some(state) = unbound((context, switches), &given, t) {
        return Ok(ConsistentStart { state, touching: ContactSet::EMPTY, depth: 0.0 });
    }
    let rates = given.rates.iter().map(|rate| rate.unwrap_or(0.0)).collect();
    let assembly = AssemblyProblem::new((context, switches), deepest(tolerance), (rates, given.below), t);
    let (positions, closed) = complete::positions(&assembly, &given.positions)?;
    assembly.check_below(&positions)?;
    refuse_immobile(&assembly, &positions)?;
    let depth = assembly.depth(&positions, closed);
    let moving = |positions: &[f64]| -> Result<_, StartError> {
        let (rates, touching) = rates::rates(&assembly, positions, closed, &given.rates)?;
        let mut state = context.layout().state_at(&[positions, &rates[..]].concat(), t);
        switches.set(context, &mut state, t);
        let touching = touching.difference(switches.disarmed(context, &state, t));
        Ok((state, touching))
    };
    let (state, touching) = moving(&positions)?;
    let state = settled(context, touching, &state, &given).unwrap_or(state);
    let (state, touching) = match lifted(&assembly, &state, (touching, closed.difference(touching)))? {
        Some(positions) => moving(&positions)?,
        None => (state, touching),
    };
    assembly.refuse_feet_off_bars(&state, touching)?;
    Ok(ConsistentStart { state, touching, depth })
}

/// The contacts that a start in this state must say to be below their edges, `below(P)` = 1.
pub(crate) fn find_below(
    (context, switches): (&RunContext, &Switches),
    tolerance: f64,
    state: &[f64],
    t: f64,
) -> ContactSet {
    let layout = context.layout();
    let edges = layout.edges();
    if edges.is_empty() {
        return edges;
    }
    let n = layout.coordinates.len();
    let (positions, rates) = (&state[..n], state[n..2 * n].to_vec());
    let below = (rates, ContactSet::EMPTY);
    let assembly = AssemblyProblem::new((context, switches), deepest(tolerance), below, t);
    assembly.find_penetrated(positions, assembly.absent(positions)).intersection(edges)
}

/// The state of a model that has neither contacts nor joints, where all rates or none are given: it
/// is as it was asked for.
fn unbound((context, switches): (&RunContext, &Switches), given: &GivenPose, t: f64) -> Option<Vec<f64>> {
    let (layout, nominal) = (context.layout(), &context.model.nominal);
    let any = given.rates.iter().any(Option::is_some);
    if layout.rows() > 0 || any && !given.rates.iter().all(Option::is_some) {
        return None;
    }
    let positions = given.positions.iter().zip(nominal).map(|(given, nominal)| given.unwrap_or(*nominal));
    let values: Vec<f64> = positions.chain(given.rates.iter().map(|rate| rate.unwrap_or(0.0))).collect();
    let mut state = layout.state_at(&values, t);
    switches.set(context, &mut state, t);
    Some(state)
}

/// Refuses units in which natural forces or energies are no normal numbers: squares of rates would
/// be lost.
fn refuse_lost_units(context: &RunContext) -> Result<(), StartError> {
    let scales = &context.scales;
    let (acceleration, force) = (scales.acceleration(), scales.force());
    let natural = [acceleration, force, force * scales.length];
    match natural.iter().all(|value| value.is_normal()) {
        true => Ok(()),
        false => Err(StartError::Units { length: scales.length, time: scales.time, mass: scales.mass }),
    }
}

/// Refuses a position in which joints alone hold all coordinates.
fn refuse_immobile(assembly: &AssemblyProblem<'_>, positions: &[f64]) -> Result<(), StartError> {
    let (layout, all) = (assembly.layout(), (0..positions.len()).collect::<Vec<_>>());
    let joints = assembly.closed(ContactSet::EMPTY);
    if joints.len() < all.len() || layout.joints.iter().any(Joint::is_drive) {
        return Ok(());
    }
    let values = singular_values(assembly.jacobian(positions, (&joints, &all)));
    match values.iter().all(|value| *value > MARGIN * values[0]) {
        true => Err(StartError::Immobile { coordinates: all.len(), constraints: joints.len() }),
        false => Ok(()),
    }
}

/// Positions with g = 0 at contacts that open at once and are penetrated within their bound: below
/// it nothing tells that they close again.
///
/// # Errors
/// They are farther away than what penetrates by that much may be moved: bars may be as thin as it
/// is deep.
fn lifted(
    assembly: &AssemblyProblem<'_>,
    state: &[f64],
    (touching, departing): (ContactSet, ContactSet),
) -> Result<Option<Vec<f64>>, StartError> {
    let context = assembly.context;
    let gaps = context.gaps(state);
    let below: ContactSet = departing.iter().filter(|&i| gaps[i] < 0.0).collect();
    let Some(deepest) = below.iter().min_by(|&a, &b| gaps[a].total_cmp(&gaps[b])) else { return Ok(None) };
    let mut lifted = state.to_vec();
    context.system().project(touching.union(below), &mut lifted, context.scales.length);
    let [by, _] = chart::apart(context, state, &lifted);
    if by > assembly.deepest.sqrt() {
        return Err(assembly.penetration(deepest, gaps[deepest]));
    }
    lifted.truncate(context.layout().coordinates.len());
    Ok(by.is_finite().then_some(lifted))
}

/// Of a set of so many contacts all subsets are tried.
const ALL: usize = 12;

/// What the first subset is that is accepted: of a small set among all, the larger first; of a
/// large one among those left when the contacts that are in the way of the one before are left out.
fn largest<T>(set: ContactSet, mut accept: impl FnMut(ContactSet) -> Result<T, ContactSet>) -> Option<T> {
    let mut left = set;
    loop {
        match accept(left) {
            Ok(found) => return Some(found),
            Err(_) if left.is_empty() => return None,
            Err(_) if set.len() <= ALL => {
                return subsets(set).skip(1).find_map(|subset| accept(subset).ok());
            }
            Err(in_the_way) => {
                let fewer = left.difference(in_the_way);
                left = if fewer == left { ContactSet::EMPTY } else { fewer };
            }
        }
    }
}

/// The contacts of a set that miss by more than `accepted`, those by far the least left out.
fn worst(set: ContactSet, missed: impl Fn(usize) -> f64, accepted: f64) -> ContactSet {
    let most = set.iter().map(&missed).fold(accepted, f64::max);
    set.iter().filter(|&i| missed(i) > accepted && missed(i) >= 0.5 * most).collect()
}

/// Subsets of a set, the larger first, equal sizes in ascending order.
fn subsets(set: ContactSet) -> impl Iterator<Item = ContactSet> {
    let members: Vec<usize> = set.iter().collect();
    let left_out = (0..=members.len()).flat_map(move |count| choices(members.clone(), count));
    left_out.map(move |left_out| set.difference(left_out))
}

/// Choices of so many members, those of the last ones first.
fn choices(members: Vec<usize>, count: usize) -> Box<dyn Iterator<Item = ContactSet>> {
    if count == 0 {
        return Box::new(core::iter::once(ContactSet::EMPTY));
    }
    let last = (0..members.len()).rev();
    Box::new(last.flat_map(move |k| {
        let chosen = members[k];
        choices(members[..k].to_vec(), count - 1).map(move |others| others.with(chosen))
    }))
}

#[cfg(test)]
mod tests {
    use super::{largest, subsets, worst};
    use crate::model::ContactSet;

    #[test]
    fn larger_subsets_come_first() {
        let bits: Vec<_> = subsets(ContactSet::from_bits(0b1101)).map(|set| set.bits().unwrap()).collect();
        assert_eq!(bits, [0b1101, 0b0101, 0b1001, 0b1100, 0b0001, 0b0100, 0b1000, 0]);
    }

    /// Of a hundred contacts that miss by 0, 1, 2, … those that miss are left out, the worst half
    /// first.
    #[test]
    fn of_many_contacts_those_in_the_way_are_left_out() {
        let accept = |set: ContactSet| {
            let in_the_way = worst(set, |i| i as f64, 2.5);
            if in_the_way.is_empty() { Ok(set) } else { Err(in_the_way) }
        };
        assert_eq!(largest((0..100).collect(), accept), Some(ContactSet::from_bits(0b111)));
    }
}
