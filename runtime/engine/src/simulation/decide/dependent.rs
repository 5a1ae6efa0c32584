//! Contacts that depend on each other only where the phase begins: at a singular position, such as
//! that of straight legs, where the gap rows of several are multiples of one another. The
//! accelerations there say nothing of which of them bear the motion that follows, and with some
//! choices others sink into their grounds:
//!
//! ```text
//! J_s = Σ c_b J_b,   g_b = 0 ⇒ g̈_s = 0, but g_s < 0 later
//! ```
//!
//! Such a phase is first integrated on trial. What sinks takes the place of the one it depends on
//! most.

use nalgebra::{DMatrix, DVector};

use crate::context::CLOSED;
use crate::model::{ContactSet, Form};
use crate::numerics::decomposition::singular_values;
use crate::simulation::snapshot::Snapshot;

/// A position is singular if contacts that depend on each other there no longer do at one this far
/// away, in natural units.
const ASIDE: f64 = 1e-4;
/// What their gap rows change by on that way, relative to it: less is rounding.
const SLIGHT: f64 = 1e-3;
/// Nearer to a singular position than this the rounding of rates, some 1e-11/σ², moves reactions by
/// more than a thousandth.
const BLURRED: f64 = 1e-4;

impl Snapshot<'_> {
    /// Whether the contacts that bear a phase with multipliers all but depend on each other, so
    /// that rounding decides which reaction reaches zero: σ of their rows of J in natural units,
    /// each of length 1.
    pub(in crate::simulation) fn is_blurred(&self) -> bool {
        let (context, layout) = (&self.setup.context, self.layout());
        let rows: Vec<usize> =
            (0..layout.rows()).filter(|&row| layout.is_closed(row, &self.active_basis())).collect();
        if self.phase.info().form == Form::Reduced || rows.len() < 2 {
            return false;
        }
        let equations = context.system().equations(&self.state);
        let unit = |j: usize| context.scales.coordinate(&layout.coordinates[j]);
        let mut jacobian = DMatrix::from_fn(rows.len(), layout.coordinates.len(), |i, j| {
            equations.jacobian(rows[i])[j] * unit(j)
        });
        jacobian.row_iter_mut().for_each(|mut row| _ = row.try_normalize_mut(f64::MIN_POSITIVE));
        singular_values(jacobian).iter().any(|sigma| *sigma < BLURRED)
    }

    /// Closed contacts that may open, and depend on those that bear.
    fn dependent(&self) -> ContactSet {
        let dependent = self.closed().difference(self.active_basis()).difference(self.contacts.held());
        let kind = |i: &usize| self.layout().contacts[*i].kind;
        dependent.iter().filter(|i| kind(i).is_one_sided()).collect()
    }

    /// Half the bound of a gap: the event that ends a phase may come before the gap has left it.
    fn parting_bound(&self, contact: usize) -> f64 {
        let unit = self.layout().unit(contact, self.setup.context.scales.length);
        0.5 * CLOSED.min(self.relative_bound()) * unit
    }

    /// Which of them has sunk deepest in a later state of the phase, and goes on to sink.
    pub(in crate::simulation) fn deepest_dependent(&self, later: &[f64]) -> Option<usize> {
        let equations = self.setup.context.system().equations(later);
        let n = self.layout().coordinates.len();
        let gap = |i: usize| equations.gap()[i];
        let sinks =
            |&i: &usize| gap(i) < -self.parting_bound(i) && equations.gap_rate(i, &later[n..2 * n]) < 0.0;
        self.dependent().iter().filter(sinks).min_by(|&i, &k| gap(i).total_cmp(&gap(k)))
    }

    /// Which of them have parted in a later state of the phase: the event may be that of one of
    /// them, and others, such as its image, reach the bound with it but for rounding.
    pub(in crate::simulation) fn parted_dependent(&self, later: &[f64]) -> ContactSet {
        let equations = self.setup.context.system().equations(later);
        let parts = |&i: &usize| equations.gap()[i] > self.parting_bound(i);
        self.dependent().iter().filter(parts).collect()
    }

    /// Whether some of them depend on those that bear only here.
    pub(in crate::simulation) fn is_singular(&self) -> bool {
        let dependent = self.dependent();
        if dependent.is_empty() {
            return false;
        }
        let context = &self.setup.context;
        let scales = &context.scales;
        let mut aside = self.state.clone();
        for (i, q) in aside.iter_mut().enumerate().take(self.layout().coordinates.len()) {
            *q += ASIDE * scales.entry(self.layout(), i) * (1.0 + i as f64).cos();
        }
        context.system().project(self.active_basis(), &mut aside, scales.length);
        dependent.iter().any(|contact| self.parts(&aside, contact).1 > SLIGHT * ASIDE)
    }

    /// The gap row of a contact as a combination of those of the contacts that bear and of the
    /// joints, and the size of what is left of it, in natural units.
    fn parts(&self, state: &[f64], contact: usize) -> (DVector<f64>, f64) {
        let (context, layout) = (&self.setup.context, self.layout());
        let equations = context.system().equations(state);
        let entry = |row: usize, i: usize| {
            equations.jacobian(row)[i] * context.scales.entry(layout, i) / context.scales.length
        };
        let rows: Vec<usize> =
            self.active_basis().iter().chain(layout.contacts.len()..layout.rows()).collect();
        let n = layout.coordinates.len();
        let columns = DMatrix::from_fn(n, rows.len(), |i, k| entry(rows[k], i));
        let own = DVector::from_fn(n, |i, _| entry(contact, i));
        if rows.is_empty() {
            let left = own.amax();
            return (DVector::zeros(0), left);
        }
        let inverse = columns.clone().pseudo_inverse(SLIGHT * ASIDE);
        let parts = inverse.map_or_else(|_| DVector::zeros(rows.len()), |inverse| inverse * &own);
        let left = (own - columns * &parts).amax();
        (parts, left)
    }

    /// Those that bear, with one that sinks in place of the one that it depends on most; none if
    /// one of them would pull then.
    pub(in crate::simulation) fn exchanged(&self, sunk: usize) -> Option<ContactSet> {
        let bearing: Vec<usize> = self.active_basis().iter().collect();
        let (parts, _) = self.parts(&self.state, sunk);
        let replaced = (0..bearing.len()).max_by(|&a, &b| parts[a].abs().total_cmp(&parts[b].abs()))?;
        let set = self.active_basis().difference(ContactSet::EMPTY.with(bearing[replaced])).with(sunk);
        let (reactions, bound) = self.reactions_at(&self.state, set);
        set.iter().all(|i| reactions[i] >= -bound).then_some(set)
    }
}
