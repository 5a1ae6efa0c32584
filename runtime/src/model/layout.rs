//! Names of a model and how they belong together.

use super::ContactSet;

/// A generalised coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    /// Its name; the rate is named with a prime in text (`phi'`).
    pub name: &'static str,
    /// Whether it is an angle (rad) or a length.
    pub is_angle: bool,
}

/// Supports whose gaps are one function of the coordinates: one contact, one reaction.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Its members joined by commas, `A, E`.
    pub label: &'static str,
    /// The supports in declaration order.
    pub supports: &'static [&'static str],
    /// Whether the members bear equal shares (mirror images, or a single support).
    /// Otherwise only their total is determined.
    pub shared: bool,
    /// Index of the contact's foot among [`BarSystem::feet`](super::BarSystem::feet) when a bar lies on a corner.
    pub foot: Option<usize>,
    /// Support or thread.
    pub kind: ContactKind,
    /// Whether it admits no slip while closed; its tangential row is in [`Layout::tangents`].
    pub rough: bool,
    /// The law of its impacts; the coefficient is in [`BarSystem::restitution`](super::BarSystem::restitution).
    pub law: Law,
    /// Whether reaching it ends a run.
    pub stop: bool,
}

/// What a contact is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactKind {
    /// It pushes.
    Support,
    /// It pulls.
    Thread,
}

/// What restitution relates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Law {
    /// Velocities: ġ⁺ = −e ġ⁻.
    Newton,
    /// Impulses: P = (1 + e) Pᶜ, with the impulse Pᶜ of the plastic compression.
    Poisson,
}

/// A bar, for drawings.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// Its name.
    pub name: &'static str,
    /// Index of its first point.
    pub from: usize,
    /// Index of its last point.
    pub to: usize,
}

/// A model's names.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// The struct's name.
    pub name: &'static str,
    /// The declaration that the equations were derived from, as source text.
    pub declaration: &'static str,
    /// The first paragraph of its documentation.
    pub summary: &'static str,
    /// Parameters in the order of [`BarSystem::parameters`](super::BarSystem::parameters).
    pub parameters: &'static [&'static str],
    /// Generalised coordinates; a state holds their values, then their rates, then the time if [`Self::timed`].
    pub coordinates: &'static [Coordinate],
    /// One-sided contacts; the first rows of the kernel.
    pub contacts: &'static [Contact],
    /// Two-sided constraints kept as multipliers; the rows after the contacts, closed in every phase.
    pub joints: &'static [&'static str],
    /// The contact of each tangential row, which is closed with it; the rows after the joints. They have no gap.
    pub tangents: &'static [usize],
    /// Whether the equations depend on time.
    pub timed: bool,
    /// Names of what [`BarSystem::quantity`](super::BarSystem::quantity) computes: `fx(D, AD)`, `shear(S)`.
    pub quantities: &'static [&'static str],
    /// Points in the order of [`BarSystem::points`](super::BarSystem::points).
    pub points: &'static [&'static str],
    /// Bars.
    pub bars: &'static [Bar],
    /// The contact sets that have a closed form.
    pub closed_forms: &'static [ContactSet],
}

impl Layout {
    /// The number of rows of the kernel.
    pub const fn rows(&self) -> usize {
        self.contacts.len() + self.joints.len() + self.tangents.len()
    }

    /// Whether a row of the kernel is closed in a contact set.
    pub const fn is_closed(&self, row: usize, set: ContactSet) -> bool {
        let tangents = self.contacts.len() + self.joints.len();
        if row < self.contacts.len() {
            set.contains(row)
        } else {
            row < tangents || set.contains(self.tangents[row - tangents])
        }
    }
}
