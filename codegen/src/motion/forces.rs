//! Forces by the balance of parts: what acts on a part through a cut is its change of momentum less
//! all else that acts on it,
//!
//! `F = Σ m (c̈ − g) − Σ f − Σ λ φ`, `C = Σ m (c − O) × (c̈ − g) + I ω̇ − Σ ((r − O) × f + c)`,
//!
//! f and c the loads, φ the forces that unit multipliers of the rows stand for.

use super::action::{Action, Holder, Scene, normal};
use super::expression::OpaqueTerms;
use super::parts::CutSide;
use super::{Motion, Products, Vector, driving};
use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::JointKind;
use crate::system::Guide;

/// Every force with its multiplier, and whom it is not known to act on.
pub(super) struct Forces<'a> {
    pub scene: Scene<'a>,
    pub motion: &'a Motion,
    actions: Vec<Action>,
    /// Actions of each row at a hinge or pin, by the point.
    pub joints: Vec<(usize, Action)>,
    undetermined: Vec<Holder>,
}

pub(super) fn multiplier(row: usize) -> Series {
    Series::symbol(Symbol::Reaction(row as u16))
}

impl<'a> Forces<'a> {
    pub fn new(scene: &Scene<'a>, motion: &'a Motion) -> Self {
        let actions = motion.loads.actions.clone();
        let mut forces =
            Self { scene: *scene, motion, actions, joints: Vec::new(), undetermined: Vec::new() };
        let contacts = motion.contacts.len();
        let mut slips = contacts + scene.kinematics.joints.len();
        for (row, contact) in motion.contacts.iter().enumerate() {
            forces.spread(row, &contact.actions, contact.shared);
            for tangent in &contact.tangents {
                forces.spread(slips, &tangent.actions, contact.shared);
                slips += 1;
            }
        }
        for (i, joint) in scene.kinematics.joints.iter().enumerate() {
            forces.hold(contacts + i, joint.kind);
        }
        forces
    }

    /// All of them, if it is known of each on what it acts.
    pub fn known(self) -> Option<Vec<Action>> {
        self.undetermined.is_empty().then_some(self.actions)
    }

    /// The forces of a contact, in equal shares.
    fn spread(&mut self, row: usize, members: &[Vec<Action>], shared: bool) {
        let share = multiplier(row).scale(Rational::new(1, members.len() as i128));
        let actions = members.iter().flatten();
        if shared || members.len() == 1 {
            self.actions.extend(actions.map(|action| action.scaled(&share)));
        } else {
            self.undetermined.extend(actions.filter_map(|action| action.on));
        }
    }

    /// The forces of a joint.
    fn hold(&mut self, row: usize, kind: JointKind) {
        let (scene, lambda) = (self.scene, multiplier(row));
        let along = |axis: usize, force: &Series| {
            let mut vector = [Series::zero(), Series::zero()];
            vector[axis] = force.clone();
            vector
        };
        match kind {
            JointKind::Pin { point, axis } => {
                let action = Action::at_point(&scene, point, along(axis, &lambda));
                self.joints.push((point, action.clone()));
                self.actions.push(action);
            }
            JointKind::Hinge { point, body, axis } => {
                let back = Action::at_point(&scene, point, along(axis, &-&lambda));
                let place = scene.kinematics.points[point].clone();
                let local = scene.system.local(body, point)[0].clone();
                let action = Action::at_place(body, place, local, along(axis, &lambda));
                self.joints.extend([(point, action.clone()), (point, back.clone())]);
                self.actions.extend([action, back]);
            }
            JointKind::Slider(i) => self.slide(i, &lambda),
            JointKind::Drive(i) => {
                self.actions.extend(driving::actions(&scene, &scene.system.drives[i].driven, &lambda));
            }
        }
    }

