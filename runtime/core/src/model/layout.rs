//! Names of a model and how they belong together.

use super::{ContactSet, Defaults, Geometry, Quantity, Slip};

/// A generalised coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    /// Its name; the rate is named with a prime in text (`phi'`).
    pub name: &'static str,
    /// Whether it is an angle (rad) or a length.
    pub is_angle: bool,
}

/// A declared angle that follows coordinates, `phi` of `equal(phi, -2 * psi)`:
/// `quarters` π/2 + Σ factor parameter + Σ factor coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DependentAngle {
    /// Its name.
    pub name: &'static str,
    /// Quarter turns, so that in the nominal figure it is within half a turn.
    pub quarters: i32,
    /// Of parameters.
    pub parameters: &'static [Term],
    /// Of coordinates.
    pub coordinates: &'static [Term],
}

/// One term of a linear combination.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Term {
    /// Which parameter or coordinate.
    pub index: usize,
    /// How often it is taken.
    pub factor: i32,
}

impl DependentAngle {
    /// Its value with these parameters and coordinates.
    pub fn value(&self, parameters: &[f64], positions: &[f64]) -> f64 {
        self.constant(parameters) + sum(self.coordinates, positions)
    }

    /// Its rate with these rates of the coordinates.
    pub fn rate(&self, rates: &[f64]) -> f64 {
        sum(self.coordinates, rates)
    }

    /// What it is where the coordinates are zero.
    pub fn constant(&self, parameters: &[f64]) -> f64 {
        f64::from(self.quarters) * core::f64::consts::FRAC_PI_2 + sum(self.parameters, parameters)
    }
}

fn sum(terms: &[Term], values: &[f64]) -> f64 {
    terms.iter().fold(0.0, |sum, term| sum + f64::from(term.factor) * values[term.index])
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
    /// Index of the contact's foot among [`BarSystem::feet`](super::BarSystem::feet) when a bar
    /// lies on a corner.
    pub foot: Option<usize>,
    /// Support or thread.
    pub kind: ContactKind,
    /// Whether it admits no slip while closed; its tangential row is in [`Layout::tangents`].
    pub rough: bool,
    /// The entry of its friction in [`Layout::frictions`], if it has any.
    pub friction: Option<usize>,
    /// Whether a run ends where no reaction obeys its law of friction; else an impact without
    /// collision ends its slip.
    pub jams: bool,
    /// The law of its impacts; the coefficient is in
    /// [`BarSystem::restitution`](super::BarSystem::restitution).
    pub law: Law,
    /// Whether reaching it ends a run.
    pub stop: bool,
    /// The condition that it is there on, as conditions of runs are written; always if absent.
    pub armed: Option<&'static str>,
    /// The condition that ends it; never if absent.
    pub breaks: Option<&'static str>,
}

impl Contact {
    /// Whether it is a hinge with friction, whose row of the kernel is empty: joints, or the
    /// coordinates themselves, hold it.
    pub const fn is_hinge(&self) -> bool {
        matches!(self.kind, ContactKind::Hinge { .. })
    }

    /// Whether it bears along its tangent: with friction, or without slip.
    pub const fn has_friction_force(&self) -> bool {
        self.rough || self.friction.is_some()
    }
}

/// The friction of a contact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Friction {
    /// The contact.
    pub contact: usize,
    /// The row of the kernel that is its slip.
    pub row: usize,
    /// Whether its coefficient depends on the slip velocity.
    pub follows_slip: bool,
}

/// A condition that springs and loads act on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Switch {
    /// What it switches, `spring AB, force P`.
    pub label: &'static str,
    /// As conditions of runs are written.
    pub condition: &'static str,
}

/// A two-sided constraint: a joint that closes a loop, or a drive.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    /// `hinge A`, `slider P`, `drive spin`.
    pub name: &'static str,
    /// Whether its gap is an angle, of a drive that turns; a length otherwise.
    pub is_angle: bool,
}

impl Joint {
    /// Whether it is a drive.
    pub fn is_drive(&self) -> bool {
        self.name.starts_with(DRIVE)
    }
}

