//! Forces at joints, tensions, forces of drives, internal forces and momenta, by name. Only what is
//! asked for is computed.

use super::Vector;
use super::action::{Holder, Scene, normal, unit};
use super::expression::{Expression, OpaqueTerms};
use super::forces::{Forces, moment, multiplier};
use super::parts::CutSide;
use super::{Motion, Products, Quantity, QuantityKind, dot};
use crate::algebra::Series;
use crate::kinematics::JointKind;
use crate::system::{Drive, Driven, Reading, System};

/// Systems of more bodies have no joint forces unless they are trees: their length grows with the
/// square.
const BODIES: usize = 16;

/// Joint forces, tensions, forces of drives, internal forces, momenta.
pub(super) fn derive_quantities(
    scene: &Scene,
    motion: &Motion,
    opaque_terms: &mut OpaqueTerms,
) -> Vec<Quantity<Products>> {
    let forces = Forces::new(scene, motion);
    let tensions = motion.loads.tensions.iter();
    let mut named: Vec<_> =
        tensions.map(|of| Quantity::new(of.name.clone(), of.kind, once(of.value.clone()))).collect();
    let contacts = motion.contacts.len();
    for (i, joint) in scene.kinematics.joints.iter().enumerate() {
        let (name, kind, per_multiplier) = match joint.kind {
            JointKind::Drive(drive) => {
                let drive = &scene.system.drives[drive];
                named.extend(target(scene, opaque_terms, drive));
                let force = force(scene, opaque_terms, drive);
                (format!("drive({})", drive.name), driving(scene.system, &drive.driven), force)
            }
            JointKind::Slider(slider) => (
                format!("slider({})", scene.system.sliders[slider].name),
                QuantityKind::JointForce,
                Series::one(),
            ),
            JointKind::Hinge { .. } | JointKind::Pin { .. } => continue,
        };
        named.push(Quantity::new(name, kind, once(&multiplier(contacts + i) * &per_multiplier)));
    }
    for (i, contact) in motion.contacts.iter().enumerate().filter(|(_, contact)| contact.two_sided) {
        if contact.is_hinge(scene.system) {
            continue;
        }
        let name = format!("slider({})", contact.support(scene.system).name);
        named.push(Quantity::new(name, QuantityKind::JointForce, once(multiplier(i))));
    }
    for (i, contact) in motion.contacts.iter().enumerate() {
        if let Some(drive) = contact.drive(scene.system) {
            let (name, kind) = (format!("drive({})", drive.name), driving(scene.system, &drive.driven));
            named.push(Quantity::new(name, kind, once(multiplier(i))));
            named.extend(target(scene, opaque_terms, drive));
        }
    }
    for (point, declared) in scene.system.points.iter().enumerate() {
        let pushed = [0, 1].map(|axis| {
            let driven = Driven::Reading(Reading::Position(point, axis));
            motion
                .contacts
                .iter()
                .position(|contact| contact.drive(scene.system).is_some_and(|drive| drive.driven == driven))
        });
        if let [Some(x), Some(y)] = pushed {
            named.extend(Quantity::joint_force(&declared.name, [x, y].map(|i| once(multiplier(i)))));
        }
    }
    // Of a mirrored loop one row stands for both images: how they share its force is not known.
    let loops = scene.kinematics.joints.iter().any(|joint| !matches!(joint.kind, JointKind::Drive(_)));
    if !(loops && scene.system.mirror.is_some()) {
        if motion.long_tree().is_none() && scene.system.bodies.len() <= BODIES {
            forces.joints(opaque_terms, &mut named);
            forces.welds(opaque_terms, &mut named);
        }
        forces.sections(opaque_terms, &mut named);
    }
    if motion.long_tree().is_none() {
        forces.momenta(&mut named);
    }
    named
}

/// The force of a drive for a unit multiplier of its row: of a distance d, f(t) as it is driven,
/// `d/d₀`.
fn force(scene: &Scene, opaque_terms: &mut OpaqueTerms, drive: &Drive) -> Series {
    let Driven::Distance { inverse, .. } = &drive.driven else { return Series::one() };
    &prescribed(scene, opaque_terms, drive) * inverse
}

/// f(t) of a drive.
fn prescribed(scene: &Scene, opaque_terms: &mut OpaqueTerms, drive: &Drive) -> Series {
    let value = Expression::from_formula(&drive.value, scene.system, scene.kinematics);
    opaque_terms.symbol(&format!("d_{}", drive.name), value)
}

/// The distance that a drive prescribes; the model is one while it is above zero.
fn target(scene: &Scene, opaque_terms: &mut OpaqueTerms, drive: &Drive) -> Option<Quantity<Products>> {
    matches!(drive.driven, Driven::Distance { .. }).then(|| {
        let value = once(prescribed(scene, opaque_terms, drive));
        Quantity::new(format!("target({})", drive.name), QuantityKind::DrivenDistance, value)
    })
}

/// What drives this: a torque if it is an angle.
fn driving(system: &System, driven: &Driven) -> QuantityKind {
    if system.is_angle(driven) { QuantityKind::DriveTorque } else { QuantityKind::DriveForce }
}

