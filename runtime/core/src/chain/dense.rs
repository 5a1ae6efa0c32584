//! Mass matrix, forces, energies and positions, by sums along the chain.
//!
//! Bar k carries the bars beyond it: with s = (N − k − ½) l the distance times number of bars, k
//! from 0, `M_kj = m l sⱼ eₖ·eⱼ` for k < j, `M_kk = J + m l² (N − k − 1 + ¼)`,
//! `fₖ = nₖ·(sₖ m g + m l Σⱼ w_kj ω²ⱼ eⱼ)`.

use super::Chain;
use super::plane::PlaneVector;
use crate::model::Energy;
use crate::scalar::Real;

impl<S: Real> Chain<S> {
    /// M of `M ω̇ = f`.
    #[inline]
    pub fn mass_matrix<const N: usize>(&self, angles: &[S; N]) -> [[S; N]; N] {
        let (sin, cos) = S::sin_cos_each(*angles);
        let scale = self.mass * self.length * self.length;
        core::array::from_fn(|k| {
            core::array::from_fn(|j| {
                let beyond = count::<S, N>(k.max(j));
                match k == j {
                    true => scale.mul_add(beyond - S::ratio(1, 4), self.inertia),
                    false => scale * beyond * cos[k].mul_add(cos[j], sin[k] * sin[j]),
                }
            })
        })
    }

    /// f of `M ω̇ = f`: what gravity and the rates exert.
    #[inline]
    pub fn forces<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> [S; N] {
        let (sin, cos) = S::sin_cos_each(*angles);
        let edge = |k: usize| PlaneVector { x: cos[k], y: sin[k] };
        let scale = self.mass * self.length;
        let mut forces = [S::ratio(0, 1); N];
        // Σ ω²ⱼ eⱼ over the bars before k, and Σ (N − j − ½) ω²ⱼ eⱼ over those beyond.
        let mut before = PlaneVector::zero();
        for k in 0..N {
            let beyond = count::<S, N>(k);
            let across = PlaneVector { x: -sin[k], y: cos[k] };
            let pull = before.scaled(self.length) + self.gravity;
            forces[k] = scale * beyond * across.dot(pull);
            before = before + edge(k).scaled(rates[k] * rates[k]);
        }
        let mut after = PlaneVector::zero();
        for k in (0..N).rev() {
            let across = PlaneVector { x: -sin[k], y: cos[k] };
            forces[k] = (scale * self.length).mul_add(across.dot(after), forces[k]);
            after = after + edge(k).scaled(count::<S, N>(k) * rates[k] * rates[k]);
        }
        forces
    }

    /// Kinetic and potential energy, the latter zero with every bar at the pin's height.
    #[inline]
    pub fn energy<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> Energy<S> {
        let (sin, cos) = S::sin_cos_each(*angles);
        let half = self.length * S::ratio(1, 2);
        let (mut at, mut velocity) = (PlaneVector::zero(), PlaneVector::zero());
        let (mut twice, mut potential) = (S::ratio(0, 1), S::ratio(0, 1));
        for k in 0..N {
            let edge = PlaneVector { x: cos[k], y: sin[k] }.scaled(half);
            let across = PlaneVector { x: -sin[k], y: cos[k] }.scaled(half * rates[k]);
            let (centre, speed) = (at + edge, velocity + across);
            twice = twice + self.mass.mul_add(speed.dot(speed), self.inertia * rates[k] * rates[k]);
            potential = (-self.mass).mul_add(self.gravity.dot(centre), potential);
            (at, velocity) = (centre + edge, speed + across);
        }
        Energy { kinetic: S::ratio(1, 2) * twice, potential }
    }

    /// The last end of every bar, from the pin, along the two axes.
    #[inline]
    pub fn positions<const N: usize>(&self, angles: &[S; N]) -> [[S; 2]; N] {
        let (sin, cos) = S::sin_cos_each(*angles);
        let mut at = PlaneVector::zero();
        core::array::from_fn(|k| {
            at = at + PlaneVector { x: cos[k], y: sin[k] }.scaled(self.length);
            [at.x, at.y]
        })
    }
}

/// N − k − ½: the bars beyond bar k, and half of it.
#[inline]
fn count<S: Real, const N: usize>(k: usize) -> S {
    S::ratio(2 * (N - k) as i64 - 1, 2)
}
