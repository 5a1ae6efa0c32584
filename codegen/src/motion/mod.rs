//! The equations of motion in the generalised coordinates, as Poisson series:
//!
//! `M a + h = Q + Jᵀ λ`, with `T = ½ uᵀ M u`, `M = Σ m J_cᵀ J_c + I ωᵀ ω`, `h = Σ m J_cᵀ J̇_c u`
//! (the velocity terms), Q the generalised forces of gravity, springs and loads, and one row
//! `g̈ = J a + b` for each contact, each joint, and each slip of a contact that is rough or has
//! friction.

mod action;
mod alike;
mod circle;
mod contacts;
mod dense;
mod driving;
mod edge;
mod expression;
mod feeler;
mod forces;
mod gap;
mod hinge;
mod limit;
mod loads;
mod measured;
mod parts;
mod quantities;
mod quantity;
mod row;
mod stop;
mod thread;
mod tree;

use crate::algebra::{Series, Symbol};
use crate::kinematics::Kinematics;
use crate::system::{Formula, System};
use expression::OpaqueTerms;
use forces::Forces;

pub use action::{Action, Holder, Scene};
pub use contacts::{Contact, FrictionCoefficients, Tangent};
pub use dense::Dense;
pub use expression::{Expression, OpaqueTerm};
pub use loads::Loads;
pub use measured::Foot;
pub use quantity::{Quantity, QuantityKind};
pub use row::Row;
pub(crate) use row::bias;
pub use tree::{Base, Branch, LumpedMass, Tree, square};

/// Hinges with friction that a model has at most: `Layout::HINGES` of the runtime.
pub const MOST_HINGES: usize = 8;

/// Larger systems are solved by the runtime's loops, not by unrolled statements.
pub const UNROLLED: usize = 16;

/// Sets of contacts beyond the first ten have no code of their own.
pub const SEARCHED: usize = 10;

/// Contacts of which a set can be told: `ContactSet::CAPACITY` of the runtime.
pub const MOST_CONTACTS: usize = 256;

/// Guides with friction of which a set can tell the side: `ContactSet::GUIDES` of the runtime.
pub const MOST_GUIDES: usize = 64;

/// Trees of more bodies are not written out entry by entry: recursions are shorter.
const WRITTEN: usize = 8;

/// `Σ a b`, the products not multiplied out: series of the motion, its accelerations and the
/// multipliers of the rows.
pub type Products = Vec<[Series; 2]>;

/// A contact set: bits of the contacts that are closed, and of those with friction that stick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClosedSet {
    /// The closed contacts.
    pub closed: u64,
    /// Those of them that stick.
    pub stick: u64,
}

impl ClosedSet {
    /// The set in which no contact sticks.
    pub const fn without_stick(closed: u64) -> Self {
        Self { closed, stick: 0 }
    }
}

/// A mass at a position, and its energy's parts.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// What it moves with.
    pub on: Option<Holder>,
    /// Mass.
    pub mass: Series,
    /// Moment of inertia about the centre; zero for a point mass.
    pub inertia: Series,
    /// Position of the centre.
    pub centre: [Series; 2],
    /// Angular velocity.
    pub spin: Series,
}

/// The equations of motion of the system without contacts, and the rows of contacts and joints.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Number of coordinates.
    pub n: usize,
    /// Everything that has mass.
    pub inertias: Vec<Inertia>,
    /// V.
    pub potential: Series,
    /// What acts beside gravity.
    pub loads: Loads,
    /// One-sided contacts.
    pub contacts: Vec<Contact>,
    /// Rows of the contacts, then of the joints, then of the slips of contacts that are rough or
    /// have friction.
    pub rows: Vec<Row>,
    /// The contact of each slip.
    pub tangents: Vec<usize>,
    /// What series contain that is no series itself.
    pub opaque_terms: Vec<OpaqueTerm>,
    /// Joint forces, tensions, internal forces and momenta, by name; of a long tree without joint
    /// forces and momenta.
    pub quantities: Vec<Quantity<Products>>,
    /// The tree that the system is, if it is one.
    pub tree: Option<Tree>,
    /// The number of conditions that springs and loads act on.
    pub switches: usize,
}

