//! Motion as power series in time. With q = Σ qₖ sᵏ, v = q̇ and a = v̇, order k of
//!
//! ```text
//! M a − Jᵀ λ = f(q, v, t),    J v + d = 0
//! M aₖ − J₀ᵀ λₖ = fₖ + Σ Jⱼᵀ λₖ₋ⱼ,    J₀ aₖ = −(k + 1) (Σ Jⱼ vₖ₊₁₋ⱼ + dₖ₊₁)    (j ≥ 1)
//! ```
//!
//! is one linear system for aₖ and λₖ, with the same matrix for every k.

mod kkt;
mod reach;

use crate::numerics::root::value;
use crate::scene::{Row, Scene};
use crate::tape::{Inputs, Level, Series, whole};
use liftoff_core::scalar::Scalar;

pub(crate) use kkt::{Kkt, Response, Slot, State};

/// The series of a motion, as far as they are known.
pub(crate) struct Expansion<'a, S> {
    pub scene: &'a Scene<S>,
    pub inputs: Inputs<S>,
    pub series: Series<S>,
    /// The least pivot beside the largest of its matrix: how far its constraints are from depending
    /// on one another.
    pub firmness: f64,
    /// Coefficients of the multipliers of the joints, of the contacts, of the slips.
    joints: Vec<Vec<S>>,
    contacts: Vec<Vec<S>>,
    slips: Vec<Vec<S>>,
}

impl<'a, S: Scalar> Expansion<'a, S> {
    pub fn new(scene: &'a Scene<S>, state: &State<S>) -> Self {
        let positions = state.q.iter().zip(&state.v).map(|(&q, &v)| vec![q, v]).collect();
        let rates = state.v.iter().map(|&v| vec![v]).collect();
        let inputs = Inputs { t: state.t, positions, rates };
        let mut series = Series::new(&scene.tape);
        series.extend(&scene.tape, Level::Position, 0, &inputs);
        series.extend(&scene.tape, Level::Position, 1, &inputs);
        series.extend(&scene.tape, Level::Rate, 0, &inputs);
        let none = |many: usize| vec![Vec::new(); many];
        let contacts = scene.contacts.len();
        Self {
            scene,
            inputs,
            series,
            firmness: 1.0,
            joints: none(scene.joints.len()),
            contacts: none(contacts),
            slips: none(contacts),
        }
    }

    /// Series of motion with these contacts closed, to an order; none where rows contradict one
    /// another.
    pub fn solve(scene: &'a Scene<S>, state: &State<S>, closed: &[usize], order: usize) -> Option<Self> {
        let mut expansion = Self::new(scene, state);
        let kkt = Kkt::assemble(scene, &expansion.series, scene.slots(closed));
        expansion.firmness = kkt.factors.firmness();
        for k in 0..order {
            let response = expansion.next(&kkt, k);
            // In higher orders what rounding leaves grows as the terms do.
            if k == 0 && response.contradicts(0.0) {
                return None;
            }
            expansion.push(&kkt.slots, k, &response.a, &response.multipliers);
        }
        Some(expansion)
    }

    /// Order k with the rows of a matrix closed and all others without force.
    pub fn next(&self, kkt: &Kkt<S>, k: usize) -> Response<S> {
        let targets: Vec<S> = kkt.slots.iter().map(|&slot| -self.bias(self.scene.slot(slot), k).0).collect();
        kkt.solve(&self.force(k), &targets)
    }

    /// fₖ + Σ Jⱼᵀ λₖ₋ⱼ.
    fn force(&self, k: usize) -> Vec<S> {
        let mut force: Vec<S> = self.scene.forces.iter().map(|&node| self.series.get(node, k)).collect();
        let mut add = |row: &Row, multiplier: &[S]| {
            if multiplier.iter().all(|&x| x == S::ZERO) {
                return;
            }
            for &(i, node) in &row.gradient {
                let entries = self.series.coefficients(node);
                for j in 1..=k.min(entries.len().saturating_sub(1)) {
                    if let Some(&past) = multiplier.get(k - j) {
                        force[i] = force[i] + entries[j] * past;
                    }
                }
            }
        };
        self.scene.joints.iter().zip(&self.joints).for_each(|(row, past)| add(row, past));
        for (contact, past) in self.scene.contacts.iter().zip(&self.contacts) {
            add(&contact.row, past);
        }
        for (contact, past) in self.scene.contacts.iter().zip(&self.slips) {
            if let Some(slip) = &contact.slip {
                add(slip, past);
            }
        }
        force
    }

