//! Impacts: the model's M and J in the runtime's impulse solver, against Newton–Euler impulses of
//! the contacts that act.

use liftoff::__private::impulse::{Collision, CollisionError, Outcome, Row};
use liftoff_codegen::motion::{ClosedSet, Motion};
use liftoff_core::model::Law;
use liftoff_tests::oracle::{Impact, State, Unsolvable};
use liftoff_tests::random::Source;
use nalgebra::{DMatrix, DVector};

use super::{LEAST_PIVOT, Pair};

/// Residual of the contact conditions.
const RESIDUAL: f64 = 1e-10;
/// Energy that rounding may add, relative to what there is.
const GAIN: f64 = 1e-12;

/// What became of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Its rates and impulses are the oracle's.
    Compared,
    /// The masses do not determine it, or not its impulses.
    Undetermined,
    /// No impulses are admissible.
    Refused,
}

impl Pair {
    /// A state in which the contacts of a set touch and everything moves as its joints let it.
    pub fn colliding(&self, set: u64, source: &mut Source) -> Option<State> {
        let assembly = &self.sample.assembly;
        let start = self.sample.state(source)?;
        let moving = start.rates.clone();
        let touching = assembly.settle(start, &self.supports(set))?;
        let colliding = assembly.settle(State { rates: moving, ..touching }, &[])?;
        self.sample.is_symmetric(&colliding).then_some(colliding)
    }

    /// An impact of a set of contacts.
    pub fn impact(&self, state: &State, set: u64) -> Met {
        let collision = self.collision(state, set);
        let Self { seed, sample, .. } = self;
        let outcome = match collision.solve() {
            Ok(outcome) => outcome,
            Err(CollisionError::Singular) => return Met::Undetermined,
            Err(error) => return self.refused(state, set, error),
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
        self.shares(state, &collision, &outcome)
    }

    /// Only rough contacts may contradict one another, and the rates of a loop at a singular
    /// position.
    fn refused(&self, state: &State, set: u64, error: CollisionError) -> Met {
        let Self { seed, sample, .. } = self;
        let singular = self.motion(state, set).is_none();
        assert!(
            singular || self.is_rough(set) && !self.is_admissible(state, set),
            "seed {seed}, set {set:b}: {error}\n{}",
            sample.declaration
        );
        Met::Refused
    }

    /// Whether any contact of a set is rough.
    pub fn is_rough(&self, set: u64) -> bool {
        self.supports(set).into_iter().any(|support| self.sample.assembly.supports[support].rough)
    }

    /// Whether in the oracle some contacts of a set, made to stop, have impulses > 0 and the others
    /// part.
    fn is_admissible(&self, state: &State, set: u64) -> bool {
        let assembly = &self.sample.assembly;
        let holds = |acting: u64| {
            let stopped: Vec<_> = self.supports(acting).into_iter().map(|support| (support, 0.0)).collect();
            let Ok(impact) = assembly.impact(state, &stopped, &[]) else { return false };
            let after = State { rates: impact.rates, ..state.clone() };
            let others = self.supports(set & !acting).into_iter();
            let mut signs = others
                .map(|support| assembly.gap(&after, support)[1])
                .chain(stopped.iter().map(|&(support, _)| impact.normal[support]));
            impact.unique && impact.pivots > LEAST_PIVOT && signs.all(|sign| sign > self.tolerance)
        };
        (0..=set).any(|acting| acting & !set == 0 && holds(acting))
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
            prescribed_gap_rate: DVector::from_vec(self.values(&kernel.prescribed_gap_rate, &full)),
            applied: DVector::zeros(n),
            rows: (0..rows).map(|row| self.part(row, set)).collect(),
        }
    }

    /// What a row is in an impact of a set.
    fn part(&self, row: usize, set: u64) -> Row {
        let motion = &self.analysis.motion;
        let contacts = motion.contacts.len();
        let slips = motion.rows.len() - motion.tangents.len();
        if !motion.is_closed(row, ClosedSet::without_stick(set)) {
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

    /// Stage by stage, the contacts that act, made to part as they do, need the same impulses and
    /// leave the same rates.
    fn shares(&self, state: &State, collision: &Collision, outcome: &Outcome) -> Met {
        let end = (&outcome.rates, &outcome.impulses);
        let none = DVector::zeros(collision.rows.len());
        let first = outcome.compression.as_ref().map(|(rates, impulses)| (rates, impulses));
        let (mut before, mut given) = (state.clone(), &none);
        for (rates, impulses) in first.into_iter().chain([end]) {
            let Ok(impact) = self.balance(&before, &collision.speed(rates), &(impulses - given)) else {
                return Met::Undetermined;
            };
            if !(impact.unique && outcome.unique && impact.pivots > LEAST_PIVOT) {
                return Met::Undetermined;
            }
            before.rates.copy_from(&impact.rates);
            let n = self.analysis.motion.n;
            let expected = self.full(&before);
            self.close("rates after an impact", rates.as_slice(), &expected.0[n..2 * n]);
            self.impulses(&impact, &(impulses - given));
            given = impulses;
        }
        Met::Compared
    }

    /// The oracle's impact in which the contacts that act part at these speeds.
    fn balance(
        &self,
        before: &State,
        speeds: &DVector<f64>,
        impulses: &DVector<f64>,
    ) -> Result<Impact, Unsolvable> {
        let Motion { contacts, tangents, rows, .. } = &self.analysis.motion;
        let sticks = |contact| {
            let slips = tangents.iter().zip(&impulses.as_slice()[rows.len() - tangents.len()..]);
            slips.into_iter().any(|(&of, &impulse)| of == contact && impulse != 0.0)
        };
        let acts = |contact: &usize| impulses[*contact] > 0.0 || sticks(*contact);
        let targets = (0..contacts.len()).filter(acts).flat_map(|contact| {
            self.supports(1 << contact).into_iter().map(move |support| (support, speeds[contact]))
        });
        let targets: Vec<_> = targets.collect();
        self.sample.assembly.impact(before, &targets, &[])
    }

    fn impulses(&self, impact: &Impact, impulses: &DVector<f64>) {
        let Motion { contacts, tangents, rows, .. } = &self.analysis.motion;
        let slips = rows.len() - tangents.len();
        self.close("impulses", &impulses.as_slice()[..contacts.len()], &self.totals(&impact.normal));
        let tangential = self.totals(&impact.tangential);
        let tangential: Vec<_> = tangents.iter().map(|&contact| tangential[contact]).collect();
        self.close("tangential impulses", &impulses.as_slice()[slips..], &tangential);
    }
}
