//! Impacts. With W of the joints alone and ġ⁻ of all contacts that touch: Newton, where none of
//! them leaves already,
//!
//! ```text
//! 0 ≤ ġ⁺ + e ġ⁻ ⟂ P ≥ 0,    ġ⁺ = W P + ġ⁻
//! ```
//!
//! else, or where one that acts declares it, Poisson: 0 ≤ ġᶜ ⟂ Pᶜ ≥ 0, then 0 ≤ ġ⁺ ⟂ P − (1 + e) Pᶜ
//! ≥ 0.

mod rough;

use crate::decision::Undecided;
use crate::expansion::{Expansion, Kkt, Response, State};
use crate::numerics::complementarity;
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::Scalar;
use rough::rough;

/// Rates after an impact.
pub(crate) struct Impact<S> {
    pub v: Vec<S>,
}

/// The impact of contacts that touch, with an applied impulse on the coordinates, while others are
/// held closed; `plastic`: without restitution.
pub(crate) fn collide<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, touching): (&[usize], &[usize]),
    applied: &[S],
    plastic: bool,
) -> Result<Impact<S>, Undecided> {
    if touching.iter().any(|&i| scene.contacts[i].slip.is_some()) {
        return rough(scene, state, (held, touching), applied);
    }
    let blow = Blow::compute(scene, state, (held, touching), applied);
    let restitution =
        touching.iter().map(|&i| if plastic { S::ZERO } else { scene.contacts[i].restitution }).collect();
    let impulses = blow.impulses(restitution, |j| scene.contacts[touching[j]].poisson)?;
    let mut v: Vec<S> = state.v.iter().zip(&blow.free).map(|(&v, &change)| v + change).collect();
    for (response, &impulse) in blow.responses.iter().zip(&impulses) {
        v.iter_mut().zip(&response.a).for_each(|(v, &change)| *v = *v + change * impulse);
    }
    Ok(Impact { v })
}

/// What impulses of the contacts that touch do.
struct Blow<S> {
    /// Changes of the rates by what is applied.
    free: Vec<S>,
    /// By a unit impulse of each contact.
    responses: Vec<Response<S>>,
    /// W.
    matrix: Vec<Vec<S>>,
    /// ġ⁻.
    approach: Vec<S>,
    /// What is applied changes it by this.
    pushed: Vec<S>,
}

impl<S: Scalar> Blow<S> {
    fn compute(
        scene: &Scene<S>,
        state: &State<S>,
        (held, touching): (&[usize], &[usize]),
        applied: &[S],
    ) -> Self {
        let expansion = Expansion::new(scene, state);
        let kkt = Kkt::assemble(scene, &expansion.series, scene.slots(held));
        let zeros = vec![S::ZERO; kkt.slots.len()];
        let free = kkt.solve(applied, &zeros).a;
        let respond = |&i: &usize| {
            let mut force = vec![S::ZERO; scene.n()];
            for &(c, node) in &scene.contacts[i].row.gradient {
                force[c] = expansion.series.get(node, 0);
            }
            kkt.solve(&force, &zeros)
        };
        let responses: Vec<Response<S>> = touching.iter().map(respond).collect();
        let along = |i: usize, a: &[S]| expansion.along(&scene.contacts[i].row, a).0;
        let tolerance = negligible::<S>() * scene.speed(state);
        let rate = |&i: &usize| {
            let rate = expansion.rate(&scene.contacts[i].row);
            if rate.abs().to_f64() <= tolerance { S::ZERO } else { rate }
        };
        let row = |&i: &usize| responses.iter().map(|r| along(i, &r.a)).collect();
        let matrix = touching.iter().map(row).collect();
        let pushed = touching.iter().map(|&i| along(i, &free)).collect();
        Self { matrix, approach: touching.iter().map(rate).collect(), pushed, free, responses }
    }

    /// By Newton's law, or by Poisson's where a contact leaves already or one that acts declares
    /// it.
    fn impulses(&self, e: Vec<S>, poisson: impl Fn(usize) -> bool) -> Result<Vec<S>, Undecided> {
        let leaves = self.approach.iter().any(|&rate| rate > S::ZERO);
        let declared = !leaves && {
            let acting = self.newton(|_| S::ZERO)?;
            acting.iter().enumerate().any(|(j, &p)| poisson(j) && p > S::ZERO)
        };
        if !leaves && !declared {
            return self.newton(|j| e[j]);
        }
        let compression = self.newton(|_| S::ZERO)?;
        let expanded: Vec<S> = compression.iter().zip(&e).map(|(&p, &e)| p + e * p).collect();
        let after = |i: usize| {
            let sum = self.approach[i] + self.pushed[i];
            self.matrix[i].iter().zip(&expanded).fold(sum, |sum, (&w, &p)| sum + w * p)
        };
        let rest = self.solve((0..self.approach.len()).map(after).collect())?;
        Ok(expanded.iter().zip(rest).map(|(&a, b)| a + b).collect())
    }

    fn newton(&self, e: impl Fn(usize) -> S) -> Result<Vec<S>, Undecided> {
        let bias = |j: usize| self.approach[j] + self.pushed[j] + e(j) * self.approach[j];
        self.solve((0..self.approach.len()).map(bias).collect())
    }

    fn solve(&self, bias: Vec<S>) -> Result<Vec<S>, Undecided> {
        complementarity::solve(&self.matrix, &bias).ok_or(Undecided::Jammed)
    }
}
