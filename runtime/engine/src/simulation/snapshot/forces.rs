//! Natural sizes of reactions.

use smallvec::smallvec;

use super::Snapshot;
use crate::context::Numbers;
use crate::model::ContactSet;
use crate::system::Equations;

impl Snapshot<'_> {
    /// The size of the reaction of each closed contact: what it is now, or what gives its contact's
    /// own mass 1/Wᵢᵢ the natural acceleration, or that of the motion where it is faster by now; of
    /// one that slides no more than what has a natural force of friction, however large μ is. That
    /// of an open one is zero.
    pub(in crate::simulation) fn forces(&self) -> Numbers {
        let mut forces: Numbers = smallvec![0.0; self.layout().contacts.len()];
        if self.closed().is_empty() {
            return forces;
        }
        let context = &self.setup.context;
        let equations = context.system().equations(&self.state);
        let scales = context.scales.moving_at(self.layout(), self.rates());
        for contact in self.closed().iter() {
            let mu = self.sliding_friction(contact);
            let own = scales.acceleration() * self.effective_mass(&equations, contact, mu);
            let usual = scales.force() / (1.0 + mu);
            let is_own = own.is_finite() && !self.layout().contacts[contact].is_hinge();
            forces[contact] = self.reactions[contact].abs().max(if is_own { own.min(usual) } else { usual });
        }
        forces
    }

    /// The mass that the reaction of a contact moves by itself: `1/W_NN = dᵀ M d` of the least d
    /// with `J_N d = −1`, and where it slides `1/(W_NN − σ μ W_Nt)` with `W_Nt = −W_NN J_t d`.
    fn effective_mass(&self, equations: &Equations<f64>, contact: usize, mu: f64) -> f64 {
        let mut residual: Numbers = smallvec![0.0; self.layout().rows()];
        residual[contact] = 1.0;
        let mut d: Numbers = smallvec![0.0; self.layout().coordinates.len()];
        let set = ContactSet::EMPTY.with(contact);
        self.setup.context.system().correction(&self.state, set, &residual, &mut d);
        let along = |i: usize| equations.mass(i).iter().zip(&d).map(|(m, d)| m * d).sum::<f64>();
        let alone: f64 = (0..d.len()).map(|i| d[i] * along(i)).sum();
        let slides = self.layout().contacts[contact].friction.filter(|_| mu != 0.0);
        let bent = slides.map_or(1.0, |entry| {
            let tangent = equations.jacobian(self.layout().frictions[entry].row);
            let along_slip: f64 = tangent.iter().zip(&d).map(|(j, d)| j * d).sum();
            1.0 + self.closed().sense(contact) as f64 * mu * along_slip
        });
        alone / bent.abs()
    }

    /// μ of a contact that slides, else zero.
    fn sliding_friction(&self, contact: usize) -> f64 {
        let friction = self.layout().contacts[contact].friction;
        let friction = friction.filter(|_| self.closed().sense(contact) != 0);
        friction.map_or(0.0, |entry| self.slip_states()[entry].kinetic)
    }
}
