//! What may end a step.

use super::{Follower, Number, Touch};
use crate::expansion::Expansion;
use crate::numerics::root::{first, value};
use liftoff_core::scalar::{Real, Scalar};

/// What has become zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Guard {
    Gap(usize),
    Reaction(usize),
    Foot(usize),
    /// A condition is met.
    Met(usize),
    /// A condition is no longer true.
    Over(usize),
}

/// Roots nearer than this part of a step are one event: a start in doubles tells no more of their
/// order.
const TOGETHER: f64 = 1e-13;

impl Follower<'_> {
    /// The first roots within a step, and when.
    pub(super) fn roots(&self, expansion: &Expansion<Number>, h: Number) -> Option<(Number, Vec<Guard>)> {
        let mut all: Vec<(Number, Guard)> = Vec::new();
        for (i, touch) in self.touches.iter().enumerate() {
            let contact = &self.scene.contacts[i];
            match *touch {
                Touch::Open(order) => {
                    let Some(gap) = contact.row.value else { continue };
                    let root = first(&expansion.series.coefficients(gap)[order..], h)
                        .filter(|&s| self.meets(expansion, i, s));
                    all.extend(root.map(|s| (s, Guard::Gap(i))));
                }
                Touch::Bearing(_) | Touch::Held => {
                    if let Touch::Bearing(order) = *touch {
                        let reaction = expansion.reaction(i);
                        let root = reaction.get(order..).and_then(|series| first(series, h));
                        all.extend(root.map(|s| (s, Guard::Reaction(i))));
                    }
                    for end in contact.foot.into_iter().flatten() {
                        all.extend(first(expansion.series.coefficients(end), h).map(|s| (s, Guard::Foot(i))));
                    }
                }
                Touch::Idle | Touch::Beyond | Touch::Removed | Touch::Resting => {}
            }
        }
        self.met(expansion, h, &mut all);
        let earliest = all.iter().map(|(s, _)| *s).reduce(|a, b| if b < a { b } else { a })?;
        let window = h * Number::from_f64(TOGETHER);
        all.retain(|(s, _)| (*s - earliest).abs() <= window);
        Some((earliest, all.into_iter().map(|(_, guard)| guard).collect()))
    }

    /// Whether a corner is under its bar.
    fn meets(&self, expansion: &Expansion<Number>, contact: usize, s: Number) -> bool {
        let ends = self.scene.contacts[contact].foot.into_iter().flatten();
        ends.into_iter().all(|end| value(expansion.series.coefficients(end), s) >= Number::ZERO)
    }

    /// Corners that have passed the end of their bar, or come back over it.
    pub(super) fn corners(&mut self) -> Result<(), super::NotJudged> {
        if self.scene.contacts.iter().all(|contact| contact.foot.is_none()) {
            return Ok(());
        }
        let expansion = Expansion::new(self.scene, &self.state);
        for i in 0..self.touches.len() {
            let contact = &self.scene.contacts[i];
            let (Some(foot), Some(gap)) = (contact.foot, contact.row.value) else { continue };
            let gap = expansion.series.get(gap, 0).to_f64();
            let inside = foot.iter().all(|&end| expansion.series.get(end, 0) >= Number::ZERO);
            let small = 1e-20 * self.scene.length;
            match self.touches[i] {
                Touch::Open(_) if gap < -small && !inside => self.touches[i] = Touch::Beyond,
                Touch::Beyond if gap > small => self.touches[i] = Touch::Open(0),
                Touch::Beyond if inside && gap < -small => return Err(super::NotJudged::Corner(self.t())),
                _ => {}
            }
        }
        Ok(())
    }
}
