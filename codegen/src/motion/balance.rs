//! Forces by the balance of parts: what acts on a part through a cut is its change of momentum less all else that acts
//! on it,
//!
//! `F = Σ m (c̈ − g) − Σ f − Σ λ φ`, `C = Σ m (c − O) × (c̈ − g) + I ω̇ − Σ ((r − O) × f + c)`,
//!
//! f and c the loads, φ the forces that unit multipliers of the rows stand for.

use super::action::{Action, Holder, Scene, normal, unit};
use super::expression::Atoms;
use super::parts::Part;
use super::{Motion, dot};
use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::Held;
use crate::system::{CoordinateKind, Guide, Reading, Reference};

/// Systems of more bodies have no joint forces: their number grows with the square.
const BODIES: usize = 16;

type Vector = [Series; 2];

/// Every force with its multiplier, and whom it is not known to act on.
struct Forces<'a> {
    scene: Scene<'a>,
    motion: &'a Motion,
    actions: Vec<Action>,
    /// Actions of each row at a hinge or pin, by the point.
    joints: Vec<(usize, Action)>,
    undetermined: Vec<Holder>,
}

/// Joint forces, tensions, forces of drives, internal forces, momenta.
pub(super) fn quantities(scene: &Scene, motion: &Motion, atoms: &mut Atoms) -> Vec<(String, Series)> {
    let forces = Forces::of(scene, motion);
    let mut named = motion.loads.tensions.clone();
    let contacts = motion.contacts.len();
    for (i, joint) in scene.kinematics.joints.iter().enumerate() {
        if let Held::Drive(drive) = joint.held {
            let name = format!("drive({})", scene.system.drives[drive].name);
            named.push((name, Series::symbol(Symbol::Reaction((contacts + i) as u16))));
        }
    }
    // Of a mirrored loop one row stands for both images: how they share its force is not known.
    let loops = scene.kinematics.joints.iter().any(|joint| !matches!(joint.held, Held::Drive(_)));
    if !(loops && scene.system.mirror.is_some()) {
        if scene.system.bodies.len() <= BODIES {
            forces.joints(atoms, &mut named);
        }
        forces.sections(atoms, &mut named);
    }
    forces.momenta(&mut named);
    named
}

fn multiplier(row: usize) -> Series {
    Series::symbol(Symbol::Reaction(row as u16))
}

impl<'a> Forces<'a> {
    fn of(scene: &Scene<'a>, motion: &'a Motion) -> Self {
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
            forces.hold(contacts + i, joint.held);
        }
        forces
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
    fn hold(&mut self, row: usize, held: Held) {
        let (scene, lambda) = (self.scene, multiplier(row));
        let along = |axis: usize, force: &Series| {
            let mut vector = [Series::zero(), Series::zero()];
            vector[axis] = force.clone();
            vector
        };
        match held {
            Held::Pin { point, axis } => {
                let action = Action::at_point(&scene, point, along(axis, &lambda));
                self.joints.push((point, action.clone()));
                self.actions.push(action);
            }
            Held::Hinge { point, body, axis } => {
                let back = Action::at_point(&scene, point, along(axis, &-&lambda));
                let place = scene.kinematics.points[point].clone();
                let local = scene.system.local(body, point)[0].clone();
                let action = Action::at_place(body, place, local, along(axis, &lambda));
                self.joints.extend([(point, action.clone()), (point, back.clone())]);
                self.actions.extend([action, back]);
            }
            Held::Slider(i) => self.slide(i, &lambda),
            Held::Drive(i) => self.drive(scene.system.drives[i].reading, &lambda),
        }
    }

    fn slide(&mut self, i: usize, lambda: &Series) {
        let scene = self.scene;
        let slider = &scene.system.sliders[i];
        let place = &scene.kinematics.points[slider.point];
        let push = |direction: Vector| direction.map(|part| &part * lambda);
        match &slider.guide {
            Guide::Line { direction, .. } => {
                self.actions.push(Action::at_point(&scene, slider.point, push(normal(direction))));
            }
            Guide::Axis(body) => {
                let direction = &scene.kinematics.directions[*body];
                let first = &scene.kinematics.points[scene.system.bodies[*body].from];
                let reach = [0, 1].map(|axis| &place[axis] - &first[axis]);
                let local = dot(&unit(direction), &reach);
                let force = push(normal(direction));
                let back = force.each_ref().map(|part| -part);
                self.actions.push(Action::at_point(&scene, slider.point, force));
                self.actions.push(Action::at_place(*body, place.clone(), local, back));
            }
        }
    }

    fn drive(&mut self, reading: Reading, lambda: &Series) {
        let scene = self.scene;
        let mut push = |point: usize, axis: usize, force: Series| {
            let mut vector = [Series::zero(), Series::zero()];
            vector[axis] = force;
            self.actions.push(Action::at_point(&scene, point, vector));
        };
        match reading {
            Reading::Position(point, axis) => push(point, axis, lambda.clone()),
            Reading::Direction(body) => {
                self.actions.push(Action::couple(&scene, body, None, lambda.clone()));
            }
            Reading::Coordinate(i) => match &scene.system.coordinates[i].kind {
                CoordinateKind::Position { point, axis, sign } => {
                    push(*point, *axis, lambda.scale(Rational::integer((*sign).into())));
                }
                CoordinateKind::Angle { body, reference, sign } => {
                    let couple = lambda.scale(Rational::integer((*sign).into()));
                    let from = match reference {
                        Reference::Ground(_) => None,
                        Reference::Body(other) => Some(*other),
                    };
                    self.actions.extend(from.map(|from| Action::couple(&scene, from, Some(*body), -&couple)));
                    self.actions.push(Action::couple(&scene, *body, from, couple));
                }
            },
        }
    }

