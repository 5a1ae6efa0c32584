//! Rates after a collision of which is known which contacts act:
//!
//! ```text
//! M Δu − Jᵀ P = p,    J Δu = −r
//! ```
//!
//! with r = (1 + e) ġ⁻ by Newton's law; by Poisson's r = ġ⁻ first, and then, with p = Jᵀ e Pᶜ, the contacts that act again
//! at r = ġᶜ or none (`contact::impact` has the laws).

use crate::Number;
use crate::linear::solve;
use crate::model::ReplayModel;
use liftoff::model::ContactSet;
use liftoff::system::Equations;

/// A collision at a state.
pub(crate) struct Collision<'a, S: Number> {
    model: &'a ReplayModel<S>,
    equations: Equations<S>,
    state: &'a [S],
    rows: Vec<usize>,
}

/// Rates, and impulses of the rows.
type Answer<S> = (Vec<S>, Vec<S>);

impl<'a, S: Number> Collision<'a, S> {
    /// Of the contacts in `acting`.
    pub(crate) fn new(model: &'a ReplayModel<S>, state: &'a [S], acting: ContactSet) -> Self {
        let layout = model.layout();
        let rows = (0..layout.rows()).filter(|&row| layout.is_closed(row, &acting)).collect();
        Self { model, equations: model.on.system.equations(state), state, rows }
    }

    /// What the laws of impact allow, with `stays` the contacts that are closed afterwards.
    pub(crate) fn answers(&self, applied: &[S], stays: ContactSet) -> Vec<Vec<S>> {
        let layout = self.model.layout();
        let n = layout.coordinates.len();
        let before = &self.state[n..2 * n];
        let restitution = |row: usize| self.model.on.restitution.get(row).copied().unwrap_or(S::ZERO);
        let newton = self.answer(before, applied, &self.rows, |row, speed| speed + restitution(row) * speed);
        let (compressed, impulses) = self.answer(before, applied, &self.rows, |_, speed| speed);
        let mut rebound = vec![S::ZERO; n];
        for (&row, &impulse) in self.rows.iter().zip(&impulses) {
            for (p, &entry) in rebound.iter_mut().zip(self.equations.jacobian(row)) {
                *p = entry.mul_add(restitution(row) * impulse, *p);
            }
        }
        let staying: Vec<_> =
            self.rows.iter().copied().filter(|&row| layout.is_closed(row, &stays)).collect();
        let again = |rows: &[usize]| self.answer(&compressed, &rebound, rows, |_, speed| speed).0;
        vec![newton.0, again(&staying), again(&self.rows)]
    }

    /// The rates after the impulses that make J Δu = −r(row, ġ) of these rows.
    fn answer(&self, before: &[S], force: &[S], rows: &[usize], target: impl Fn(usize, S) -> S) -> Answer<S> {
        let (n, size) = (before.len(), before.len() + rows.len());
        let mut system = vec![vec![S::ZERO; size + 1]; size];
        for i in 0..n {
            system[i][..n].copy_from_slice(self.equations.mass(i));
            system[i][size] = force[i];
        }
        for (k, &row) in (n..).zip(rows) {
            let jacobian = self.equations.jacobian(row);
            for (j, &entry) in jacobian.iter().enumerate() {
                (system[k][j], system[j][k]) = (entry, -entry);
            }
            let along = jacobian.iter().zip(before);
            let speed = along.fold(self.equations.drift()[row], |sum, (&entry, &u)| entry.mul_add(u, sum));
            system[k][size] = -target(row, speed);
        }
        let solution = solve(system);
        (before.iter().zip(&solution).map(|(&u, &change)| u + change).collect(), solution[n..].to_vec())
    }
}

/// (∂r/∂q)ᵀ p of a point by symmetric differences of the fourth order, of steps whose fourth power is rounding.
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
