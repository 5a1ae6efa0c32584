//! Tie-break by the next orders: keep the candidates whose active constraints stay satisfied after
//! Δt. Candidates with the same accelerations may differ there, as where a guide presses to neither
//! side or loads begin at zero. Orders 1 and 2 decide together: Δt is so short that each order is
//! small against the one before, and long enough for order 2 to exceed roundoff.

use super::place::{HingeCandidate, HingeProblem, SignCondition, ZERO};
use crate::context::Numbers;

/// Part of the natural time.
const MOMENT: f64 = 1e-5;
/// A law that is broken by less than this part of its natural size holds up to rounding.
const ROUNDED: f64 = 1e-13;

impl HingeProblem<'_> {
    /// The motions that go on as they begin; all of them if none does.
    pub(super) fn lasting(&self, found: Vec<HingeCandidate>) -> Vec<HingeCandidate> {
        let lasts: Vec<bool> = found.iter().map(|it| self.lasts(it)).collect();
        if !lasts.contains(&true) {
            return found;
        }
        found.into_iter().zip(lasts).filter_map(|(it, lasts)| lasts.then_some(it)).collect()
    }

    /// Whether a motion goes on as it begins.
    pub(super) fn lasts(&self, found: &HingeCandidate) -> bool {
        let laws = self.laws(found);
        if !laws.iter().any(SignCondition::is_open) {
            return true;
        }
        let Some(later) = self.ahead(found) else { return true };
        laws.iter()
            .zip(later)
            .all(|(now, later)| !now.is_open() || later.margin - now.margin >= -ROUNDED / ZERO * now.zero)
    }

    /// The laws in a moment; nothing where the motion is not a number.
    fn ahead(&self, found: &HingeCandidate) -> Option<Vec<SignCondition>> {
        let begun = HingeProblem::new(self.context, self.moved(&found.accelerations, &found.accelerations));
        let (then, ..) = begun.solve(found.set)?;
        let place = HingeProblem::new(self.context, self.moved(&found.accelerations, &then));
        let (accelerations, reactions, unique) = place.solve(found.set)?;
        let later =
            HingeCandidate { accelerations, reactions, unique, choice: found.choice.clone(), set: found.set };
        Some(place.laws(&later))
    }

    /// The state after a moment with accelerations that change from some to others.
    pub(super) fn moved(&self, from: &[f64], to: &[f64]) -> Numbers {
        let (n, dt) = (from.len(), MOMENT * self.scales.time);
        let mut state = Numbers::from_slice(&self.state);
        for i in 0..n {
            state[i] += dt * (self.state[n + i] + dt * (2.0 * from[i] + to[i]) / 6.0);
            state[n + i] += 0.5 * dt * (from[i] + to[i]);
        }
        if self.context.layout().timed {
            state[2 * n] += dt;
        }
        state
    }
}
