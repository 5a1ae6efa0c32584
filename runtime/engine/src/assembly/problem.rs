//! Gaps and their Jacobian at a position, for the search of a start.

use core::cell::RefCell;
use std::rc::Rc;

use nalgebra::{DMatrix, DVector};

use super::StartError;
use crate::context::{CLOSED, RunContext};
use crate::expression::Switches;
use crate::model::{Contact, ContactKind, ContactSet, Layout};
use crate::numerics::zero::roundoff;
use crate::system::Equations;

/// Roundoff of a foot's distance from the end of its bar, in natural lengths.
const ROUNDED: f64 = roundoff(16.0);

/// A model with its nominal figure.
pub(super) struct AssemblyProblem<'a> {
    pub(super) context: &'a RunContext,
    switches: &'a Switches,
    /// How deep contacts may be penetrated, in natural lengths.
    pub(super) deepest: f64,
    /// The rates that are given, zero where none is.
    pub(super) rates: Vec<f64>,
    /// When the motion begins.
    pub(super) t: f64,
    /// Contacts that have gone round an end of their edges and are below these.
    below: ContactSet,
    last: RefCell<Option<KnownEquations>>,
}

/// The last position asked for, and what holds there.
struct KnownEquations {
    position: Vec<f64>,
    equations: Rc<Equations<f64>>,
}

impl<'a> AssemblyProblem<'a> {
    /// With so deep penetrations in natural lengths, these rates, what is below its edge, and this
    /// time.
    pub(super) fn new(
        (context, switches): (&'a RunContext, &'a Switches),
        deepest: f64,
        (rates, below): (Vec<f64>, ContactSet),
        t: f64,
    ) -> Self {
        Self { context, switches, deepest, rates, t, below, last: RefCell::new(None) }
    }

