//! Values of functions of a phase at one place.

use smallvec::smallvec;

use crate::contact::friction::LastMargin;
use crate::context::{Numbers, Slips};
use crate::integration::phase_point::PhasePoint;
use crate::model::{Layout, SlipState};

/// Functions of a phase that guards follow from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Quantities(u8);

impl Quantities {
    pub(super) const NONE: Self = Self(0);
    pub(super) const REACTIONS: Self = Self(1);
    pub(super) const GAPS: Self = Self(2);
    pub(super) const FEET: Self = Self(4);
    pub(super) const SLIPS: Self = Self(8);
    pub(super) const GRIP: Self = Self(16);

    pub(super) const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether all of another are among them.
    pub(super) const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

/// Values of functions of a phase at one place; those not asked for are of another one.
#[derive(Default)]
pub(crate) struct Sample {
    /// Reactions of all contacts, then friction forces.
    pub(super) reactions: Numbers,
    pub(super) gaps: Numbers,
    pub(super) feet: Numbers,
    pub(super) slips: Slips,
    pub(super) grip: f64,
}

impl Sample {
    pub(super) fn new(layout: &Layout) -> Self {
        let still = SlipState { velocity: 0.0, kinetic: 0.0, limit: 0.0 };
        Self {
            reactions: smallvec![0.0; layout.reactions()],
            gaps: smallvec![0.0; layout.contacts.len()],
            feet: smallvec![0.0; 2 * layout.feet()],
            slips: smallvec![still; layout.frictions.len()],
            grip: 0.0,
        }
    }
}

/// What evaluations work in.
#[derive(Default)]
pub(crate) struct Scratch {
    pub(super) reduced: Numbers,
    pub(super) state: Numbers,
    pub(super) last_grip: LastMargin,
    /// A point of the phase, made when a condition is first evaluated.
    pub(super) point: Option<PhasePoint>,
}

impl Scratch {
    pub(super) fn new(layout: &Layout) -> Self {
        Self { state: smallvec![0.0; layout.entries()], ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_are_a_set() {
        let all = [1, 2, 4, 8, 16].map(Quantities);
        let some = Quantities::GAPS.and(Quantities::GRIP);
        assert!(
            all.iter().all(|one| some.contains(*one) == [Quantities::GAPS, Quantities::GRIP].contains(one))
        );
        assert!(some.contains(some) && some.contains(Quantities::NONE) && !Quantities::GAPS.contains(some));
    }
}