impl Motion {
    /// Derives the equations of `system` in the coordinates of `kinematics`.
    ///
    /// # Errors
    /// A support whose point cannot move; more than [`MOST_CONTACTS`] contacts or [`MOST_GUIDES`]
    /// guides with friction; rationals that overflow.
    pub fn derive(system: &System, kinematics: &Kinematics) -> syn::Result<Self> {
        let n = kinematics.coordinates.len();
        let scene = Scene { system, kinematics };
        let inertias = inertias(system, kinematics);
        let mut opaque_terms = OpaqueTerms::of_drives(system, kinematics);
        let contacts = contacts::merge(&scene, &mut opaque_terms)?;
        if let Some(first) = contacts.get(MOST_CONTACTS) {
            let text = format!("a model has at most {MOST_CONTACTS} contacts; this is one more");
            return Err(syn::Error::new(first.support(system).span, text));
        }
        // Guides are the first contacts.
        if let Some(first) = contacts.get(MOST_GUIDES).filter(|contact| contact.two_sided) {
            let text = format!("a model has at most {MOST_GUIDES} guides with friction; this is one more");
            return Err(syn::Error::new(first.support(system).span, text));
        }
        let loads = Loads::derive(&scene, &mut opaque_terms);
        let joints = kinematics.joints.iter().map(|joint| Row::from_gap(&joint.equation, n));
        let slips = contacts.iter().flat_map(|c| c.tangents.iter().map(|tangent| tangent.row.clone()));
        let tangents = contacts.iter().enumerate().flat_map(|(i, c)| c.tangents.iter().map(move |_| i));
        let mut motion = Self {
            n,
            potential: &potential(system, &inertias) + &loads.potential,
            inertias,
            rows: contacts.iter().map(|c| c.row.clone()).chain(joints).chain(slips).collect(),
            tangents: tangents.collect(),
            loads,
            contacts,
            opaque_terms: Vec::new(),
            quantities: Vec::new(),
            tree: None,
            switches: system.switches.len(),
        };
        motion.tree = Tree::recognise(&scene, &motion);
        motion.quantities = quantities::derive_quantities(&scene, &motion, &mut opaque_terms);
        motion.opaque_terms = opaque_terms.0;
        motion.hinge_forces(system)?;
        match motion.rows.iter().any(Row::is_overflow) {
            true => Err(overflow(system)),
            false => Ok(motion),
        }
    }

    /// The tree, where its functions are recursions over its bodies: beyond eight bodies, those
    /// with contacts beyond what is unrolled.
    pub fn long_tree(&self) -> Option<&Tree> {
        let most = if self.contacts.is_empty() { WRITTEN } else { UNROLLED };
        self.tree
            .as_ref()
            .filter(|tree| tree.branches.len() > most && tree.bases.is_empty() && !self.has_joints())
    }

    /// Whether anything holds two-sided, throughout or on a condition.
    fn has_joints(&self) -> bool {
        let drives = self.contacts.iter().any(|contact| contact.driven);
        drives || self.rows.len() > self.contacts.len() + self.tangents.len()
    }

    /// What a state has beside coordinates and rates: the time where the equations depend on it,
    /// then the switches.
    pub fn carried(&self) -> impl Iterator<Item = Symbol> + Clone + use<> {
        let time = self.is_timed().then_some(Symbol::Time);
        time.into_iter().chain((0..self.switches as u16).map(Symbol::Switch))
    }

    /// The number of entries of a full state.
    pub fn entries(&self) -> usize {
        2 * self.n + self.carried().count()
    }

    /// Every load, and the forces of the rows by their multipliers; `None` where these are not
    /// known one by one.
    pub fn actions(&self, scene: &Scene) -> Option<Vec<Action>> {
        Forces::new(scene, self).known()
    }

    /// Whether a row is closed in a contact set; the slip of a contact with friction where it
    /// sticks.
    pub fn is_closed(&self, row: usize, set: ClosedSet) -> bool {
        match row {
            _ if row < self.contacts.len() => contains(set.closed, row) && self.contacts[row].force.is_none(),
            _ if row < self.slips() => true,
            _ => {
                let contact = self.tangents[row - self.slips()];
                let sticks = self.contacts[contact].friction.is_none() || contains(set.stick, contact);
                contains(set.closed, contact) && sticks
            }
        }
    }