    pub(super) fn layout(&self) -> &'static Layout {
        self.context.layout()
    }

    /// The full state at a position, at rest.
    fn at_rest(&self, positions: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; 2 * positions.len()];
        values[..positions.len()].copy_from_slice(positions);
        self.layout().state_at(&values, self.t)
    }

    /// M and all rows at a position, at rest.
    pub(super) fn rows(&self, positions: &[f64]) -> Rc<Equations<f64>> {
        let mut last = self.last.borrow_mut();
        match &*last {
            Some(KnownEquations { position, equations }) if position == positions => Rc::clone(equations),
            _ => {
                let equations = Rc::new(self.context.system().equations(&self.at_rest(positions)));
                *last =
                    Some(KnownEquations { position: positions.to_vec(), equations: Rc::clone(&equations) });
                equations
            }
        }
    }

    /// A gap no larger is closed, in its natural unit: [`CLOSED`], or the rounding of the terms
    /// that it is a sum of.
    pub(super) fn closed_below(&self, positions: &[f64], row: usize) -> f64 {
        CLOSED.max(self.context.rounding(&self.rows(positions), row, positions))
    }

    /// The natural unit of a row's gap.
    pub(super) fn unit(&self, row: usize) -> f64 {
        self.layout().unit(row, self.context.scales.length)
    }

    /// Gaps of rows, in natural units.
    pub(super) fn gaps(&self, positions: &[f64], closed: &[usize]) -> DVector<f64> {
        let rows = self.rows(positions);
        DVector::from_fn(closed.len(), |i, _| rows.gap()[closed[i]] / self.unit(closed[i]))
    }

    /// Derivatives of the gaps of rows by coordinates, in natural units.
    pub(super) fn jacobian(&self, positions: &[f64], (closed, by): (&[usize], &[usize])) -> DMatrix<f64> {
        let rows = self.rows(positions);
        let unit = |k: usize| self.context.scales.coordinate(&self.layout().coordinates[k]);
        let entry = |i: usize, k: usize| rows.jacobian(i)[k] * unit(k) / self.unit(i);
        DMatrix::from_fn(closed.len(), by.len(), |i, k| entry(closed[i], by[k]))
    }

    /// The rows of `set` and of guides that have a gap, and all joints.
    pub(super) fn closed(&self, set: ContactSet) -> Vec<usize> {
        let contacts = self.layout().contacts.len();
        set.union(self.layout().guides())
            .iter()
            .chain(contacts..contacts + self.layout().joints.len())
            .collect()
    }

    /// All rows that hold rates while `set` is closed.
    pub(super) fn tied(&self, set: ContactSet) -> Vec<usize> {
        let set = set.union(self.layout().guides());
        (0..self.layout().rows()).filter(|&row| self.layout().is_closed(row, &set)).collect()
    }

    pub(super) fn contact(&self, i: usize) -> String {
        self.layout().contacts[i].label.to_owned()
    }

    /// The name of a joint or a guide, or of the contact whose tangent it is, given its row.
    pub(super) fn joint(&self, row: usize) -> String {
        let joints = self.layout().joints;
        let Some(joint) = row.checked_sub(self.layout().contacts.len()) else {
            return match self.layout().contacts[row].kind {
                ContactKind::Guide => format!("slider {}", self.contact(row)),
                _ => self.contact(row),
            };
        };
        joints.get(joint).map_or_else(
            || {
                format!(
                    "the grip of {}",
                    self.layout().contacts[self.layout().tangents[joint - joints.len()]].label
                )
            },
            |joint| joint.name.to_owned(),
        )
    }

    /// Corners beyond the ends of their bars or below these, and contacts that are not there.
    pub(super) fn absent(&self, positions: &[f64]) -> ContactSet {
        let outside = -CLOSED * self.context.scales.length;
        let off = match self.layout().feet() {
            0 => ContactSet::EMPTY,
            _ => self.context.find_beyond_end(&self.at_rest(positions), outside),
        };
        let state = self.layout().state_at(&[positions, &self.rates[..]].concat(), self.t);
        off.union(self.below).union(self.switches.disarmed(self.context, &state, self.t))
    }

    /// How deep the one-sided contacts of a set are penetrated, m, ≥ 0.
    pub(super) fn depth(&self, positions: &[f64], set: ContactSet) -> f64 {
        let two_sided = self.layout().guides().union(self.layout().drives());
        let rows = self.rows(positions);
        set.difference(two_sided).iter().map(|i| -rows.gap()[i]).fold(0.0, f64::max)
    }

    /// Checks that what is said to be below its edge is.
    pub(super) fn check_below(&self, positions: &[f64]) -> Result<(), StartError> {
        if self.below.is_empty() {
            return Ok(());
        }
        let rows = self.rows(positions);
        match self.below.iter().find(|&i| rows.gap()[i] >= 0.0) {
            Some(i) => {
                let support = self.layout().contacts[i].supports[0].to_owned();
                Err(StartError::NotBelow { support, value: 1.0 })
            }
            None => Ok(()),
        }
    }

    /// Refuses penetrated contacts, by the deepest one. A corner beyond the end of its bar
    /// penetrates nothing.
    pub(super) fn refuse_penetration(&self, positions: &[f64], off: ContactSet) -> Result<(), StartError> {
        let rows = self.rows(positions);
        let gap = rows.gap();
        match self.find_penetrated(positions, off).iter().min_by(|&a, &b| gap[a].total_cmp(&gap[b])) {
            Some(deepest) => Err(self.penetration(deepest, gap[deepest])),
            None => Ok(()),
        }
    }

    /// The penetrated contacts, those that are `off` left out.
    pub(super) fn find_penetrated(&self, positions: &[f64], off: ContactSet) -> ContactSet {
        let rows = self.rows(positions);
        let two_sided = self.layout().guides().union(self.layout().drives());
        let on = (0..self.layout().contacts.len()).filter(|&i| !off.contains(i) && !two_sided.contains(i));
        let bound = |i: usize| self.deepest.max(self.closed_below(positions, i)) * self.unit(i);
        on.filter(|&i| rows.gap()[i] < -bound(i)).collect()
    }

    /// What is wrong with a contact whose gap is negative.
    pub(super) fn penetration(&self, contact: usize, gap: f64) -> StartError {
        let Contact { kind, foot, supports, .. } = self.layout().contacts[contact];
        match kind {
            ContactKind::Support if foot.is_some() => {
                StartError::BelowEdge { support: self.contact(contact), name: supports[0], depth: -gap }
            }
            ContactKind::Support | ContactKind::AngleLimit => {
                StartError::Penetrates { support: self.contact(contact), depth: -gap }
            }
            // Of those that hold both ways the gaps are none.
            ContactKind::Guide | ContactKind::Hinge { .. } | ContactKind::Drive | ContactKind::Turn => {
                StartError::Broken { joint: self.joint(contact), gap }
            }
            ContactKind::Thread => StartError::Short { thread: self.contact(contact), gap },
        }
    }

    pub(super) fn refuse_feet_off_bars(&self, state: &[f64], touching: ContactSet) -> Result<(), StartError> {
        let mut feet = vec![0.0; 2 * self.layout().feet()];
        self.context.system().feet(state, &mut feet);
        for i in touching.iter() {
            let Some(foot) = self.layout().contacts[i].foot else { continue };
            let ends = [("first", feet[2 * foot]), ("last", feet[2 * foot + 1])];
            let margin = ends[0].1.min(ends[1].1);
            let [digits, rounding] = [CLOSED, ROUNDED].map(|part| part * self.context.scales.length);
            if let Some((end, _)) = ends.iter().find(|(_, x)| (-digits..=rounding).contains(x)) {
                return Err(StartError::AtEnd { support: self.contact(i), end });
            }
            if margin < -digits {
                return Err(StartError::OffBar { support: self.contact(i), distance: -margin });
            }
        }
        Ok(())
    }
}
