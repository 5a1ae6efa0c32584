//! From a partial pose to a consistent full state.

mod complete;
mod energy;
mod pose;
mod problem;
mod rates;
mod settle;

pub(crate) use energy::on_energy_of;
pub use pose::Pose;

use crate::error::StartError;
use crate::integration::phase_point::RunContext;
use crate::model::ContactSet;
use problem::AssemblyProblem;
use settle::settled;

/// A gap below this, relative to the natural length, is closed; a rate likewise, relative to the natural speed.
/// Poses are typed in or printed with ten digits.
pub(crate) const CLOSED: f64 = 1e-10;

/// A consistent start.
#[derive(Clone)]
pub(crate) struct Start {
    pub(crate) state: Vec<f64>,
    /// Contacts with g = 0 and ġ = 0.
    pub(crate) touching: ContactSet,
}

/// The full state that `pose` asks for; what it leaves open follows from the contacts of the nominal figure.
pub(crate) fn start(context: &RunContext, pose: &Pose) -> Result<Start, StartError> {
    let assembly = AssemblyProblem { context };
    let given = pose.resolve(context.layout())?;
    let (positions, closed) = complete::positions(&assembly, &given.positions)?;
    let (rates, touching) = rates::rates(&assembly, &positions, closed, &given.rates)?;
    let state = context.layout().state_at(&[positions, rates].concat(), 0.0);
    let state = settled(context, touching, &state, &given).unwrap_or(state);
    assembly.refuse_feet_off_bars(&state, touching)?;
    Ok(Start { state, touching })
}

/// Subsets tried at most: all of a set of twelve, of a larger one those that leave out few.
const SUBSETS: usize = 1 << 12;

/// Subsets of a set, the larger first, equal sizes in ascending order.
fn subsets(set: ContactSet) -> impl Iterator<Item = ContactSet> {
    let members: Vec<usize> = set.iter().collect();
    let sizes = 0..=members.len();
    let left_out = sizes.flat_map(move |count| choices(members.clone(), count));
    left_out.take(SUBSETS).map(move |left_out| set.difference(left_out))
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
    use super::subsets;
    use crate::model::ContactSet;

    #[test]
    fn larger_subsets_come_first() {
        let bits: Vec<_> = subsets(ContactSet::from_bits(0b1101)).map(|set| set.bits().unwrap()).collect();
        assert_eq!(bits, [0b1101, 0b0101, 0b1001, 0b1100, 0b0001, 0b0100, 0b1000, 0]);
        assert_eq!(subsets((0..200).collect()).take(202).map(ContactSet::len).min(), Some(198));
    }
}
