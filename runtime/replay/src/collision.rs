//! Rates after a collision of which is known which contacts act:
//!
//! ```text
//! M Δu − Jᵀ P = p,    J Δu = −r
//! ```
//!
//! with r = (1 + e) ġ⁻ by Newton's law; by Poisson's r = ġ⁻ first, and then, with p = Jᵀ e Pᶜ, the
//! contacts that act again at r = ġᶜ or none (`contact::impact` has the laws). A contact with
//! friction that sticks has its tangent among the rows, one that slides the column J_N − σ μ J_t
//! for J_N, in each stage by itself; one that strikes alone may follow Routh's path instead.

use crate::Number;
use crate::friction::{self, modes};
use crate::linear::solve;
use crate::model::ReplayModel;
use liftoff_core::model::{ContactSet, SlipState};
use liftoff_core::system::Equations;

/// A collision at a state.
pub(crate) struct Collision<'a, S: Number> {
    pub(crate) model: &'a ReplayModel<S>,
    pub(crate) equations: Equations<S>,
    state: &'a [S],
    slips: Vec<SlipState<S>>,
    /// What acts, with the slips of the end.
    pub(crate) acting: ContactSet,
}

/// Impulses that are given, and the contacts that answer to them.
struct Stage<'b, S> {
    /// What acts, with its slips.
    set: ContactSet,
    /// Of them the contacts that answer.
    answering: ContactSet,
    before: &'b [S],
    force: &'b [S],
}

/// Rates, and the impulse of each row of the kernel.
type Answer<S> = (Vec<S>, Vec<S>);

impl<'a, S: Number> Collision<'a, S> {
    /// Of the contacts in `acting`, which end with these slips.
    pub(crate) fn new(model: &'a ReplayModel<S>, state: &'a [S], acting: ContactSet) -> Self {
        let slips = friction::slips(model, state);
        Self { model, equations: model.on.system.equations(state), state, slips, acting }
    }

    /// What the laws of impact allow, with `stays` the contacts that are closed afterwards.
    pub(crate) fn answers(&self, applied: &[S], stays: ContactSet) -> Vec<Vec<S>> {
        let before = self.before();
        let whole = Stage { set: self.acting, answering: self.acting, before, force: applied };
        let mut all = vec![self.answer(&whole, |row, speed| speed + self.restitution(row) * speed).0];
        for set in modes(self.model.layout(), self.acting) {
            let (compressed, impulses) = self.answer(&Stage { set, ..whole }, |_, speed| speed);
            let rebound = self.rebound(&impulses);
            let again = |answering: ContactSet| {
                let stage = Stage { set: self.acting, answering, before: &compressed, force: &rebound };
                self.answer(&stage, |_, speed| speed).0
            };
            all.extend([again(self.acting.intersection(stays)), again(self.acting)]);
        }
        all.extend(self.along_path());
        all
    }