    /// The contact sets of the first contacts, all guides closed, smallest first; of those with one
    /// and the same contacts closed, that in which all with friction stick first.
    pub fn sets(&self, contacts: usize) -> Vec<ClosedSet> {
        let guides = self.contacts.iter().enumerate().filter(|(_, contact)| contact.two_sided);
        let (rubs, guides) = (first(self.frictions().map(|of| of.0)), first(guides.map(|of| of.0)));
        let mut closed: Vec<u64> = (0..1 << contacts).filter(|set| set & guides == guides).collect();
        closed.sort_by_key(|set| set.count_ones());
        let of = |closed: u64| {
            let stick = (0..=closed & rubs).rev().filter(move |stick| stick & !(closed & rubs) == 0);
            stick.map(move |stick| ClosedSet { closed, stick })
        };
        closed.into_iter().flat_map(of).collect()
    }

    /// The first row of a slip.
    pub fn slips(&self) -> usize {
        self.rows.len() - self.tangents.len()
    }

    /// The contacts with friction, each with the row of its slip.
    pub fn frictions(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let slips = self.tangents.iter().enumerate().map(|(k, &contact)| (contact, self.slips() + k));
        slips.filter(|(contact, _)| self.contacts[*contact].friction.is_some())
    }

    /// The row of each reaction: of the contacts, then of the slips of those with friction.
    pub fn rows_of_reactions(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.contacts.len()).chain(self.frictions().map(|(_, row)| row))
    }

    /// How many reactions there are.
    pub fn reactions(&self) -> usize {
        self.rows_of_reactions().count()
    }

    /// Whether the coefficient of friction of a contact depends on its slip velocity.
    pub fn follows_slip(&self, system: &System, contact: usize) -> bool {
        let friction = self.contacts[contact].support(system).friction.as_ref();
        friction.is_some_and(|friction| !matches!(friction.kinetic, Formula::Constant(_)))
    }

    /// Those of them that slide in a contact set.
    pub fn sliding(&self, set: ClosedSet) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.frictions()
            .filter(move |(contact, _)| contains(set.closed, *contact) && !contains(set.stick, *contact))
    }

    /// Whether the equations depend on time.
    pub fn is_timed(&self) -> bool {
        self.opaque_terms.iter().flat_map(|opaque_term| &opaque_term.orders).any(Expression::has_time)
    }
}

fn overflow(system: &System) -> syn::Error {
    let text = "the exact coefficients overflow 128 bits; write long decimals as parameters";
    syn::Error::new(system.longest_number(), text)
}

type Vector = [Series; 2];

fn combine(errors: &mut Option<syn::Error>, error: syn::Error) {
    match errors {
        Some(all) => all.combine(error),
        None => *errors = Some(error),
    }
}

fn dot(a: &[Series; 2], b: &[Series; 2]) -> Series {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

fn inertias(system: &System, kinematics: &Kinematics) -> Vec<Inertia> {
    let scene = Scene { system, kinematics };
    let bodies = system.bodies.iter().enumerate().map(|(i, body)| Inertia {
        on: Some(Holder::Body(i)),
        mass: body.mass.clone(),
        inertia: body.inertia.clone(),
        centre: kinematics.centres[i].clone(),
        spin: kinematics.directions[i].rate(),
    });
    let particles = system.particles.iter().map(|particle| Inertia {
        on: scene.holder(particle.point),
        mass: particle.mass.clone(),
        inertia: Series::zero(),
        centre: kinematics.points[particle.point].clone(),
        spin: Series::zero(),
    });
    bodies.chain(particles).collect()
}

/// `V = −Σ m (g · r)`.
fn potential(system: &System, inertias: &[Inertia]) -> Series {
    let Some(gravity) = &system.gravity else { return Series::zero() };
    inertias.iter().map(|body| -&(&body.mass * &dot(gravity, &body.centre))).sum()
}

/// Those of some contacts that are among the first 64, as a set of these.
fn first(contacts: impl Iterator<Item = usize>) -> u64 {
    contacts.fold(0, |set, contact| set | 1_u64.checked_shl(contact as u32).unwrap_or(0))
}

/// Whether a contact is in a set of the first 64.
pub fn contains(set: u64, contact: usize) -> bool {
    contact < u64::BITS as usize && set >> contact & 1 == 1
}