    /// Order k of g̈ without J₀ aₖ, and the size of what it is the sum of.
    pub fn bias(&self, row: &Row, k: usize) -> (S, f64) {
        let mut sum = self.series.get(row.prescribed_gap_rate, k + 1);
        let mut size = sum.abs().to_f64();
        for &(i, node) in &row.gradient {
            let entries = self.series.coefficients(node);
            for j in 1..=(k + 1).min(entries.len().saturating_sub(1)) {
                let part = entries[j] * self.inputs.rates[i][k + 1 - j];
                size += part.abs().to_f64();
                sum = sum + part;
            }
        }
        let factor = whole::<S>(k as i64 + 1);
        (sum * factor, size * (k as f64 + 1.0))
    }

    /// J₀ a of a row.
    pub fn along(&self, row: &Row, a: &[S]) -> (S, f64) {
        row.gradient.iter().fold((S::ZERO, 0.0), |(sum, size), &(i, node)| {
            let part = self.series.get(node, 0) * a[i];
            (sum + part, size + part.abs().to_f64())
        })
    }

    /// ġ of a row.
    pub fn rate(&self, row: &Row) -> S {
        let v: Vec<S> = self.inputs.rates.iter().map(|rate| rate[0]).collect();
        self.along(row, &v).0 + self.series.get(row.prescribed_gap_rate, 0)
    }

    /// Takes in order k.
    pub fn push(&mut self, slots: &[Slot], k: usize, a: &[S], multipliers: &[S]) {
        for (i, &a) in a.iter().enumerate() {
            let rate = a / whole(k as i64 + 1);
            self.inputs.rates[i].push(rate);
            self.inputs.positions[i].push(rate / whole(k as i64 + 2));
        }
        for all in [&mut self.joints, &mut self.contacts, &mut self.slips] {
            all.iter_mut().for_each(|past| past.push(S::ZERO));
        }
        for (&slot, &multiplier) in slots.iter().zip(multipliers) {
            let past = match slot {
                Slot::Joint(i) => &mut self.joints[i],
                Slot::Contact(i) => &mut self.contacts[i],
                Slot::Slip(i) => &mut self.slips[i],
            };
            past[k] = multiplier;
        }
        self.series.extend(&self.scene.tape, Level::Position, k + 2, &self.inputs);
        self.series.extend(&self.scene.tape, Level::Rate, k + 1, &self.inputs);
    }

    /// Series of the reaction of a contact.
    pub fn reaction(&self, contact: usize) -> &[S] {
        &self.contacts[contact]
    }

    /// The same with terms of lower orders only.
    pub fn truncated(&self, terms: usize) -> Self {
        let cut = |all: &[Vec<S>]| all.iter().map(|c| c[..terms.min(c.len())].to_vec()).collect();
        let inputs = Inputs {
            t: self.inputs.t,
            positions: cut(&self.inputs.positions),
            rates: cut(&self.inputs.rates),
        };
        Self {
            scene: self.scene,
            inputs,
            series: self.series.truncated(terms),
            firmness: self.firmness,
            joints: cut(&self.joints),
            contacts: cut(&self.contacts),
            slips: cut(&self.slips),
        }
    }

    /// The state after a time.
    pub fn state(&self, s: S) -> State<S> {
        let at = |all: &[Vec<S>]| all.iter().map(|c| value(c, s)).collect();
        State { t: self.inputs.t + s, q: at(&self.inputs.positions), v: at(&self.inputs.rates) }
    }

    /// Accelerations after a time.
    pub fn accelerations(&self, s: S) -> Vec<S> {
        let slope = |c: &Vec<S>| {
            let slope: Vec<S> = c.iter().enumerate().skip(1).map(|(k, &c)| c * whole(k as i64)).collect();
            value(&slope, s)
        };
        self.inputs.rates.iter().map(slope).collect()
    }
}
