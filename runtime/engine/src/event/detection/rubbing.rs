//! Contacts with friction over a step: the series of their guards, and the work of their forces.

use super::step::{Kinds, StepView, Values};
use super::{Guard, Rub};
use crate::context::{Numbers, RunContext, slips};
use crate::model::{Side, SlipState};
use crate::numerics::root_isolation::{TERMS, without_zeros};

/// Whether the series of a contact's friction force and slip velocity are exact enough, given its slip velocity without rates.
type Judge<'a> = dyn Fn(usize, [&[f64]; 2], f64) -> bool + 'a;

impl StepView<'_> {
    /// The series of a guard of friction, with the coefficient of its limit; nothing if the method does not have it.
    pub(super) fn write_rubbing(&self, guard: Guard, limit: f64, series: &mut Vec<f64>) {
        series.clear();
        if !matches!(guard, Guard::Side(..) | Guard::Limit(_) | Guard::Slip(_)) {
            return;
        }
        // A contact that is closed because others are has no series in their phase.
        let own = |contact: usize| self.phase.info().set.contains(contact);
        let (Some(guards), contacts) = (self.guards, self.context.layout().contacts.len()) else { return };
        match guard {
            Guard::Limit(Rub { contact, .. }) | Guard::Slip(Rub { contact, .. }) if !own(contact) => {}
            Guard::Side(contact, Side::Negative) if own(contact) => {
                series.extend(guards.reaction(contact).iter().map(|normal| -normal));
            }
            Guard::Limit(Rub { contact, friction, slip, side }) => {
                let limit = f64::from(side.sign()) * limit;
                let (sign, force) = (f64::from(slip.sign()), guards.reaction(contacts + friction));
                let terms = guards.reaction(contact).iter().zip(force);
                series.extend(terms.map(|(normal, force)| limit * normal + sign * force));
            }
            Guard::Slip(Rub { friction, slip, .. }) => {
                let velocity = guards.gap(contacts + friction).iter();
                series.extend(velocity.map(|velocity| f64::from(slip.sign()) * velocity));
            }
            _ => {}
        }
    }

    /// The coefficient of a limit, a constant of the model.
    pub(super) fn limit(&self, guard: Guard, values: &mut Values) -> f64 {
        let Guard::Limit(Rub { friction, .. }) = guard else { return 0.0 };
        self.sample(0.0, Kinds { slips: true, ..Kinds::default() }, values);
        values.slips[friction].limit
    }

    /// Slip velocities without rates, where friction is all that works on the model and its reactions are those of the phase:
    /// they are the same at all times, since what moves with time works too.
    pub(super) fn slips_at_rest(&self, values: &mut Values) -> Option<Numbers> {
        let has_friction = !self.context.layout().frictions.is_empty();
        let tells = has_friction && self.closed == self.phase.info().set && !self.context.is_worked_on();
        tells.then(|| {
            self.sample(0.0, Kinds { slips: true, ..Kinds::default() }, values);
            slip_velocities_at_rest(self.context, &values.state)
        })
    }

    /// The power of friction with the values as sampled.
    pub(super) fn friction_power(&self, values: &Values, at_rest: &[f64]) -> f64 {
        compute_friction_power(self.context, &values.reactions, &values.slips, at_rest)
    }

    /// The work of friction up to θ = `end`, ∫ R (v − v°) dt, where `is_exact` holds for the series of the forces and of the
    /// velocities of all contacts.
    pub(super) fn friction_work(&self, end: f64, at_rest: &[f64], is_exact: &Judge<'_>) -> Option<f64> {
        let (guards, contacts) = (self.guards?, self.context.layout().contacts.len());
        let mut work = 0.0;
        for (k, (friction, at_rest)) in self.context.layout().frictions.iter().zip(at_rest).enumerate() {
            let (force, slip) = (guards.reaction(contacts + k), guards.gap(contacts + k));
            if force.iter().all(|c| *c == 0.0) {
                continue;
            }
            if !is_exact(friction.contact, [force, slip], *at_rest) {
                return None;
            }
            work += integral(force, slip, *at_rest, end);
        }
        Some(self.dense.h * work)
    }
}

/// ∫ Σ aᵢ θⁱ (Σ bⱼ θʲ − c) dθ from 0 to `end`.
fn integral(a: &[f64], b: &[f64], c: f64, end: f64) -> f64 {
    let (a, b) = (without_zeros(a), without_zeros(b));
    let mut product = [0.0; 2 * TERMS];
    for (i, a) in a.iter().enumerate() {
        product[i] -= a * c;
        product[i..].iter_mut().zip(b).for_each(|(term, b)| *term += a * b);
    }
    let terms = product[..(a.len() + b.len()).min(2 * TERMS)].iter().enumerate().rev();
    terms.fold(0.0, |sum, (k, term)| sum * end + term / (k + 1) as f64) * end
}

/// The slip velocities that surfaces which move make at a state without rates.
fn slip_velocities_at_rest(context: &RunContext, state: &[f64]) -> Numbers {
    let mut still: Numbers = state.into();
    still[context.rates()].fill(0.0);
    slips(context.system(), &still).iter().map(|slip| slip.velocity).collect()
}

/// Σ R J_t u, where J_t u is what rates add to the slip velocity that is there without them.
fn compute_friction_power(
    context: &RunContext,
    reactions: &[f64],
    slips: &[SlipState<f64>],
    at_rest: &[f64],
) -> f64 {
    let forces = reactions[context.layout().contacts.len()..].iter().zip(slips.iter().zip(at_rest));
    forces.map(|(force, (slip, at_rest))| force * (slip.velocity - at_rest)).sum()
}

#[cfg(test)]
mod tests {
    use super::integral;

    /// ∫ (1 + 2θ)(3θ² − 4) dθ = 3θ⁴/2 + θ³ − 4θ² − 4θ.
    #[test]
    fn products_of_series_are_integrated() {
        for end in [0.25, 0.5, 1.0_f64] {
            let expected = 1.5 * end.powi(4) + end.powi(3) - 4.0 * end * end - 4.0 * end;
            let found = integral(&[1.0, 2.0], &[1.0, 0.0, 3.0], 5.0, end);
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