    /// F of a part.
    fn force(&self, atoms: &mut Atoms, part: &Part) -> Vector {
        let mut force = [Series::zero(), Series::zero()];
        for inertia in part.inertias(&self.scene, atoms, &self.motion.inertias) {
            let pull = self.lift(&inertia.centre);
            (0..2).for_each(|axis| force[axis] += &inertia.mass * &pull[axis]);
        }
        for action in &self.actions {
            let share = part.share(&self.scene, atoms, action);
            (0..2).for_each(|axis| force[axis] -= &share * &action.force[axis]);
        }
        force
    }

    /// C of a part about a place.
    fn couple(&self, atoms: &mut Atoms, part: &Part, about: &Vector) -> Series {
        let arm = |at: &Vector| [0, 1].map(|axis| &at[axis] - &about[axis]);
        let mut couple = Series::zero();
        for inertia in part.inertias(&self.scene, atoms, &self.motion.inertias) {
            let pull = self.lift(&inertia.centre);
            couple += &inertia.mass * &cross(&arm(&inertia.centre), &pull);
            couple += &inertia.inertia * &inertia.spin.rate();
        }
        for action in &self.actions {
            let share = part.share(&self.scene, atoms, action);
            couple -= &share * &(&cross(&arm(&action.at), &action.force) + &action.couple);
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

    fn is_determined(&self, part: &Part) -> bool {
        let within = |on: &&Holder| {
            part.holders.contains(on) || part.piece.as_ref().is_some_and(|p| **on == Holder::Body(p.body))
        };
        let count = self.undetermined.iter().filter(within).count();
        count == 0
    }

    /// The force of each joint on each of its bodies, and of the ground at each pin.
    fn joints(&self, atoms: &mut Atoms, named: &mut Vec<(String, Series)>) {
        let (system, tree) = (self.scene.system, &self.scene.kinematics.tree);
        for (point, declared) in system.points.iter().enumerate() {
            let pinned = system.pins.iter().any(|pin| pin.point == point);
            if declared.on.len() < 2 && !pinned {
                continue;
            }
            let entering: Vec<usize> = (0..system.bodies.len()).filter(|&b| tree.entry[b] == point).collect();
            let parts: Vec<Part> = entering.iter().map(|&body| Part::beyond(&self.scene, body)).collect();
            if !parts.iter().all(|part| self.is_determined(part)) {
                continue;
            }
            let through: Vec<Vector> = parts.iter().map(|part| self.force(atoms, part)).collect();
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
                push(named, &names, force);
            }
            if pinned {
                let mut force = self.closing(point, None);
                if tree.root[point] == point {
                    through.iter().for_each(|one| (0..2).for_each(|axis| force[axis] += &one[axis]));
                }
                push(named, &declared.name, force);
            }
        }
    }

    /// The forces of the rows that hold a point: on a body, or all of those by which the ground holds it.
    fn closing(&self, point: usize, body: Option<usize>) -> Vector {
        let mut sum = [Series::zero(), Series::zero()];
        let rows = self.joints.iter().filter(|(at, _)| *at == point);
        for (_, action) in rows.filter(|(_, action)| body.is_none_or(|b| action.on == Some(Holder::Body(b))))
        {
            (0..2).for_each(|axis| sum[axis] += &action.force[axis]);
        }
        sum
    }

    fn sections(&self, atoms: &mut Atoms, named: &mut Vec<(String, Series)>) {
        let scene = &self.scene;
        for section in &scene.system.sections {
            let part = Part::section(scene, section);
            if !self.is_determined(&part) {
                continue;
            }
            let place =
                scene.kinematics.place(scene.system, section.body, &[section.at.clone(), Series::zero()]);
            let far = part.piece.as_ref().is_some_and(|piece| piece.far);
            let sign = Series::integer(if far { 1 } else { -1 });
            let force = self.force(atoms, &part).map(|component| &component * &sign);
            let couple = &self.couple(atoms, &part, &place) * &sign;
            let direction = &scene.kinematics.directions[section.body];
            named.push((format!("normal({})", section.name), -&dot(&force, &unit(direction))));
            named.push((format!("shear({})", section.name), dot(&force, &normal(direction))));
            named.push((format!("moment({})", section.name), couple));
        }
    }

    /// Momenta of the whole, the angular one about the origin.
    fn momenta(&self, named: &mut Vec<(String, Series)>) {
        let (mut linear, mut angular) = ([Series::zero(), Series::zero()], Series::zero());
        for inertia in &self.motion.inertias {
            let velocity = inertia.centre.each_ref().map(Series::rate);
            (0..2).for_each(|axis| linear[axis] += &inertia.mass * &velocity[axis]);
            angular += &inertia.mass * &cross(&inertia.centre, &velocity);
            angular += &inertia.inertia * &inertia.spin;
        }
        let [x, y] = linear;
        named.extend([("px".to_owned(), x), ("py".to_owned(), y), ("Lz".to_owned(), angular)]);
    }
}

fn push(named: &mut Vec<(String, Series)>, names: &str, [x, y]: Vector) {
    named.push((format!("fx({names})"), x));
    named.push((format!("fy({names})"), y));
}

fn cross(a: &Vector, b: &Vector) -> Series {
    &(&a[0] * &b[1]) - &(&a[1] * &b[0])
}
