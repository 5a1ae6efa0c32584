//! Which contacts stay closed: 0 ≤ g̈ ⟂ λ ≥ 0, and where both are zero the same of their
//! derivatives, order by order. With W and b of the undecided contacts at order k (those that bear
//! are kept closed),
//!
//! ```text
//! 0 ≤ g̈ₖ = W λₖ + bₖ ⟂ λₖ ≥ 0
//! ```
//!
//! λₖ > 0 bears from there on, g̈ₖ > 0 opens, both zero waits for the next order.

mod rough;
mod smooth;

use crate::expansion::{Expansion, Kkt, Slot, State};
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::Scalar;
use rough::tried;
use smooth::{Problem, delassus, smooth};

/// What is not decided by then keeps still.
const ORDERS: usize = 8;
/// What becomes of contacts that touch without speed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Decision {
    /// Those that bear, with the first order of their reactions that is not zero.
    pub bearing: Vec<(usize, usize)>,
    /// Those that stay closed by themselves, without a reaction of their own.
    pub idle: Vec<usize>,
    /// Those that open, with the first order of their gaps that is not zero.
    pub opening: Vec<(usize, usize)>,
}

/// Why nothing is decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Undecided {
    /// The equations contradict one another.
    Singular,
    /// There is no admissible set.
    Jammed,
    /// Too many rough contacts.
    Many,
}

/// What an order decides.
struct Outcome<S> {
    multipliers: Vec<S>,
    opening: Vec<S>,
    a: Vec<S>,
    all: Vec<S>,
    slots: Vec<Slot>,
}

/// Decides on the contacts that rest while others are held closed whatever their reactions.
pub(crate) fn decide<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, resting): (&[usize], &[usize]),
) -> Result<Decision, Undecided> {
    let mut round = Round::new(scene, state, (held, resting));
    for k in 0..ORDERS {
        round.decide(k)?;
        if round.open.is_empty() {
            break;
        }
    }
    let mut decision = round.decision;
    decision.idle = round.open;
    decision.bearing.drain(..held.len());
    Ok(decision)
}

/// What is decided so far.
struct Round<'a, S> {
    expansion: Expansion<'a, S>,
    decision: Decision,
    open: Vec<usize>,
    rough: bool,
    /// The largest right-hand side so far.
    largest: f64,
    /// One over the natural time.
    pace: f64,
    /// The sizes of the first order, by contact.
    first: Vec<(usize, f64)>,
}

impl<'a, S: Scalar> Round<'a, S> {
    fn new(scene: &'a Scene<S>, state: &State<S>, (held, resting): (&[usize], &[usize])) -> Self {
        Self {
            expansion: Expansion::new(scene, state),
            decision: Decision { bearing: held.iter().map(|&i| (i, 0)).collect(), ..Decision::default() },
            open: resting.to_vec(),
            rough: resting.iter().any(|&i| scene.contacts[i].slip.is_some()),
            largest: 0.0,
            pace: 0.0,
            first: Vec::new(),
        }
    }

    fn decide(&mut self, k: usize) -> Result<(), Undecided> {
        let bearing: Vec<usize> = self.decision.bearing.iter().map(|&(i, _)| i).collect();
        let kkt =
            Kkt::assemble(self.expansion.scene, &self.expansion.series, self.expansion.scene.slots(&bearing));
        let mut problem = delassus(&self.expansion, &kkt, &self.open, k);
        self.weigh(&mut problem, k);
        if problem.free.contradicts(self.largest) {
            return Err(Undecided::Singular);
        }
        let outcome = match self.rough {
            true => tried(&self.expansion, &bearing, &self.open, (k, self.largest))?,
            false => match self.all_bear(k, &bearing, &problem) {
                Some(outcome) => outcome,
                None => Outcome::solve(&problem, kkt.slots, &self.open)?,
            },
        };
        self.expansion.push(&outcome.slots, k, &outcome.a, &outcome.all);
        self.sort(k, &problem, &outcome);
        Ok(())
    }

    /// All that are undecided closed, if each of them pushes: by their own rows, which are known
    /// where W is rounding.
    fn all_bear(&self, k: usize, bearing: &[usize], problem: &Problem<S>) -> Option<Outcome<S>> {
        let scene = self.expansion.scene;
        let kkt = Kkt::assemble(scene, &self.expansion.series, scene.slots(&[bearing, &self.open].concat()));
        let response = self.expansion.next(&kkt, k);
        let first = scene.joints.len() + bearing.len();
        let multipliers = response.multipliers.get(first..first + self.open.len())?.to_vec();
        // What depends on others has none of its own.
        let pushes =
            |(j, &z): (usize, &S)| z == S::ZERO || self.is_clear(problem, j, z * problem.matrix[j][j]);
        let all = multipliers.iter().enumerate().all(pushes);
        (all && !response.contradicts(self.largest)).then(|| Outcome {
            opening: vec![S::ZERO; multipliers.len()],
            multipliers,
            a: response.a,
            all: response.multipliers,
            slots: kkt.slots,
        })
    }

    /// Whether an acceleration of an undecided contact is none of its rounding.
    fn is_clear(&self, problem: &Problem<S>, j: usize, acceleration: S) -> bool {
        acceleration.to_f64() > negligible::<S>() * problem.sizes[j]
    }

    /// Where nothing changes orders above the first are rounding of it.
    fn weigh(&mut self, problem: &mut Problem<S>, k: usize) {
        if k == 0 {
            self.pace = self.expansion.pace(&problem.free.a);
            self.first = self.open.iter().copied().zip(problem.sizes.iter().copied()).collect();
        }
        for (&contact, size) in self.open.iter().zip(&mut problem.sizes) {
            let of = self.first.iter().find(|(other, _)| *other == contact).map_or(0.0, |(_, size)| *size);
            *size = size.max(of * self.pace.powi(k as i32));
        }
        self.largest = self.largest.max(problem.free.size);
    }

    /// Those that bear, open, or wait for the next order.
    fn sort(&mut self, k: usize, problem: &Problem<S>, outcome: &Outcome<S>) {
        let mut waiting = Vec::new();
        for (j, &contact) in self.open.iter().enumerate() {
            if self.is_clear(problem, j, outcome.multipliers[j] * problem.matrix[j][j]) {
                self.decision.bearing.push((contact, k));
            } else if self.is_clear(problem, j, outcome.opening[j]) {
                self.decision.opening.push((contact, k + 2));
            } else {
                waiting.push(contact);
            }
        }
        self.open = waiting;
    }
}

impl<S: Scalar> Outcome<S> {
    /// Of contacts without slip rows.
    fn solve(problem: &Problem<S>, mut slots: Vec<Slot>, open: &[usize]) -> Result<Self, Undecided> {
        let (multipliers, opening) = smooth(problem)?;
        let mut a = problem.free.a.clone();
        let mut all = problem.free.multipliers.clone();
        for (response, &z) in problem.responses.iter().zip(&multipliers) {
            add(&mut a, &response.a, z);
            add(&mut all, &response.multipliers, z);
        }
        slots.extend(open.iter().map(|&i| Slot::Contact(i)));
        all.extend(&multipliers);
        Ok(Self { multipliers, opening, a, all, slots })
    }
}

fn add<S: Scalar>(sum: &mut [S], part: &[S], factor: S) {
    sum.iter_mut().zip(part).for_each(|(sum, &part)| *sum = *sum + part * factor);
}