    pub(crate) fn before(&self) -> &'a [S] {
        let n = self.model.layout().coordinates.len();
        &self.state[n..2 * n]
    }

    /// e of a contact.
    pub(crate) fn restitution(&self, row: usize) -> S {
        let of_contact =
            self.model.on.restitution.get(row).filter(|_| row < self.model.layout().contacts.len());
        of_contact.copied().unwrap_or(S::ZERO)
    }

    /// μ of an entry of the frictions while it slides.
    pub(crate) fn kinetic(&self, entry: usize) -> S {
        self.slips[entry].kinetic
    }

    /// σ μ of a contact that slides; none where it sticks or has no friction.
    fn sliding(&self, set: &ContactSet, contact: usize) -> Option<(usize, S)> {
        let mut sliding = self.model.layout().sliding(set);
        let (entry, friction) = sliding.find(|(_, friction)| friction.contact == contact)?;
        Some((friction.row, S::ratio(set.sense(contact), 1) * self.slips[entry].kinetic))
    }

    /// What an impulse of a row does to the momenta: J_N − σ μ J_t of a contact that slides.
    fn column(&self, set: &ContactSet, row: usize) -> Vec<S> {
        let normal = self.equations.jacobian(row);
        let is_contact = row < self.model.layout().contacts.len();
        match self.sliding(set, row).filter(|_| is_contact) {
            Some((tangent, mu)) => {
                let along = normal.iter().zip(self.equations.jacobian(tangent));
                along.map(|(&normal, &tangent)| (-mu).mul_add(tangent, normal)).collect()
            }
            None => normal.to_vec(),
        }
    }

    /// (J_N − σ μ J_t)ᵀ e Pᶜ.
    fn rebound(&self, impulses: &[S]) -> Vec<S> {
        let mut rebound = vec![S::ZERO; self.before().len()];
        for row in self.acting.iter() {
            let given = self.restitution(row) * impulses[row];
            let column = self.column(&self.acting, row);
            rebound.iter_mut().zip(column).for_each(|(p, entry)| *p = entry.mul_add(given, *p));
        }
        rebound
    }

    /// The rates after the impulses that make J Δu = −r(row, ġ) of the rows that answer.
    fn answer(&self, stage: &Stage<'_, S>, target: impl Fn(usize, S) -> S) -> Answer<S> {
        let layout = self.model.layout();
        let answers = |row: usize| row >= layout.contacts.len() || stage.answering.contains(row);
        let rows = (0..layout.rows()).filter(|&row| layout.is_closed(row, &stage.set) && answers(row));
        let rows: Vec<usize> = rows.collect();
        let right: Vec<S> = rows.iter().map(|&row| -target(row, self.speed(row, stage.before))).collect();
        let columns: Vec<_> = rows.iter().map(|&row| self.column(&stage.set, row)).collect();
        let (change, found) = self.response((&rows, &columns), stage.force, &right);
        let mut impulses = vec![S::ZERO; layout.rows()];
        rows.iter().zip(found).for_each(|(&row, impulse)| impulses[row] = impulse);
        (stage.before.iter().zip(&change).map(|(&u, &change)| u + change).collect(), impulses)
    }

    /// ġ of a row.
    pub(crate) fn speed(&self, row: usize, rates: &[S]) -> S {
        let along = self.equations.jacobian(row).iter().zip(rates);
        along.fold(self.equations.prescribed_gap_rate()[row], |sum, (&entry, &u)| entry.mul_add(u, sum))
    }

    /// Δu and P of M Δu − Σ columnᵀ P = p, J Δu = right.
    pub(crate) fn response(
        &self,
        (rows, columns): (&[usize], &[Vec<S>]),
        force: &[S],
        right: &[S],
    ) -> (Vec<S>, Vec<S>) {
        let (n, size) = (force.len(), force.len() + rows.len());
        let mut system = vec![vec![S::ZERO; size + 1]; size];
        for i in 0..n {
            system[i][..n].copy_from_slice(self.equations.mass(i));
            system[i][size] = force[i];
        }
        for (k, ((&row, column), &right)) in (n..).zip(rows.iter().zip(columns).zip(right)) {
            system[k][..n].copy_from_slice(self.equations.jacobian(row));
            column.iter().enumerate().for_each(|(j, &entry)| system[j][k] = -entry);
            system[k][size] = right;
        }
        let mut solution = solve(system);
        let impulses = solution.split_off(n);
        (solution, impulses)
    }
}

/// (∂r/∂q)ᵀ p of a point by symmetric differences of the fourth order, of steps whose fourth power
/// is rounding.
pub(crate) fn generalised<S: Number>(
    model: &ReplayModel<S>,
    state: &[S],
    point: usize,
    impulse: [f64; 2],
) -> Vec<S> {
    let work = |j: usize, step: S| {
        let mut moved = state.to_vec();
        moved[j] = moved[j] + step;
        let points = model.points(&moved);
        let along = |axis: usize| points[2 * point + axis] * S::from_f64(impulse[axis]);
        along(0) + along(1)
    };
    let derivative = |j: usize| {
        let h = S::from_f64(S::EPSILON.to_f64().powf(0.2) * model.units[j]);
        let difference = |h: S| work(j, h) - work(j, -h);
        let eight = S::ratio(8, 1);
        (eight * difference(h) - difference(h + h)) / (S::ratio(12, 1) * h)
    };
    (0..model.layout().coordinates.len()).map(derivative).collect()
}