    fn slide(&mut self, i: usize, lambda: &Series) {
        let scene = self.scene;
        let slider = &scene.system.sliders[i];
        let push = |direction: Vector| direction.map(|part| &part * lambda);
        match &slider.guide {
            Guide::Line { direction, .. } => {
                self.actions.push(Action::at_point(&scene, slider.point, push(normal(direction))));
            }
            Guide::Circle { centre, inverse, .. } => {
                let place = &scene.kinematics.points[slider.point];
                let inwards = [0, 1].map(|axis| &(&centre[axis] - &place[axis]) * inverse);
                self.actions.push(Action::at_point(&scene, slider.point, push(inwards)));
            }
            Guide::Axis(body) => {
                let force = push(normal(&scene.kinematics.directions[*body]));
                self.actions.extend(driving::against(&scene, slider.point, *body, force));
            }
        }
    }

    /// F of a part.
    pub fn force(&self, opaque_terms: &mut OpaqueTerms, part: &CutSide) -> Vector {
        let mut force = [Series::zero(), Series::zero()];
        for inertia in part.inertias(&self.scene, opaque_terms, &self.motion.inertias) {
            let pull = self.lift(&inertia.centre);
            (0..2).for_each(|axis| force[axis] += &inertia.mass * &pull[axis]);
        }
        for action in &self.actions {
            let share = part.share(&self.scene, opaque_terms, action);
            (0..2).for_each(|axis| force[axis] -= &share * &action.force[axis]);
        }
        force
    }

    /// F of each body with everything that hangs from it, leaves first.
    pub fn carried(&self, opaque_terms: &mut OpaqueTerms) -> Vec<Vector> {
        let tree = &self.scene.kinematics.tree;
        let count = self.scene.system.bodies.len();
        let mut carried: Vec<Vector> =
            (0..count).map(|body| self.force(opaque_terms, &CutSide::alone(body))).collect();
        let depth = |mut body: usize| {
            let holder = |body: usize| tree.owner[tree.entry[body]];
            core::iter::from_fn(|| holder(body).inspect(|&above| body = above)).count()
        };
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|&body| core::cmp::Reverse(depth(body)));
        for body in order {
            if let Some(above) = tree.owner[tree.entry[body]] {
                let [x, y] = carried[body].clone();
                carried[above][0] += x;
                carried[above][1] += y;
            }
        }
        carried
    }

    /// C of a part about a place.
    pub fn couple(&self, opaque_terms: &mut OpaqueTerms, part: &CutSide, about: &Vector) -> Products {
        let arm = |at: &Vector| [0, 1].map(|axis| &at[axis] - &about[axis]);
        let mut couple = Products::new();
        for inertia in part.inertias(&self.scene, opaque_terms, &self.motion.inertias) {
            let pull = self.lift(&inertia.centre);
            couple.extend(moment(&arm(&inertia.centre), &pull.map(|part| &inertia.mass * &part)));
            couple.push([inertia.inertia, inertia.spin.rate()]);
        }
        for action in &self.actions {
            let share = part.share(&self.scene, opaque_terms, action);
            let back = action.force.each_ref().map(|part| -(&share * part));
            couple.extend(moment(&arm(&action.at), &back));
            couple.push([-share, action.couple.clone()]);
        }
        couple
    }

    /// c̈ − g.
    fn lift(&self, centre: &Vector) -> Vector {
        let gravity = self.scene.system.gravity.as_ref();
        [0, 1].map(|axis| {
            let rise = centre[axis].rate().rate();
            gravity.map_or_else(|| rise.clone(), |g| &rise - &g[axis])
        })
    }

    /// Whether no couple but those of the loads and drives acts on a part: none of equal angles,
    /// none of the ground on a bar welded to it, and so many welds as said across the cut.
    pub fn turns_freely(&self, part: &CutSide, welds: usize) -> bool {
        let system = self.scene.system;
        let holds = |body: usize| part.holds(Holder::Body(body));
        let grounded = system.welds.iter().any(|weld| weld.to.is_none() && holds(weld.body));
        let crossing = system.welds.iter().filter(|w| w.to.is_some_and(|to| holds(to) != holds(w.body)));
        system.equal.is_empty() && !grounded && crossing.count() == welds
    }

    /// Whether all forces on a part are known.
    pub fn is_determined(&self, part: &CutSide) -> bool {
        !self.undetermined.iter().any(|&on| part.holds(on))
    }
}

/// r × f.
pub(super) fn moment([x, y]: &Vector, force: &Vector) -> Products {
    vec![[x.clone(), force[1].clone()], [-y, force[0].clone()]]
}
