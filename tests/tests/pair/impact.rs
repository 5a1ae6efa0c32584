//! Impacts: the model's M and J in the runtime's impulse solver, against Newton–Euler impulses of the contacts that act.

use liftoff::impulse::{Collision, CollisionError, Outcome, Row};
use liftoff::model::Law;
use liftoff_tests::oracle::State;
use liftoff_tests::random::Source;
use nalgebra::{DMatrix, DVector};

use super::{LEAST_PIVOT, Pair};

/// Residual of the contact conditions.
const RESIDUAL: f64 = 1e-10;
/// Energy that rounding may add, relative to what there is.
const GAIN: f64 = 1e-12;

impl Pair {
    /// A state in which the contacts of a set touch and everything moves as its joints let it.
    pub fn colliding(&self, set: u64, source: &mut Source) -> Option<State> {
        let assembly = &self.sample.assembly;
        let start = self.sample.state(source)?;
        let moving = start.rates.clone();
        let touching = assembly.settle(start, &self.supports(set))?;
        assembly.settle(State { rates: moving, ..touching }, &[])
    }

    /// An impact of a set of contacts; false where the masses do not determine it.
    pub fn impact(&self, state: &State, set: u64) -> bool {
        let collision = self.collision(state, set);
        let Self { seed, sample, .. } = self;
        let outcome = match collision.solve() {
            Ok(outcome) => outcome,
            Err(CollisionError::Singular) => return false,
            // At a singular position of a loop its rates may contradict one another.
            Err(_) if self.motion(state, set).is_none() => return false,
            Err(error) => panic!("seed {seed}, set {set:b}: {error}\n{}", sample.declaration),
        };
        let residual = collision.residual(&outcome);
        assert!(
            residual <= RESIDUAL,
            "seed {seed}, set {set:b}: residual {residual:e}\n{}",
            sample.declaration
        );
        let energy = |u: &DVector<f64>| u.dot(&(&collision.mass * u));
        let (before, after) = (energy(&collision.rates), energy(&outcome.rates));
        let driven = !sample.assembly.drives.is_empty();
        assert!(
            driven || after <= before * (1.0 + GAIN),
            "seed {seed}, set {set:b}: {after:e} of {before:e}"
        );
        self.shares(state, &outcome)
    }

    fn collision(&self, state: &State, set: u64) -> Collision {
        let (full, n) = (self.full(state), self.analysis.motion.n);
        let kernel = &self.analysis.functions.kernel;
        let rows = kernel.jacobian.len();
        let entries: Vec<_> = kernel.jacobian.iter().flat_map(|ids| self.values(ids, &full)).collect();
        Collision {
            mass: self.mass(&full),
            jacobian: DMatrix::from_row_slice(rows, n, &entries),
            rates: DVector::from_column_slice(&full.0[n..2 * n]),
            drift: DVector::from_vec(self.values(&kernel.drift, &full)),
            applied: DVector::zeros(n),
            rows: (0..rows).map(|row| self.part(row, set)).collect(),
        }
    }

    /// What a row is in an impact of a set.
    fn part(&self, row: usize, set: u64) -> Row {
        let motion = &self.analysis.motion;
        let contacts = motion.contacts.len();
        let slips = motion.rows.len() - motion.tangents.len();
        if !motion.is_closed(row, set) {
            return Row::Open;
        }
        if row >= slips {
            return Row::Tangent { of: motion.tangents[row - slips] };
        }
        if row >= contacts {
            return Row::TwoSided;
        }
        let (restitution, poisson) = self.sample.restitution[motion.contacts[row].supports[0]];
        Row::Contact { restitution, law: if poisson { Law::Poisson } else { Law::Newton } }
    }

    /// The same contacts, made to part as they do, need the same impulses and leave the same rates.
    fn shares(&self, state: &State, outcome: &Outcome) -> bool {
        let contacts = &self.analysis.motion.contacts;
        let acting: Vec<_> = outcome.acting.iter().map(|&contact| 1 << contact).collect();
        let targets = acting.iter().zip(&outcome.acting).flat_map(|(&set, &contact)| {
            self.supports(set).into_iter().map(move |support| (support, outcome.opening[contact]))
        });
        let targets: Vec<_> = targets.collect();
        let Ok(impact) = self.sample.assembly.impact(state, &targets, &[]) else {
            return false;
        };
        if !(impact.unique && outcome.unique && impact.pivots > LEAST_PIVOT) {
            return true;
        }
        let n = self.analysis.motion.n;
        let after = self.full(&State { rates: impact.rates.clone(), ..state.clone() });
        self.close("rates after an impact", outcome.rates.as_slice(), &after.0[n..2 * n]);
        let impulses = &outcome.impulses.as_slice()[..contacts.len()];
        self.close("impulses", impulses, &self.totals(&impact.normal));
        true
    }
}