/// What a contact is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ContactKind {
    /// It pushes.
    Support,
    /// It pulls.
    Thread,
    /// It holds both ways, and is closed always: a guide with friction.
    Guide,
    /// It holds both ways from when its gap, a length, is zero until its condition ceases: a drive.
    Drive,
    /// The same of an angle.
    Turn,
    /// It pushes against an angle: its gap is one, its reaction a couple.
    AngleLimit,
    /// A hinge with friction, closed always: its reaction is the length of the joint force, its
    /// slip that of the journal.
    Hinge {
        /// The components of the joint force among [`Layout::quantities`].
        force: [usize; 2],
    },
}

impl ContactKind {
    /// Whether it only pushes, or only pulls.
    pub const fn is_one_sided(self) -> bool {
        matches!(self, Self::Support | Self::Thread | Self::AngleLimit)
    }

    /// Whether it is a drive on a condition.
    pub const fn is_drive(self) -> bool {
        matches!(self, Self::Drive | Self::Turn)
    }
}

/// An expression of time and motion that a load or a drive follows. A step is accepted only over
/// what it has seen of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signal {
    /// As conditions are written: `sin(t)^2 * x(P)`.
    pub expression: &'static str,
    /// Whether it prescribes a motion, so that its rate may not jump.
    pub drives: bool,
}

/// What is zero where the equations are not analytic in the state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kink {
    /// a of √(a a) = |a|: a kink where it changes its sign.
    Sign,
    /// Another radicand: ≥ 0, and zero at a minimum or at the edge of the equations' domain.
    Radicand,
}

/// What restitution relates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Law {
    /// Velocities: ġ⁺ = −e ġ⁻.
    Newton,
    /// Velocities, with Coulomb's law between the whole impulse and the slip velocity after it.
    Moreau,
    /// Impulses: P = (1 + e) Pᶜ, with the impulse Pᶜ of the plastic compression.
    Poisson,
    /// Energies: the normal impulse gives back e² of the work that the compression took, along the
    /// path of a single contact.
    Stronge,
}

impl Law {
    /// Whether an impact has a compression and a restitution.
    pub const fn has_phases(self) -> bool {
        matches!(self, Self::Poisson | Self::Stronge)
    }
}

/// What the names of joints begin with that are prescribed motions.
const DRIVE: &str = "drive ";

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

/// Powers of length, time and mass in what a parameter is measured in: a force has [1, −2, 1].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dimension {
    /// Numerators of the powers of length, time and mass.
    pub numerators: [i8; 3],
    /// Their common denominator, positive.
    pub denominator: i8,
}

impl Dimension {
    /// The dimension with these powers of length, time and mass over a positive denominator.
    pub const fn new(numerators: [i8; 3], denominator: i8) -> Self {
        Self { numerators, denominator }
    }

    /// The powers of length, time and mass.
    pub fn powers(self) -> [f64; 3] {
        self.numerators.map(|n| f64::from(n) / f64::from(self.denominator))
    }
}

