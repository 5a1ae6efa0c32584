//! Equilibria: a(q) = 0 in some contact set, with reactions that the contacts can give and gaps
//! that are not negative.

mod bearing;
mod limit;
mod newton;
mod search;

use liftoff_core::model::Coordinate;

use crate::Linearisation;
pub use bearing::{JointForce, Load};
pub use limit::{LimitEnd, LoadLimit, load_limit};
pub use search::equilibria;

/// A mode whose rate is below this, in natural units, neither grows nor returns.
const NEUTRAL: f64 = 1e-7;

/// A position of rest.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    /// The supports of the contacts that touch.
    pub closed: Vec<&'static str>,
    /// All coordinates.
    pub positions: Vec<f64>,
    /// What the contacts bear, those that touch in the order of the layout.
    pub loads: Vec<Load>,
    /// What joints and drives transmit, where the equations determine it: `fx(A, AB)`, N or N m.
    pub joint_forces: Vec<JointForce>,
    /// The motion nearby, with the contacts closed that bear.
    pub linear: Linearisation,
    pub(crate) time: f64,
    pub(crate) coordinates: &'static [Coordinate],
}

/// What small displacements do that keep the bearing contacts closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// The contacts let nothing move.
    Fixed,
    /// They stay small.
    Stable,
    /// Some neither grow nor return: there are other equilibria beside it, or the next order
    /// decides.
    Neutral,
    /// So many modes grow.
    Unstable(usize),
}

impl Equilibrium {
    /// What small displacements do, by the eigenvalues of the linearised motion.
    pub fn stability(&self) -> Stability {
        let modes = self.linear.modes();
        let bound = NEUTRAL / self.time;
        match modes.iter().filter(|mode| mode.growth() > bound).count() {
            _ if modes.is_empty() => Stability::Fixed,
            0 if modes.iter().any(|mode| mode.frequency() <= bound) => Stability::Neutral,
            0 => Stability::Stable,
            growing => Stability::Unstable(growing),
        }
    }

    /// Contacts that touch and bear nothing: they open at the least displacement that lets them.
    pub fn unloaded(&self) -> impl Iterator<Item = &Load> {
        self.loads.iter().filter(|load| !load.bears)
    }

    /// A coordinate by name.
    pub fn coordinate(&self, name: &str) -> Option<f64> {
        let place = self.coordinates.iter().position(|known| known.name == name)?;
        Some(self.positions[place])
    }
}
