//! Which one-sided constraints are one contact: those whose gaps are one series, and mirror images
//! (whose gaps are one on the joints); their reaction is the total. With friction only images are
//! one: its law needs the reaction of each.

use super::action::{Action, Scene};
use super::expression::{Expression, OpaqueTerms};
use super::gap::measure;
use super::measured::{Foot, Measured, is_fixed};
use super::row::Row;
use crate::algebra::{Rational, Series};
use crate::system::{Drive, OneSided, Support, System};

/// Supports that share a gap.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Indices of its supports.
    pub supports: Vec<usize>,
    /// Whether its members are mirror images (or there is only one), so that each bears an equal
    /// share.
    pub shared: bool,
    /// Whether it is closed always, a guide.
    pub two_sided: bool,
    /// Whether it is a drive on a condition.
    pub driven: bool,
    /// Of a hinge with friction the components of its force, by their places among the quantities.
    pub force: Option<[usize; 2]>,
    /// The foot, for a corner.
    pub foot: Option<Foot>,
    /// Its gap.
    pub row: Row,
    /// Slips of its members that are rough or have friction.
    pub tangents: Vec<Tangent>,
    /// Its coefficients of friction; it has one tangent then.
    pub friction: Option<FrictionCoefficients>,
    /// The forces of a unit reaction of each support.
    pub actions: Vec<Vec<Action>>,
}

/// Coefficients of Coulomb friction at a state.
#[derive(Clone, Debug)]
pub struct FrictionCoefficients {
    /// μ.
    pub kinetic: Series,
    /// μₛ.
    pub limit: Series,
}

/// The slip of a support that is rough or has friction.
#[derive(Clone, Debug)]
pub struct Tangent {
    /// Its velocities.
    pub row: Row,
    /// The forces of a unit tangential reaction, one entry for each support that it stands for.
    pub actions: Vec<Vec<Action>>,
}

impl Contact {
    /// Names of the supports joined by commas.
    pub fn label(&self, system: &System) -> String {
        let names: Vec<_> = self.supports.iter().map(|&s| system.supports[s].name.as_str()).collect();
        names.join(", ")
    }

    /// The same as a part of names in code; drives are called as they are declared,
    /// `drive distance(A, B)`.
    pub fn word(&self, system: &System) -> String {
        self.label(system).replace(", ", "_").replace([' ', '('], "_").replace(')', "")
    }

    /// Its first support.
    pub fn support<'a>(&self, system: &'a System) -> &'a Support {
        &system.supports[self.supports[0]]
    }

    /// Whether it pulls.
    pub fn is_thread(&self, system: &System) -> bool {
        self.support(system).contact.is_thread()
    }

    /// The drive that it is.
    pub fn drive<'a>(&self, system: &'a System) -> Option<&'a Drive> {
        self.support(system).contact.drive().map(|i| &system.drives[i])
    }

    /// Whether its gap is an angle: of a drive, or a limit.
    pub fn is_turned(&self, system: &System) -> bool {
        match &self.support(system).contact {
            OneSided::Drive(i) => system.is_angle(&system.drives[*i].driven),
            OneSided::Limit { driven, .. } => system.is_angle(driven),
            _ => false,
        }
    }

    /// Whether it is a hinge with friction.
    pub fn is_hinge(&self, system: &System) -> bool {
        self.support(system).contact.is_hinge()
    }

    fn takes(&self, scene: &Scene, other: usize, measured: &Measured) -> bool {
        let system = scene.system;
        let image = system.mirror.as_ref().is_some_and(|m| self.supports.contains(&m.supports[other]));
        let (own, other) = (self.support(system), &system.supports[other]);
        let alike = own.rough == other.rough
            && own.friction.is_none()
            && other.friction.is_none()
            && own.moving == other.moving
            && own.restitution == other.restitution
            && (own.law, own.stop, &own.armed, &own.breaks)
                == (other.law, other.stop, &other.armed, &other.breaks);
        image || alike && self.row.gap == measured.row.gap && same_foot(&self.foot, &measured.foot)
    }

    fn join(&mut self, support: usize, measured: Measured) {
        let [actions, slip] = measured.actions;
        self.supports.push(support);
        self.actions.push(actions);
        let Some(row) = measured.tangent else { return };
        let same = |tangent: &&mut Tangent| tangent.row.jacobian == row.jacobian;
        if let Some(tangent) = self.tangents.iter_mut().find(same) {
            return tangent.actions.push(slip);
        }
        let negated: Vec<Series> = row.jacobian.iter().map(|entry| -entry).collect();
        match self.tangents.iter_mut().find(|tangent| tangent.row.jacobian == negated) {
            Some(tangent) => {
                let minus = Series::constant(-Rational::ONE);
                tangent.actions.push(slip.iter().map(|action| action.scaled(&minus)).collect());
            }
            None => self.tangents.push(Tangent { row, actions: vec![slip] }),
        }
    }
}

