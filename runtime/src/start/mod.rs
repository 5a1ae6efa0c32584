//! From a partial pose to a consistent full state.

mod complete;
mod energy;
mod figure;
mod pose;
mod rates;

pub(crate) use energy::on_energy_of;
pub use pose::Pose;

use crate::chart;
use crate::error::StartError;
use crate::model::{BarSystem, ContactSet};
use crate::moment::state_at;
use crate::scales::Scales;
use figure::Figure;

/// A gap below this, relative to the natural length, is closed; a rate likewise, relative to the natural speed.
/// Poses are typed in or printed with ten digits.
pub(crate) const CLOSED: f64 = 1e-10;

/// A consistent start.
pub(crate) struct Start<M: BarSystem> {
    pub(crate) state: M::State<f64>,
    /// Contacts with g = 0 and ġ = 0.
    pub(crate) touching: ContactSet,
}

impl<M: BarSystem> Clone for Start<M> {
    fn clone(&self) -> Self {
        Self { state: self.state, touching: self.touching }
    }
}

/// The full state that `pose` asks for; what it leaves open follows from the contacts of the nominal figure.
pub(crate) fn start<M: BarSystem>(
    constants: &M::Constants<f64>,
    nominal: &[f64],
    scales: &Scales,
    pose: &Pose,
) -> Result<Start<M>, StartError> {
    let figure = Figure::<M> { constants, nominal, scales };
    let given = pose.resolve::<M>()?;
    let (positions, closed) = complete::positions(&figure, &given.positions)?;
    let (rates, touching) = rates::rates(&figure, &positions, closed, &given.rates)?;
    let state = state_at::<M>(&[positions, rates].concat(), 0.0);
    let settled = chart::image::<M>(constants, touching, &state, CLOSED).ok();
    let state = settled.filter(|settled| given.is_kept(&figure, settled)).unwrap_or(state);
    figure.refuse_feet_off_bars(&state, touching)?;
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