impl Forces<'_> {
    /// The force of each joint on each of its bodies, and of the ground at each pin.
    fn joints(&self, opaque_terms: &mut OpaqueTerms, named: &mut Vec<Quantity<Products>>) {
        let (system, tree) = (self.scene.system, &self.scene.kinematics.tree);
        let carried = self.carried(opaque_terms);
        for (point, declared) in system.points.iter().enumerate() {
            let pinned = system.pins.iter().any(|pin| pin.point == point);
            if declared.on.len() < 2 && !pinned {
                continue;
            }
            let entering: Vec<usize> = (0..system.bodies.len()).filter(|&b| tree.entry[b] == point).collect();
            let parts = || entering.iter().map(|&body| CutSide::beyond(&self.scene, body));
            if !parts().all(|part| self.is_determined(&part)) {
                continue;
            }
            let through: Vec<&Vector> = entering.iter().map(|&body| &carried[body]).collect();
            for (body, _) in &declared.on {
                let mut force = self.closing(point, Some(*body));
                for (entered, through) in entering.iter().zip(&through) {
                    (0..2).for_each(|axis| {
                        if entered == body {
                            force[axis] += &through[axis];
                        }
                        if tree.owner[point] == Some(*body) {
                            force[axis] -= &through[axis];
                        }
                    });
                }
                let names = format!("{}, {}", declared.name, system.bodies[*body].name);
                named.extend(Quantity::joint_force(&names, force.map(once)));
            }
            if pinned {
                let mut force = self.closing(point, None);
                if tree.root[point] == point {
                    through.iter().for_each(|one| (0..2).for_each(|axis| force[axis] += &one[axis]));
                }
                named.extend(Quantity::joint_force(&declared.name, force.map(once)));
            }
        }
    }

    /// The forces of the rows that hold a point: on a body, or all of those by which the ground
    /// holds it.
    fn closing(&self, point: usize, body: Option<usize>) -> Vector {
        let mut sum = [Series::zero(), Series::zero()];
        let rows = self.joints.iter().filter(|(at, _)| *at == point);
        for (_, action) in rows.filter(|(_, action)| body.is_none_or(|b| action.on == Some(Holder::Body(b))))
        {
            (0..2).for_each(|axis| sum[axis] += &action.force[axis]);
        }
        sum
    }

    /// The couple of each weld of two bodies, on the one that is held.
    fn welds(&self, opaque_terms: &mut OpaqueTerms, named: &mut Vec<Quantity<Products>>) {
        let (system, tree) = (self.scene.system, &self.scene.kinematics.tree);
        for weld in &system.welds {
            let Some(other) = weld.to else { continue };
            let holds = |point: usize, body: usize| system.points[point].on.iter().any(|(b, _)| *b == body);
            let shared = (0..system.points.len()).find(|&p| holds(p, weld.body) && holds(p, other));
            let Some(point) = shared else { continue };
            // Of the two the one that is reached through their point, and whether it is the one
            // held.
            let below = [(weld.body, 1), (other, -1)].into_iter().find(|(body, _)| {
                tree.entry[*body] == point && tree.owner[point].is_some_and(|o| o == weld.body || o == other)
            });
            let Some((body, sign)) = below else { continue };
            let part = CutSide::beyond(&self.scene, body);
            if self.is_determined(&part) && self.turns_freely(&part, 1) {
                let couple = self.couple(opaque_terms, &part, &self.scene.kinematics.points[point]);
                let names = [other, weld.body].map(|body| system.bodies[body].name.as_str()).join(", ");
                let name = format!("couple({names})");
                named.push(Quantity::new(name, QuantityKind::JointCouple, scaled(couple, sign)));
            }
        }
    }

    fn sections(&self, opaque_terms: &mut OpaqueTerms, named: &mut Vec<Quantity<Products>>) {
        let scene = &self.scene;
        for section in &scene.system.sections {
            let parts = CutSide::section(scene, opaque_terms, section);
            if !parts.iter().all(|(part, _)| self.is_determined(part)) {
                continue;
            }
            let place = scene.kinematics.compute_position(
                scene.system,
                section.body,
                &[section.at.clone(), Series::zero()],
            );
            let (mut force, mut couple) = ([Series::zero(), Series::zero()], Products::new());
            for (part, counts) in &parts {
                let far = part.piece.as_ref().is_some_and(|piece| piece.far);
                let counts = if far { counts.clone() } else { -counts };
                let whole = self.force(opaque_terms, part);
                (0..2).for_each(|axis| force[axis] += &whole[axis] * &counts);
                // Sagging is positive: the couple of the far part on the near one.
                let whole = self.couple(opaque_terms, part, &place);
                couple.extend(whole.into_iter().map(|[a, b]| [-(&a * &counts), b]));
            }
            let direction = &scene.kinematics.directions[section.body];
            let mut push = |what: &str, kind, value| {
                named.push(Quantity::new(format!("{what}({})", section.name), kind, value));
            };
            push("normal", QuantityKind::SectionForce, once(-&dot(&force, &unit(direction))));
            push("shear", QuantityKind::SectionForce, once(dot(&force, &normal(direction))));
            if parts.iter().all(|(part, _)| self.turns_freely(part, 0)) {
                push("moment", QuantityKind::BendingMoment, couple);
            }
        }
    }

    /// Momenta of the whole, the angular one about the origin.
    fn momenta(&self, named: &mut Vec<Quantity<Products>>) {
        let (mut linear, mut angular) = ([Series::zero(), Series::zero()], Products::new());
        for inertia in &self.motion.inertias {
            let velocity = inertia.centre.each_ref().map(Series::rate);
            (0..2).for_each(|axis| linear[axis] += &inertia.mass * &velocity[axis]);
            let momentum = velocity.map(|part| &inertia.mass * &part);
            angular.extend(moment(&inertia.centre, &momentum));
            angular.push([inertia.inertia.clone(), inertia.spin.clone()]);
        }
        let [x, y] = linear;
        named.extend(Quantity::momenta([once(x), once(y), angular]));
    }
}

/// One series.
fn once(series: Series) -> Products {
    vec![[Series::one(), series]]
}

fn scaled(products: Products, sign: i64) -> Products {
    products.into_iter().map(|[a, b]| [&a * &Series::integer(sign), b]).collect()
}
