//! The work of friction forces over a step.

use super::sample::{Sample, Scratch};
use super::step::StepView;
use crate::context::{Numbers, RunContext, slips};
use crate::model::Layout;
use crate::numerics::root_isolation::{TERMS, without_zeros};

/// Whether the series of a contact's friction force and slip velocity are exact enough, given its
/// slip velocity without rates.
type Judge<'a> = dyn Fn(usize, [&[f64]; 2], f64) -> bool + 'a;

impl StepView<'_> {
    /// Slip velocities without rates, where friction is all that works on the model and its
    /// reactions are those of the phase: they are the same at all times, since what moves with time
    /// works too.
    pub(super) fn slips_at_rest(&self, scratch: &mut Scratch) -> Option<Numbers> {
        let has_friction = !self.context.layout().frictions.is_empty();
        let tells = has_friction && self.closed == self.phase.info().set && !self.context.is_worked_on();
        tells.then(|| {
            let Scratch { reduced, state, .. } = scratch;
            self.reduced(0.0, reduced);
            self.phase.embed(reduced, state);
            slip_velocities_at_rest(self.context, state)
        })
    }

    /// The work of friction up to θ = `end`, ∫ R (v − v°) dt, where `is_exact` holds for the series
    /// of the forces and of the velocities of all contacts.
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

/// The power of friction of a sample, Σ R J_t u, where J_t u is what rates add to the slip velocity
/// that is there without them.
pub(super) fn compute_friction_power(layout: &Layout, sample: &Sample, at_rest: &[f64]) -> f64 {
    let forces = sample.reactions[layout.contacts.len()..].iter().zip(sample.slips.iter().zip(at_rest));
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
