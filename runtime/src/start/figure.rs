//! Gaps and their slopes at a position, for the search of a start.

use nalgebra::{DMatrix, DVector};

use super::CLOSED;
use crate::error::StartError;
use crate::model::{Array, BarSystem, ContactKind, ContactSet, KernelView};
use crate::moment::state_at;
use crate::scales::Scales;

/// A model with its nominal figure.
pub(super) struct Figure<'a, M: BarSystem> {
    pub(super) constants: &'a M::Constants<f64>,
    pub(super) nominal: &'a [f64],
    pub(super) scales: &'a Scales,
}

/// All rows at a position: contacts, then joints.
pub(super) struct Rows {
    pub(super) gap: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) drift: DVector<f64>,
    pub(super) mass: DMatrix<f64>,
}

impl<M: BarSystem> Figure<'_, M> {
    pub(super) fn rows(&self, positions: &[f64]) -> Rows {
        let n = positions.len();
        let state = M::State::from_fn(|i| if i < n { positions[i] } else { 0.0 });
        let kernel = M::kernel(self.constants, &state);
        let count = kernel.gap().len();
        Rows {
            gap: DVector::from_row_slice(kernel.gap()),
            drift: DVector::from_row_slice(kernel.drift()),
            jacobian: DMatrix::from_fn(count, n, |i, j| kernel.jacobian(i)[j]),
            mass: DMatrix::from_fn(n, n, |i, j| kernel.mass(i)[j]),
        }
    }

    /// The rows of `set` that have a gap, and all joints.
    pub(super) fn closed(&self, set: ContactSet) -> Vec<usize> {
        let contacts = M::LAYOUT.contacts.len();
        set.iter().chain(contacts..contacts + M::LAYOUT.joints.len()).collect()
    }

    /// All rows that hold rates while `set` is closed.
    pub(super) fn tied(&self, set: ContactSet) -> Vec<usize> {
        (0..M::LAYOUT.rows()).filter(|&row| M::LAYOUT.is_closed(row, set)).collect()
    }

    pub(super) fn contact(&self, i: usize) -> String {
        M::LAYOUT.contacts[i].label.to_owned()
    }

    /// The name of a joint, or of the contact whose tangent it is, given its row.
    pub(super) fn joint(&self, row: usize) -> String {
        let joints = M::LAYOUT.joints;
        let joint = row - M::LAYOUT.contacts.len();
        joints.get(joint).map_or_else(
            || format!("the grip of {}", M::LAYOUT.contacts[M::LAYOUT.tangents[joint - joints.len()]].label),
            |name| (*name).to_owned(),
        )
    }

    /// Corners beyond the ends of their bars.
    pub(super) fn beyond_ends(&self, positions: &[f64]) -> ContactSet {
        let feet =
            M::feet(self.constants, &state_at::<M>(&[positions, &vec![0.0; positions.len()]].concat(), 0.0));
        let beyond = |x: &f64| *x < -CLOSED * self.scales.length;
        let off = |i: &usize| {
            let foot = M::LAYOUT.contacts[*i].foot;
            foot.is_some_and(|k| feet.as_ref()[2 * k..2 * k + 2].iter().any(beyond))
        };
        (0..M::LAYOUT.contacts.len()).filter(off).fold(ContactSet::EMPTY, ContactSet::with)
    }

    /// The open side of every contact, or the deepest penetration; a corner beyond the end of its bar has no side.
    pub(super) fn refuse_penetration(&self, gap: &DVector<f64>, off: ContactSet) -> Result<(), StartError> {
        let on = (0..M::LAYOUT.contacts.len()).filter(|&i| !off.contains(i));
        let deepest = on.min_by(|&a, &b| gap[a].total_cmp(&gap[b]));
        match deepest {
            Some(i) if gap[i] < -CLOSED * self.scales.length => Err(match M::LAYOUT.contacts[i].kind {
                ContactKind::Support => StartError::Penetrates { support: self.contact(i), depth: -gap[i] },
                ContactKind::Thread => StartError::Short { thread: self.contact(i), gap: gap[i] },
            }),
            _ => Ok(()),
        }
    }

    pub(super) fn refuse_feet_off_bars(
        &self,
        state: &M::State<f64>,
        touching: ContactSet,
    ) -> Result<(), StartError> {
        let feet = M::feet(self.constants, state);
        for i in touching.iter() {
            let Some(foot) = M::LAYOUT.contacts[i].foot else { continue };
            let ends = [("first", feet.as_ref()[2 * foot]), ("last", feet.as_ref()[2 * foot + 1])];
            let margin = ends[0].1.min(ends[1].1);
            if let Some((end, _)) = ends.iter().find(|(_, x)| x.abs() <= CLOSED * self.scales.length) {
                return Err(StartError::AtEnd { support: self.contact(i), end });
            }
            if margin < -CLOSED * self.scales.length {
                return Err(StartError::OffBar { support: self.contact(i), distance: -margin });
            }
        }
        Ok(())
    }
}