/// A model's names.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Layout {
    /// The struct's name.
    pub name: &'static str,
    /// The declaration that the equations were derived from, as source text.
    pub declaration: &'static str,
    /// The first paragraph of its documentation.
    pub summary: &'static str,
    /// Parameters in the order of [`BarSystem::parameters`](super::BarSystem::parameters).
    pub parameters: &'static [&'static str],
    /// The dimension of each parameter; none where the declaration does not determine it, as of two
    /// parameters that occur as a product only.
    pub dimensions: &'static [Option<Dimension>],
    /// Values of the parameters, and the run, where nothing else is said.
    pub defaults: &'static Defaults,
    /// Whether the equations hold in every system of units: no number of the declaration has a
    /// dimension.
    pub covariant: bool,
    /// Generalised coordinates; a state holds their values, then their rates, then the time if
    /// [`Self::timed`], then the switches.
    pub coordinates: &'static [Coordinate],
    /// Declared angles that follow them; starts and outputs take their names too.
    pub dependent: &'static [DependentAngle],
    /// One-sided contacts; the first rows of the kernel.
    pub contacts: &'static [Contact],
    /// Two-sided constraints kept as multipliers; the rows after the contacts, closed in every
    /// phase.
    pub joints: &'static [Joint],
    /// The contact of each tangential row; the rows after the joints. They have no gap. That of a
    /// rough contact is closed with it, that of one with friction where it sticks.
    pub tangents: &'static [usize],
    /// The contacts with friction.
    pub frictions: &'static [Friction],
    /// Whether the equations depend on time.
    pub timed: bool,
    /// The conditions that springs and loads act on, where they do not always.
    pub switches: &'static [Switch],
    /// Whether springs, dampers or loads that follow the motion act, which alone can make the
    /// equations stiff. Exact Jacobians are compiled only then.
    pub compliant: bool,
    /// What is zero where the equations are not analytic in the state, in the order of
    /// [`BarSystem::kinks`](super::BarSystem::kinks).
    pub kinks: &'static [Kink],
    /// What loads and drives follow that is no polynomial of time and motion.
    pub signals: &'static [Signal],
    /// Whether loads act: their work is no part of the energy.
    pub loaded: bool,
    /// What [`BarSystem::quantity`](super::BarSystem::quantity) computes.
    pub quantities: &'static [Quantity],
    /// Points in the order of [`BarSystem::points`](super::BarSystem::points).
    pub points: &'static [&'static str],
    /// Bars.
    pub bars: &'static [Bar],
    /// The contact sets that have a closed form.
    pub closed_forms: &'static [ContactSet],
    /// How it is drawn.
    pub geometry: &'static Geometry,
}

/// A model without anything but a name, and for each field a function that gives it: a description
/// names what its scene has and nothing else, and fields that come later do not break it.
macro_rules! builder {
    ($($field:ident: $type:ty = $none:expr;)*) => {
        impl Layout {
            /// A model without anything.
            pub const fn new(name: &'static str) -> Self {
                Self { name, $($field: $none),* }
            }

            $(
                #[doc = concat!("The same with these [`", stringify!($field), "`](field@Self::", stringify!($field), ").")]
                #[must_use]
                pub const fn $field(mut self, $field: $type) -> Self {
                    self.$field = $field;
                    self
                }
            )*
        }
    };
}

builder! {
    declaration: &'static str = "";
    summary: &'static str = "";
    parameters: &'static [&'static str] = &[];
    dimensions: &'static [Option<Dimension>] = &[];
    defaults: &'static Defaults = &Defaults::NONE;
    covariant: bool = false;
    coordinates: &'static [Coordinate] = &[];
    dependent: &'static [DependentAngle] = &[];
    contacts: &'static [Contact] = &[];
    joints: &'static [Joint] = &[];
    tangents: &'static [usize] = &[];
    frictions: &'static [Friction] = &[];
    timed: bool = false;
    switches: &'static [Switch] = &[];
    compliant: bool = false;
    kinks: &'static [Kink] = &[];
    signals: &'static [Signal] = &[];
    loaded: bool = false;
    quantities: &'static [Quantity] = &[];
    points: &'static [&'static str] = &[];
    bars: &'static [Bar] = &[];
    closed_forms: &'static [ContactSet] = &[];
    geometry: &'static Geometry = &Geometry::EMPTY;
}

impl Layout {
    /// The number of entries of a full state: coordinates, rates, the time if the equations depend
    /// on it, and for each switch 1 while what it switches acts, else 0.
    pub const fn entries(&self) -> usize {
        2 * self.coordinates.len() + self.timed as usize + self.switches.len()
    }

    /// The entry of a switch in a full state.
    pub const fn switch(&self, i: usize) -> usize {
        2 * self.coordinates.len() + self.timed as usize + i
    }

    /// The switch of a spring, torsion, force or couple, `spring AB`; none of one that always acts.
    #[cfg(feature = "std")]
    pub fn switch_of(&self, label: &str) -> Option<usize> {
        self.switches.iter().position(|switch| switch.label.split(", ").any(|one| one == label))
    }

