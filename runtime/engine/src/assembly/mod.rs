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

/// Subsets of a set, the larger first, equal sizes in ascending order.
fn subsets(set: ContactSet) -> Vec<ContactSet> {
    let members: Vec<usize> = set.iter().collect();
    let choose = |bits: u64| {
        let picked = members.iter().enumerate().filter(|(k, _)| bits >> k & 1 == 1);
        picked.fold(ContactSet::EMPTY, |set, (_, &i)| set.with(i))
    };
    let mut all: Vec<ContactSet> = (0..1u64 << members.len().min(16)).map(choose).collect();
    all.sort_by_key(|set| (core::cmp::Reverse(set.len()), *set));
    all
}
