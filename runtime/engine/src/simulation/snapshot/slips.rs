//! How contacts with friction slip.

use super::Snapshot;
use crate::context::{Numbers, Slips, slips};
use crate::model::{ContactSet, Friction, Slip};

impl Snapshot<'_> {
    /// The natural slip velocity of each contact with friction; of a hinge that of its journal's
    /// surface at a radian in the natural time.
    pub(in crate::simulation) fn natural_slips(&self) -> Numbers {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        if layout.frictions.is_empty() {
            return Numbers::new();
        }
        let equations = layout.has_hinges().then(|| self.setup.context.system().equations(&self.state));
        let unit = |friction: &Friction| {
            let hinges = equations.as_ref().filter(|_| layout.contacts[friction.contact].is_hinge());
            let Some(equations) = hinges else { return scales.speed() };
            let entries = equations.jacobian(friction.row).iter().zip(layout.coordinates);
            entries.map(|(entry, c)| (entry * scales.coordinate(c)).abs()).fold(0.0, f64::max) / scales.time
        };
        layout.frictions.iter().map(unit).collect()
    }

    pub(in crate::simulation) fn slip_states(&self) -> Slips {
        slips(self.setup.context.system(), &self.state)
    }

    /// The set with its contacts with friction slipping by their velocities.
    pub(in crate::simulation) fn slipping_as_now(&self, closed: ContactSet) -> ContactSet {
        let (slips, natural) = (self.slip_states(), self.natural_slips());
        let frictions = self.layout().frictions.iter().zip(slips.iter().zip(&natural));
        let closes = frictions.filter(|(friction, _)| closed.contains(friction.contact));
        closes.fold(closed.closed(), |set, (friction, (slip, natural))| {
            let slip = match slip.velocity {
                v if v.abs() <= self.relative_bound() * natural => Slip::Stick,
                v if v > 0.0 => Slip::Forward,
                _ => Slip::Backward,
            };
            set.slipping(friction.contact, slip)
        })
    }
}