    /// The time derivative of an entry of a full state after the rates: 1 of the time, 0 of a
    /// switch.
    pub const fn slope(&self, entry: usize) -> i64 {
        (self.timed && entry == 2 * self.coordinates.len()) as i64
    }

    /// The full state at a time: coordinates and rates as users give them, then the time if the
    /// equations depend on it; everything that is switched acts. Entries missing from values that
    /// are too few are taken as not a number.
    #[cfg(feature = "std")]
    pub fn state_at(&self, values: &[f64], t: f64) -> Vec<f64> {
        let (public, switches) = (2 * self.coordinates.len(), self.switch(0));
        let value = |i: usize| match i {
            _ if i < public => values.get(i).copied().unwrap_or(f64::NAN),
            _ if i < switches => t,
            _ => 1.0,
        };
        (0..self.entries()).map(value).collect()
    }

    /// Names of the coordinates, then of their rates: the entries of a state as users give it.
    #[cfg(feature = "std")]
    pub fn names_of_state(&self) -> impl Iterator<Item = String> {
        let names = self.coordinates.iter().map(|coordinate| coordinate.name);
        names.clone().map(str::to_owned).chain(names.map(|name| format!("{name}'")))
    }

    /// The names that starts take: those of the state, then of dependent angles and their rates.
    #[cfg(feature = "std")]
    pub fn names_of_motion(&self) -> impl Iterator<Item = String> {
        let names = self.dependent.iter().map(|angle| angle.name);
        let rates = names.clone().map(|name| format!("{name}'"));
        self.names_of_state().chain(names.map(str::to_owned)).chain(rates)
    }