/// The contacts in order of their first support.
pub(super) fn merge(scene: &Scene, opaque_terms: &mut OpaqueTerms) -> syn::Result<Vec<Contact>> {
    let mut contacts: Vec<Contact> = Vec::new();
    let mut errors: Option<syn::Error> = None;
    for (i, support) in scene.system.supports.iter().enumerate() {
        let measured = measure(scene, opaque_terms, support);
        if is_fixed(&measured.row) && !support.contact.is_hinge() {
            let name = &support.name;
            let text = match support.contact.drive() {
                Some(i) => {
                    format!(
                        "drive `{}` has no effect: the driven quantity cannot move",
                        scene.system.drives[i].name
                    )
                }
                None if support.two_sided => {
                    format!("slider `{name}` has no effect: the guided point cannot move")
                }
                None if matches!(support.contact, OneSided::Limit { .. }) => {
                    format!("limit `{name}` has no effect: what it bounds cannot move")
                }
                None => format!("support `{name}` has no effect: the supported point cannot move"),
            };
            super::combine(&mut errors, syn::Error::new(support.span, text));
        }
        match contacts.iter_mut().find(|contact| contact.takes(scene, i, &measured)) {
            Some(contact) => contact.join(i, measured),
            None => {
                let (foot, row) = (measured.foot.clone(), measured.row.clone());
                let (supports, tangents, actions) = (Vec::new(), Vec::new(), Vec::new());
                let friction = friction(scene, opaque_terms, support, measured.tangent.as_ref());
                let (two_sided, driven) = (support.two_sided, support.contact.drive().is_some());
                let mut contact = Contact {
                    supports,
                    shared: true,
                    two_sided,
                    driven,
                    force: None,
                    foot,
                    row,
                    tangents,
                    friction,
                    actions,
                };
                contact.join(i, measured);
                contacts.push(contact);
            }
        }
    }
    for contact in &mut contacts {
        contact.shared = images(scene.system, &contact.supports);
        if contact.friction.is_some() && contact.tangents.len() > 1 {
            let support = contact.support(scene.system);
            let text = format!(
                "the friction of support `{}` and of its image slip differently, so that the motion does not stay \
                 symmetric; leave `mirror` out",
                support.name
            );
            super::combine(&mut errors, syn::Error::new(support.span, text));
        }
    }
    errors.map_or(Ok(contacts), Err)
}

/// The coefficients of a support with the slip of its row.
fn friction(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    support: &Support,
    tangent: Option<&Row>,
) -> Option<FrictionCoefficients> {
    let (declared, tangent) = (support.friction.as_ref()?, tangent?);
    let kinetic = Expression::of_slip(&declared.kinetic, scene.system, scene.kinematics, &tangent.velocity());
    let kinetic = opaque_terms.symbol(&format!("μ_{}", support.name), kinetic);
    Some(FrictionCoefficients { kinetic, limit: declared.limit.clone() })
}

fn same_foot(a: &Option<Foot>, b: &Option<Foot>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.equals(b),
        (a, b) => a.is_none() && b.is_none(),
    }
}

fn images(system: &System, supports: &[usize]) -> bool {
    match (supports, &system.mirror) {
        ([_], _) => true,
        (&[a, b], Some(mirror)) => mirror.supports[a] == b,
        _ => false,
    }
}