    /// Names of the coordinates, then of dependent angles.
    pub fn names_of_positions(&self) -> impl Iterator<Item = &'static str> {
        let dependent = self.dependent.iter().map(|angle| angle.name);
        self.coordinates.iter().map(|coordinate| coordinate.name).chain(dependent)
    }

    /// The values of [`Self::names_of_motion`] in a state.
    #[cfg(feature = "std")]
    pub fn motion(&self, parameters: &[f64], state: &[f64]) -> Vec<f64> {
        let (positions, rates) = self.public_state(state).split_at(self.coordinates.len());
        let values = self.dependent.iter().map(|angle| angle.value(parameters, positions));
        let rate = self.dependent.iter().map(|angle| angle.rate(rates));
        positions.iter().chain(rates).copied().chain(values).chain(rate).collect()
    }

    /// Whether a coordinate or a dependent angle of this name is an angle.
    pub fn is_angle(&self, name: &str) -> bool {
        self.coordinates.iter().any(|known| known.is_angle && known.name == name)
            || self.dependent.iter().any(|known| known.name == name)
    }

    /// Coordinates and rates of a full state, without what else it has.
    pub fn public_state<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[..2 * self.coordinates.len()]
    }

    /// The number of corners under bars, each with two distances in
    /// [`BarSystem::feet`](super::BarSystem::feet).
    pub fn feet(&self) -> usize {
        self.contacts.iter().filter_map(|contact| contact.foot).max().map_or(0, |last| last + 1)
    }

    /// What the set of no contacts is called: `free`, but of a mechanism without contacts, or one
    /// that a drive moves.
    pub fn unclosed(&self) -> &'static str {
        match (self.contacts.is_empty(), self.joints.iter().any(Joint::is_drive)) {
            (true, _) => "no contacts",
            (false, true) => "no contact closed",
            (false, false) => "free",
        }
    }

    /// The number of rows of the kernel.
    pub const fn rows(&self) -> usize {
        self.contacts.len() + self.joints.len() + self.tangents.len()
    }

    /// The number of entries of the reactions: one for each contact, then the friction force of
    /// each that has friction.
    pub const fn reactions(&self) -> usize {
        self.contacts.len() + self.frictions.len()
    }

    /// The contacts that are closed always: guides and hinges with friction.
    pub fn guides(&self) -> ContactSet {
        if !self.has_guides() && !self.has_hinges() {
            return ContactSet::EMPTY;
        }
        let always = |kind: ContactKind| matches!(kind, ContactKind::Guide | ContactKind::Hinge { .. });
        let guides = self.contacts.iter().enumerate().filter(|(_, contact)| always(contact.kind));
        guides.map(|(i, _)| i).collect()
    }

    /// The contacts with a foot on a bar.
    pub fn edges(&self) -> ContactSet {
        let edges = self.contacts.iter().enumerate().filter(|(_, contact)| contact.foot.is_some());
        edges.map(|(i, _)| i).collect()
    }

    /// The drives on conditions, which hold both ways while they are closed.
    pub fn drives(&self) -> ContactSet {
        let drives = self.contacts.iter().enumerate().filter(|(_, contact)| contact.kind.is_drive());
        drives.map(|(i, _)| i).collect()
    }

    /// Whether guides have friction.
    pub const fn has_guides(&self) -> bool {
        let mut i = 0;
        while i < self.contacts.len() {
            if matches!(self.contacts[i].kind, ContactKind::Guide) {
                return true;
            }
            i += 1;
        }
        false
    }

    /// How many hinges with friction a model has at most; the derive macro refuses more.
    pub const HINGES: usize = 8;

    /// Whether hinges have friction.
    pub const fn has_hinges(&self) -> bool {
        let mut i = 0;
        while i < self.contacts.len() {
            if self.contacts[i].is_hinge() {
                return true;
            }
            i += 1;
        }
        false
    }

    /// The hinges with friction, each with its entry of the frictions and the components of its
    /// force among the quantities.
    pub fn hinges(&self) -> impl Iterator<Item = (usize, Friction, [usize; 2])> + '_ {
        let frictions = self.frictions.iter().copied().enumerate();
        frictions.filter_map(|(entry, friction)| match self.contacts[friction.contact].kind {
            ContactKind::Hinge { force } => Some((entry, friction, force)),
            _ => None,
        })
    }

    /// The row of the kernel whose multiplier an entry of the reactions is.
    pub const fn row_of_reaction(&self, entry: usize) -> usize {
        let contacts = self.contacts.len();
        if entry < contacts { entry } else { self.frictions[entry - contacts].row }
    }

    /// Whether a row of the kernel is closed in a contact set.
    pub const fn is_closed(&self, row: usize, set: &ContactSet) -> bool {
        let Some(contact) = self.contact_of(row) else { return true };
        if row < self.contacts.len() {
            return set.contains(row) && !self.contacts[row].is_hinge();
        }
        set.contains(contact)
            && (self.contacts[contact].friction.is_none() || matches!(set.slip(contact), Slip::Stick))
    }

    /// The natural unit of a row's gap, given the natural length: a radian of an angle.
    pub fn unit(&self, row: usize, length: f64) -> f64 {
        if self.is_turned(row) { 1.0 } else { length }
    }

    /// Whether the gap of a row is an angle, and its multiplier a couple.
    pub fn is_turned(&self, row: usize) -> bool {
        let joint = row.checked_sub(self.contacts.len()).and_then(|joint| self.joints.get(joint));
        let turns = self
            .contacts
            .get(row)
            .is_some_and(|contact| matches!(contact.kind, ContactKind::Turn | ContactKind::AngleLimit));
        turns || joint.is_some_and(|joint| joint.is_angle)
    }

    /// The contact of a row, normal or tangential; none of a joint's.
    pub const fn contact_of(&self, row: usize) -> Option<usize> {
        let joints = self.contacts.len() + self.joints.len();
        if row < self.contacts.len() {
            Some(row)
        } else if row < joints {
            None
        } else {
            Some(self.tangents[row - joints])
        }
    }

    /// The contacts with friction that slide in a set, each with its entry of the frictions.
    pub fn sliding<'a>(&self, set: &'a ContactSet) -> impl Iterator<Item = (usize, Friction)> + 'a {
        let frictions = self.frictions.iter().copied().enumerate();
        frictions.filter(|(_, friction)| set.sense(friction.contact) != 0)
    }
}
