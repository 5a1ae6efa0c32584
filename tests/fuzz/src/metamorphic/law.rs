//! The laws of mechanics, asked of rows of outputs and of the scene as it was declared.
//!
//! It knows masses, inertias, points and loads, and takes nothing from what computed the motion:
//! Newton's and Euler's equations of each body, guides and drives, gaps, reactions, the cone of
//! friction, impacts, continuity, and the work of loads.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use liftoff::{Event, EventKind, Instant, Note};
use nalgebra::DVector;

use super::motion::{ContactRow, Motion, Row};
use super::print::is_corner;
use super::scene::{
    Body, Guide, Scene, Shape, Support, Target, Vector, add, cross, direction, dot, left, norm, scale,
    subtract,
};
use crate::Finding;

/// Relative error of equations that hold to rounding in any row.
const ROUNDING: f64 = 1e-8;
/// Error of motions, relative to their size.
const MOTION: f64 = 1e-7;
/// Speeds below this, relative to those of the motion, need not be given back.
const RESTITUTION: f64 = 1e-4;
/// No reaction is so many times larger than the forces of the motion.
const LARGEST: f64 = 1e9;
/// Events nearer to each other than this part of the run are not looked at one by one.
const APART: f64 = 1e-4;
/// Slips below this have no direction.
const SLIP: f64 = 1e-6;
/// Segments between events in which the law of motion is integrated.
const WINDOWS: usize = 6;
/// How often a window is halved where its quadrature is not exact.
const HALVINGS: u32 = 14;
/// Gauss and Legendre's quadrature of order 16 on [−1, 1] (Abramowitz and Stegun, table 25.4).
const NODES: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_5],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_3],
];

fn wrong<T>(t: f64, text: impl FnOnce() -> String) -> Result<T, Finding> {
    Err(Finding(format!("law: t = {t:?}: {}", text())))
}

/// What must be small, beside what it is made of.
fn small(t: f64, value: f64, bound: f64, what: impl FnOnce() -> String) -> Result<(), Finding> {
    match value.abs() <= bound {
        true => Ok(()),
        false => wrong(t, || format!("{}: {value:e}, allowed {bound:e}", what())),
    }
}

/// A contact as the declaration and the positions give it.
struct Touch {
    gap: f64,
    /// Of the support's point.
    normal: Vector,
    /// Along lines and bars, counter-clockwise round circles.
    tangent: Vector,
    /// The velocity of the point, or of the rim of its disc, relative to what it touches if that
    /// did not run.
    slip: Vector,
    /// Where that touches.
    place: Vector,
    /// Whether the foot is between the ends of what it touches.
    is_within: bool,
    /// Where the opposite of the reaction acts: a body, and the place.
    under: Option<(usize, Vector)>,
}

/// The laws of one scene.
struct Law<'a> {
    scene: &'a Scene,
    motion: &'a Motion,
    /// Sizes of lengths, velocities and forces.
    length: f64,
    speed: f64,
}

/// Checks a whole run.
///
/// # Errors
/// The first law that does not hold.
pub fn check(scene: &Scene, motion: &Motion) -> Result<(), Finding> {
    let sizes = scene.bodies.iter().map(|body| body.length);
    let length = sizes.fold(0.0, f64::max).max(if scene.bodies.is_empty() {
        scene.gravity[1].abs().max(1e-3)
    } else {
        0.0
    });
    let end = motion.run.end_time();
    let rows: Vec<Row> = (0..=8).map(|k| motion.row(end * f64::from(k) / 8.0, false)).collect();
    let speeds = rows.iter().flat_map(|row| row.points.values().map(|point| norm(point[1])));
    let speed = speeds.fold(length / end.max(1e-9), f64::max);
    let law = Law { scene, motion, length, speed };
    law.check_segments()?;
    law.check_events()
}

impl Law<'_> {
    fn locate(&self, row: &Row, point: &str) -> [Vector; 3] {
        let fixed = || [self.scene.points[point].position, [0.0; 2], [0.0; 2]];
        row.points.get(point).copied().unwrap_or_else(fixed)
    }

    /// Angular velocity and acceleration of a body, by its ends.
    fn compute_turning(&self, row: &Row, body: &Body) -> [f64; 2] {
        let [a, b] = [0, 1].map(|k| self.locate(row, &body.ends[k]));
        let arm = subtract(b[0], a[0]);
        let square = dot(arm, arm);
        [1, 2].map(|k| cross(arm, subtract(b[k], a[k])) / square)
    }

    fn angle(&self, row: &Row, body: &Body) -> f64 {
        let [a, b] = [0, 1].map(|k| self.locate(row, &body.ends[k])[0]);
        (b[1] - a[1]).atan2(b[0] - a[0])
    }

    /// Position, velocity and acceleration of a place in a body's frame.
    fn place_in_body(&self, row: &Row, body: &Body, local: Vector) -> [Vector; 3] {
        let a = self.locate(row, &body.ends[0]);
        let e = scale(1.0 / body.length, subtract(self.locate(row, &body.ends[1])[0], a[0]));
        let arm = add(scale(local[0], e), scale(local[1], left(e)));
        let [rate, acceleration] = self.compute_turning(row, body);
        let turned = left(arm);
        [
            add(a[0], arm),
            add(a[1], scale(rate, turned)),
            add(a[2], add(scale(acceleration, turned), scale(-rate * rate, arm))),
        ]
    }

    fn find_touch(&self, row: &Row, support: &Support) -> Touch {
        let [at, velocity, _] = self.locate(row, &support.point);
        let rim = |normal: Vector| scale(-support.radius, normal);
        let spin = self
            .scene
            .bodies_at(&support.point)
            .next()
            .map(|(k, _)| self.compute_turning(row, &self.scene.bodies[k])[0]);
        let fixed = |gap: f64, normal, tangent| {
            let slip = add(velocity, scale(spin.unwrap_or(0.0), left(rim(normal))));
            let (gap, place) = (gap - support.radius, add(at, rim(normal)));
            Touch { gap, normal, tangent, slip, place, is_within: true, under: None }
        };
        match &support.shape {
            Shape::Line { angle, through } => {
                let normal = left(direction(*angle));
                fixed(dot(normal, subtract(at, *through)), normal, direction(*angle))
            }
            Shape::Circle { centre, radius, inside } => {
                let arm = subtract(at, *centre);
                let sign = if *inside { -1.0 } else { 1.0 };
                let gap = sign * (dot(arm, arm) - radius * radius) / (2.0 * radius);
                fixed(gap, scale(sign / radius, arm), scale(1.0 / radius, left(arm)))
            }
            Shape::Bar { body: k, is_left } => {
                let body = &self.scene.bodies[*k];
                let first = self.locate(row, &body.ends[0])[0];
                let e = scale(1.0 / body.length, subtract(self.locate(row, &body.ends[1])[0], first));
                let normal = scale(if *is_left { 1.0 } else { -1.0 }, left(e));
                let along = dot(e, subtract(at, first));
                let foot = add(first, scale(along, e));
                let [_, carried, _] = self.place_in_body(row, body, [along, 0.0]);
                let is_within = (0.0..=body.length).contains(&along);
                let slip = subtract(velocity, carried);
                let (gap, under) = (dot(normal, subtract(at, first)), Some((*k, foot)));
                // Friction of a corner is that on the bar.
                let tangent = scale(if is_corner(self.scene, &support.point) { -1.0 } else { 1.0 }, e);
                Touch { gap, normal, tangent, slip, place: at, is_within, under }
            }
        }
    }

    /// A number for each equation: three of each body, two of each particle.
    fn size(&self) -> usize {
        3 * self.scene.bodies.len() + 2 * self.scene.particles.len()
    }

    /// The equations of what a point belongs to first, and its place there; none of fixed points.
    fn owner(&self, point: &str) -> Option<(usize, bool)> {
        let particle = self.scene.particles.iter().position(|(name, _)| name == point);
        let of_particle = particle.map(|k| (3 * self.scene.bodies.len() + 2 * k, false));
        of_particle.or_else(|| self.scene.bodies_at(point).next().map(|(k, _)| (3 * k, true)))
    }

    /// Adds a force at a place of a body.
    fn push_body(&self, into: &mut DVector<f64>, row: &Row, body: usize, at: Vector, force: Vector) {
        let centre = self.place_in_body(row, &self.scene.bodies[body], self.scene.bodies[body].centre)[0];
        into[3 * body] += force[0];
        into[3 * body + 1] += force[1];
        into[3 * body + 2] += cross(subtract(at, centre), force);
    }

    fn push(&self, into: &mut DVector<f64>, row: &Row, point: &str, force: Vector) {
        self.push_at(into, row, point, (self.locate(row, point)[0], force));
    }

    /// The same at another place of what a point belongs to.
    fn push_at(&self, into: &mut DVector<f64>, row: &Row, point: &str, (at, force): (Vector, Vector)) {
        match self.owner(point) {
            Some((first, true)) => {
                self.push_body(into, row, first / 3, at, force);
            }
            Some((first, false)) => {
                into[first] += force[0];
                into[first + 1] += force[1];
            }
            None => {}
        }
    }

    fn measure_guide(&self, row: &Row, point: &str, guide: &Guide) -> (f64, Vector) {
        let at = self.locate(row, point)[0];
        match guide {
            Guide::Line { angle, through } => {
                let normal = left(direction(*angle));
                (dot(normal, subtract(at, *through)), normal)
            }
            Guide::Circle { centre, radius } => {
                let arm = subtract(*centre, at);
                (norm(arm) - radius, scale(1.0 / norm(arm), arm))
            }
        }
    }

    /// Changes of momentum for velocities (k = 1) or forces of inertia for accelerations (k = 2).
    fn compute_inertial_forces(&self, row: &Row, k: usize) -> DVector<f64> {
        let mut into = DVector::zeros(self.size());
        for (i, body) in self.scene.bodies.iter().enumerate() {
            let force = scale(body.mass, self.place_in_body(row, body, body.centre)[k]);
            into[3 * i] += force[0];
            into[3 * i + 1] += force[1];
            into[3 * i + 2] += body.inertia * self.compute_turning(row, body)[k - 1];
        }
        for (point, mass) in self.scene.particles.iter().chain(&self.scene.masses) {
            self.push(&mut into, row, point, scale(*mass, self.locate(row, point)[k]));
        }
        into
    }

    /// Loads, springs and dampers; and their power, without that of springs and gravity.
    fn compute_loads(&self, row: &Row) -> (DVector<f64>, f64) {
        let (scene, mut into, mut power) = (self.scene, DVector::zeros(self.size()), 0.0);
        for (i, body) in scene.bodies.iter().enumerate() {
            into[3 * i] += body.mass * scene.gravity[0];
            into[3 * i + 1] += body.mass * scene.gravity[1];
        }
        for (point, mass) in scene.particles.iter().chain(&scene.masses) {
            self.push(&mut into, row, point, scale(*mass, scene.gravity));
        }
        for spring in &scene.springs {
            let [a, b] = [0, 1].map(|k| self.locate(row, &spring.ends[k]));
            let arm = subtract(b[0], a[0]);
            let e = scale(1.0 / norm(arm), arm);
            let rate = dot(e, subtract(b[1], a[1]));
            let tension = spring.stiffness * (norm(arm) - spring.length) + spring.damping * rate;
            self.push(&mut into, row, &spring.ends[0], scale(tension, e));
            self.push(&mut into, row, &spring.ends[1], scale(-tension, e));
            power -= spring.damping * rate * rate;
        }
        for torsion in &scene.torsions {
            let (angle, rate) = self.measure_torsion(row, torsion.first, torsion.second);
            let torque = -torsion.stiffness * (angle - torsion.angle) - torsion.damping * rate;
            into[3 * torsion.second + 2] += torque;
            torsion.first.iter().for_each(|first| into[3 * first + 2] -= torque);
            power -= torsion.damping * rate * rate;
        }
        for force in &scene.forces {
            let velocity = self.locate(row, &force.point)[1];
            let acts = force.until.is_none_or(|until| row.t < until);
            let pushed = scale(if acts { force.wave.value(row.t) } else { 0.0 }, force.along);
            let drag = if acts { force.drag } else { 0.0 };
            let all = add(pushed, scale(-drag, velocity));
            self.push(&mut into, row, &force.point, all);
            power += dot(all, velocity);
        }
        for couple in &scene.couples {
            let value = couple.wave.value(row.t);
            let rate = |k: usize| self.compute_turning(row, &scene.bodies[k])[0];
            into[3 * couple.body + 2] += value;
            power += value * rate(couple.body);
            if let Some(from) = couple.from {
                into[3 * from + 2] -= value;
                power -= value * rate(from);
            }
        }
        (into, power)
    }

    /// The angle between two bodies, counted through, and its rate.
    fn measure_torsion(&self, row: &Row, first: Option<usize>, second: usize) -> (f64, f64) {
        let motion =
            |k: usize| [self.measure_turn(row, k), self.compute_turning(row, &self.scene.bodies[k])[0]];
        let ([turned, rate], [other, pace]) = (motion(second), first.map_or([0.0; 2], motion));
        (self.scene.measure_angle(first, second) + turned - other, rate - pace)
    }

    /// By how much a body has turned since the start: by its ends, and by a coordinate how often.
    fn measure_turn(&self, row: &Row, body: usize) -> f64 {
        let welded = self.scene.welds.iter().find(|[_, second]| *second == body);
        let counted = row.turns.get(&welded.map_or(body, |[first, _]| *first)).copied().unwrap_or(0.0);
        let own = &self.scene.bodies[body];
        let raw = self.angle(row, own) - own.angle;
        raw + ((counted - raw) / TAU).round() * TAU
    }

    /// Reactions that outputs have; and the power of what moves and of friction.
    fn compute_reactions(&self, row: &Row) -> (DVector<f64>, [f64; 2]) {
        let (scene, mut into, mut driven, mut lost) = (self.scene, DVector::zeros(self.size()), 0.0, 0.0);
        for (support, contact) in scene.supports.iter().zip(&row.contacts) {
            let touch = self.find_touch(row, support);
            let friction = contact.friction.map_or(0.0, |[force, _]| force);
            let force = add(scale(contact.normal, touch.normal), scale(friction, touch.tangent));
            self.push_at(&mut into, row, &support.point, (touch.place, force));
            if let Some((body, foot)) = touch.under {
                self.push_body(&mut into, row, body, foot, scale(-1.0, force));
            }
            lost += friction * dot(touch.tangent, touch.slip);
        }
        for (thread, contact) in scene.threads.iter().zip(&row.contacts[scene.supports.len()..]) {
            for ends in thread.path.windows(2) {
                let arm = subtract(self.locate(row, &ends[1])[0], self.locate(row, &ends[0])[0]);
                let pull = scale(contact.normal / norm(arm), arm);
                self.push(&mut into, row, &ends[0], pull);
                self.push(&mut into, row, &ends[1], scale(-1.0, pull));
            }
        }
        for (slider, force) in scene.sliders.iter().zip(&row.sliders) {
            let (_, normal) = self.measure_guide(row, &slider.point, &slider.guide);
            self.push(&mut into, row, &slider.point, scale(*force, normal));
        }
        for (drive, force) in scene.drives.iter().zip(&row.drives) {
            driven += force * drive.wave.slope(row.t);
            match &drive.target {
                Target::Angle(body) => into[3 * body + 2] += force,
                Target::Between(first, second) => {
                    into[3 * second + 2] += force;
                    into[3 * first + 2] -= force;
                }
                Target::Distance(ends) => {
                    let arm = subtract(self.locate(row, &ends[1])[0], self.locate(row, &ends[0])[0]);
                    let push = scale(force / norm(arm), arm);
                    self.push(&mut into, row, &ends[1], push);
                    self.push(&mut into, row, &ends[0], scale(-1.0, push));
                }
            }
        }
        (into, [driven, lost])
    }

    /// What joints can bear: columns of forces between bodies, of pins and welds.
    fn list_joints(&self, row: &Row) -> Vec<DVector<f64>> {
        let mut columns = Vec::new();
        for point in self.scene.points.keys() {
            let bodies: Vec<usize> = self.scene.bodies_at(point).map(|(k, _)| k).collect();
            let at = self.locate(row, point)[0];
            for force in [[1.0, 0.0], [0.0, 1.0]] {
                for other in bodies.iter().skip(1) {
                    let mut column = DVector::zeros(self.size());
                    self.push_body(&mut column, row, bodies[0], at, force);
                    self.push_body(&mut column, row, *other, at, scale(-1.0, force));
                    columns.push(column);
                }
                if self.scene.pins.contains(point) && !bodies.is_empty() {
                    let mut column = DVector::zeros(self.size());
                    self.push_body(&mut column, row, bodies[0], at, force);
                    columns.push(column);
                }
            }
        }
        for [first, second] in &self.scene.welds {
            let mut column = DVector::zeros(self.size());
            column[3 * first + 2] = 1.0;
            column[3 * second + 2] = -1.0;
            columns.push(column);
        }
        columns
    }

    /// What is left of forces that joints cannot bear, relative to moments by lengths.
    fn compute_unborne(&self, forces: &DVector<f64>, mut columns: Vec<DVector<f64>>) -> f64 {
        let mut forces = forces.clone();
        let rescale = |vector: &mut DVector<f64>| {
            (0..self.scene.bodies.len()).for_each(|k| vector[3 * k + 2] /= self.length);
        };
        rescale(&mut forces);
        columns.iter_mut().for_each(rescale);
        // Gram and Schmidt, twice: those that depend on others to rounding are left out.
        let mut basis: Vec<DVector<f64>> = Vec::new();
        let project = |vector: &mut DVector<f64>, basis: &[DVector<f64>]| {
            (0..2).flat_map(|_| basis).for_each(|e| *vector -= e * e.dot(vector));
        };
        for mut column in columns {
            let size = column.norm();
            project(&mut column, &basis);
            if column.norm() > 1e-9 * size {
                basis.push(column.normalize());
            }
        }
        project(&mut forces, &basis);
        forces.amax()
    }

    /// What holds in any row between events.
    fn check_row(&self, row: &Row) -> Result<(), Finding> {
        let t = row.t;
        let inertial = self.compute_inertial_forces(row, 2);
        let (loads, _) = self.compute_loads(row);
        let (reactions, _) = self.compute_reactions(row);
        let size = inertial.amax() + loads.amax() + reactions.amax() + self.force_scale(row);
        let left_over = self.compute_unborne(&(&inertial - &loads - &reactions), self.list_joints(row));
        small(t, left_over, ROUNDING * size, || "Newton's equations".to_owned())?;
        self.check_joints(row)?;
        self.check_contacts(row, size)
    }

    /// The size of forces, also where they cancel.
    fn force_scale(&self, row: &Row) -> f64 {
        let contacts = row.contacts.iter().map(|contact| contact.normal.abs());
        contacts.chain(row.drives.iter().map(|x| x.abs())).fold(self.natural_force(), f64::max)
    }

    /// Weights, and what turns velocities within lengths.
    fn natural_force(&self) -> f64 {
        self.mass() * (norm(self.scene.gravity) + self.speed.powi(2) / self.length)
    }

    fn check_joints(&self, row: &Row) -> Result<(), Finding> {
        let (t, bound) = (row.t, MOTION * self.length);
        for pin in &self.scene.pins {
            let off = norm(subtract(self.locate(row, pin)[0], self.scene.points[pin].position));
            small(t, off, bound, || format!("pin {pin}"))?;
        }
        for body in &self.scene.bodies {
            for (name, local) in [(&body.ends[1], [body.length, 0.0])]
                .into_iter()
                .chain(body.spots.iter().map(|(n, at)| (n, *at)))
            {
                let expected = self.place_in_body(row, body, local);
                let off = (0..3).map(|k| norm(subtract(self.locate(row, name)[k], expected[k])));
                let [off, rate, _] = [0, 1, 2].map(|k| off.clone().nth(k).unwrap_or(0.0));
                small(t, off, bound, || format!("{name} on {}", body.name))?;
                small(t, rate, MOTION * self.speed, || format!("velocity of {name} on {}", body.name))?;
            }
        }
        for slider in &self.scene.sliders {
            small(t, self.measure_guide(row, &slider.point, &slider.guide).0, bound, || {
                format!("slider {}", slider.point)
            })?;
        }
        for drive in &self.scene.drives {
            let value = match &drive.target {
                Target::Angle(body) => self.measure_torsion(row, None, *body).0,
                Target::Between(first, second) => self.measure_torsion(row, Some(*first), *second).0,
                Target::Distance([a, b]) => norm(subtract(self.locate(row, b)[0], self.locate(row, a)[0])),
            };
            small(t, value - drive.wave.value(t), MOTION * (1.0 + value.abs()), || "drive".to_owned())?;
        }
        for [a, b] in &self.scene.welds {
            let [a, b] = [a, b].map(|k| &self.scene.bodies[*k]);
            let turned = self.angle(row, b) - self.angle(row, a) - (b.angle - a.angle);
            small(t, (turned / 2.0).sin(), MOTION, || "weld".to_owned())?;
        }
        Ok(())
    }

    fn check_contacts(&self, row: &Row, force: f64) -> Result<(), Finding> {
        let t = row.t;
        let far = MOTION * self.length;
        for (support, contact) in self.scene.supports.iter().zip(&row.contacts) {
            let Touch { gap, tangent, slip, is_within, .. } = self.find_touch(row, support);
            let name = &support.point;
            small(t, gap - contact.gap, ROUNDING * (self.length + gap.abs()), || {
                format!("gap of {name} is {gap:e}")
            })?;
            if matches!(support.shape, Shape::Bar { .. }) {
                if !is_within && contact.normal != 0.0 {
                    return wrong(t, || format!("{name} bears {:e} beyond the end", contact.normal));
                }
            } else if gap < -far {
                return wrong(t, || format!("{name} is below its ground by {gap:e}"));
            }
            if contact.normal != 0.0 && gap > far {
                return wrong(t, || format!("{name} bears {:e} at a gap of {gap:e}", contact.normal));
            }
            let slip = dot(tangent, slip) - support.moving.value(t);
            if support.is_rough && contact.normal != 0.0 {
                small(t, slip, MOTION * self.speed, || format!("{name} is rough and slips"))?;
            }
            self.check_force(t, contact, support.friction, (slip, force))?;
        }
        for (thread, contact) in self.scene.threads.iter().zip(&row.contacts[self.scene.supports.len()..]) {
            let parts = thread.path.windows(2);
            let long: f64 = parts
                .map(|ends| norm(subtract(self.locate(row, &ends[1])[0], self.locate(row, &ends[0])[0])))
                .sum();
            let slack = thread.length - long;
            if slack < -far || (contact.normal != 0.0 && slack > far) {
                return wrong(t, || {
                    format!("{} bears {:e} at a slack of {slack:e}", thread.name, contact.normal)
                });
            }
            self.check_force(t, contact, None, (0.0, force))?;
        }
        Ok(())
    }

    fn check_force(
        &self,
        t: f64,
        contact: &ContactRow,
        friction: Option<[f64; 2]>,
        (slip, force): (f64, f64),
    ) -> Result<(), Finding> {
        let (name, normal) = (&contact.name, contact.normal);
        if normal > LARGEST * self.natural_force() {
            return wrong(t, || format!("{name} bears {normal:e}: its gap hardly depends on the motion"));
        }
        if normal < -MOTION * force {
            return wrong(t, || format!("{name} pulls: {normal:e} of {force:e}"));
        }
        let (Some([kinetic, holding]), Some([along, told])) = (friction, contact.friction) else {
            return Ok(());
        };
        if normal == 0.0 {
            return small(t, along, ROUNDING * force, || format!("friction of {name}, which is open"));
        }
        small(t, slip - told, MOTION * self.speed, || format!("slip of {name} is {slip:e}"))?;
        let bound = MOTION * force;
        if slip.abs() > SLIP * self.speed {
            let expected = -kinetic * normal * slip.signum();
            return small(t, along - expected, bound, || {
                format!("friction of {name}, which slides at {slip:e}")
            });
        }
        small(t, (along.abs() - holding.max(kinetic) * normal).max(0.0), bound, || {
            format!("cone of friction of {name}")
        })
    }

    fn check_segments(&self) -> Result<(), Finding> {
        let run = &self.motion.run;
        let mut times: Vec<f64> = run.events().iter().map(|event| event.t).collect();
        times.push(run.end_time());
        times.dedup();
        let total = run.end_time();
        for pair in times.windows(2) {
            let (from, long) = (pair[0], pair[1] - pair[0]);
            if long < 1e-5 * total {
                continue;
            }
            // A reaction grows beyond all bounds before an impact without collision.
            let diverges = |event: &Event| event.t == pair[1] && event.note == Some(Note::WithoutCollision);
            let inset = if run.events().iter().any(diverges) { 1e-2 } else { 1e-7 } * long;
            let count = ((long / total * WINDOWS as f64).ceil() as usize).max(1);
            let at = |k: usize| from + inset + (long - 2.0 * inset) * k as f64 / count as f64;
            for k in 0..count {
                self.check_window(&self.motion.row(at(k), false), &self.motion.row(at(k + 1), false), 0)?;
            }
        }
        Ok(())
    }

    /// ∫ v = Δx, ∫ a = Δv of each point, and ∫ P = ΔE, between two rows.
    fn check_window(&self, first: &Row, last: &Row, depth: u32) -> Result<(), Finding> {
        let half = (last.t - first.t) / 2.0;
        let rows: Vec<(Row, f64)> = NODES
            .iter()
            .flat_map(|[x, weight]| [-x, *x].map(|x| (first.t + half * (1.0 + x), half * weight)))
            .map(|(t, weight)| (self.motion.row(t, false), weight))
            .collect();
        if depth == 0 {
            [0, 3, 6].iter().try_for_each(|k| self.check_row(&rows[*k].0))?;
        }
        let mut found = Ok(());
        for (name, start) in &first.points {
            let end = last.points[name];
            for (k, what, size) in [(1, "velocity", self.length), (2, "acceleration", self.speed)] {
                let sum =
                    rows.iter().fold([0.0; 2], |sum, (row, w)| add(sum, scale(*w, row.points[name][k])));
                let change = subtract(end[k - 1], start[k - 1]);
                let bound = MOTION * (size + norm(sum));
                found = found.and_then(|()| {
                    small(first.t, norm(subtract(change, sum)), bound, || {
                        format!("integral of the {what} of {name} to {:?}", last.t)
                    })
                });
            }
        }
        let power = |row: &Row| self.compute_loads(row).1 + self.compute_reactions(row).1.iter().sum::<f64>();
        let work: f64 = rows.iter().map(|(row, w)| w * power(row)).sum();
        let [before, after] = [first, last].map(|row| row.energies[0] + row.energies[1]);
        let size = first.energies[0].abs() + first.energies[1].abs() + last.energies[1].abs() + work.abs();
        let natural = self.mass() * self.speed.powi(2);
        found = found.and_then(|()| {
            small(first.t, after - before - work, MOTION * 10.0 * (size + natural), || {
                format!("work of the loads to {:?}", last.t)
            })
        });
        if found.is_ok() || (depth >= HALVINGS && rows.iter().any(|(row, _)| self.has_coiled_spring(row))) {
            return Ok(());
        }
        if depth >= HALVINGS {
            return found;
        }
        let middle = self.motion.row(first.t + half, false);
        self.check_window(first, &middle, depth + 1)?;
        self.check_window(&middle, last, depth + 1)
    }

    /// Whether the ends of a spring all but meet: there its force turns round.
    fn has_coiled_spring(&self, row: &Row) -> bool {
        self.scene.springs.iter().any(|spring| {
            let [a, b] = [0, 1].map(|k| self.locate(row, &spring.ends[k])[0]);
            norm(subtract(b, a)) < 1e-3 * self.length
        })
    }

    fn mass(&self) -> f64 {
        let bodies = self.scene.bodies.iter().map(|body| body.mass);
        bodies.chain(self.scene.particles.iter().chain(&self.scene.masses).map(|(_, mass)| *mass)).sum()
    }

    /// Positions are continuous everywhere, velocities but at impacts; and impacts keep their laws.
    fn check_events(&self) -> Result<(), Finding> {
        let events = self.motion.run.events();
        let end = self.motion.run.end_time();
        for (k, event) in events.iter().enumerate() {
            let is_alone =
                |other: usize| events.get(other).is_none_or(|near| (near.t - event.t).abs() > APART * end);
            if event.t <= 0.0 || !(k == 0 || is_alone(k - 1)) || !is_alone(k + 1) {
                continue;
            }
            let aside = 1e-9 * end;
            if event.before.is_none() {
                if event.t + aside > end {
                    continue;
                }
                let [a, b] = [event.t - aside, event.t + aside].map(|t| self.motion.row(t, false));
                for (name, before) in &a.points {
                    let after = b.points[name];
                    let jump = norm(subtract(after[1], before[1]));
                    let bound = MOTION * self.speed + 2.0 * aside * (norm(before[2]) + norm(after[2]));
                    small(event.t, jump, bound, || format!("{name} jumps in velocity at {}", event.kind))?;
                    let moved = norm(subtract(after[0], before[0]));
                    let bound = MOTION * self.length + 2.0 * aside * (norm(before[1]) + norm(after[1]));
                    small(event.t, moved, bound, || format!("{name} jumps at {}", event.kind))?;
                }
            } else {
                self.check_impact(event)?;
            }
        }
        Ok(())
    }

    fn check_impact(&self, event: &Event) -> Result<(), Finding> {
        let t = event.t;
        let output = |is_before| self.motion.row(Instant { t, is_before }.t, is_before);
        let [before, after] = [true, false].map(output);
        for (name, place) in &before.points {
            let moved = norm(subtract(after.points[name][0], place[0]));
            small(t, moved, MOTION * self.length, || format!("{name} jumps in an impact"))?;
        }
        let mut change = self.compute_inertial_forces(&after, 1) - self.compute_inertial_forces(&before, 1);
        let mut columns = self.list_joints(&before);
        let told: BTreeMap<&str, [f64; 2]> =
            event.impulses.iter().map(|one| (one.label, [one.value, one.friction.unwrap_or(0.0)])).collect();
        let scene = self.scene;
        let mut size = change.amax();
        let mut unknown: Vec<DVector<f64>> = Vec::new();
        for (k, support) in scene.supports.iter().enumerate() {
            let touch = self.find_touch(&before, support);
            let column = |force: Vector| {
                let mut column = DVector::zeros(self.size());
                self.push_at(&mut column, &before, &support.point, (touch.place, force));
                if let Some((body, foot)) = touch.under {
                    self.push_body(&mut column, &before, body, foot, scale(-1.0, force));
                }
                column
            };
            let [normal, along] = [touch.normal, touch.tangent].map(column);
            match told.get(support.point.as_str()) {
                Some([value, friction]) => {
                    size = size.max(value.abs());
                    change -= &normal * *value + &along * *friction;
                    if support.is_rough {
                        unknown.push(along);
                    }
                    self.check_struck(t, support, [*value, *friction])?;
                }
                None if touch.gap.abs() < MOTION * self.length && before.contacts[k].normal != 0.0 => {
                    unknown.push(normal);
                    if support.friction.is_some() || support.is_rough {
                        unknown.push(along);
                    }
                }
                None => {}
            }
        }
        for thread in &scene.threads {
            let mut column = DVector::zeros(self.size());
            for ends in thread.path.windows(2) {
                let arm = subtract(self.locate(&before, &ends[1])[0], self.locate(&before, &ends[0])[0]);
                let pull = scale(1.0 / norm(arm), arm);
                self.push(&mut column, &before, &ends[0], pull);
                self.push(&mut column, &before, &ends[1], scale(-1.0, pull));
            }
            match told.get(thread.name.as_str()) {
                Some([value, _]) => {
                    size = size.max(value.abs());
                    change -= column * *value;
                }
                None => unknown.push(column),
            }
        }
        for slider in &scene.sliders {
            let mut column = DVector::zeros(self.size());
            let (_, normal) = self.measure_guide(&before, &slider.point, &slider.guide);
            self.push(&mut column, &before, &slider.point, normal);
            columns.push(column);
        }
        for k in 0..scene.drives.len() {
            let mut unit = before.clone();
            unit.contacts.iter_mut().for_each(|contact| {
                contact.normal = 0.0;
                contact.friction = None;
            });
            unit.sliders.fill(0.0);
            unit.drives.fill(0.0);
            unit.drives[k] = 1.0;
            columns.push(self.compute_reactions(&unit).0);
        }
        columns.extend(unknown);
        let bound = MOTION * 10.0 * (size + self.mass() * self.speed);
        small(t, self.compute_unborne(&change, columns), bound, || {
            format!("momentum at {} of {:?}", event.kind, event.supports)
        })?;
        self.check_restitution(event, &before, &after, &told)
    }

    fn check_struck(&self, t: f64, support: &Support, [value, friction]: [f64; 2]) -> Result<(), Finding> {
        let bound = MOTION * (value.abs() + self.mass() * self.speed);
        let name = &support.point;
        if value < -bound {
            return wrong(t, || format!("impulse of {name} pulls: {value:e}"));
        }
        let Some([kinetic, holding]) = support.friction else { return Ok(()) };
        let most = kinetic.max(holding) * value;
        small(t, (friction.abs() - most).max(0.0), bound, || {
            format!("cone of friction of the impulse of {name}")
        })
    }

    /// Newton's law at contacts that alone are struck: ġ⁺ = −e ġ⁻.
    fn check_restitution(
        &self,
        event: &Event,
        before: &Row,
        after: &Row,
        told: &BTreeMap<&str, [f64; 2]>,
    ) -> Result<(), Finding> {
        // Impacts so slow that they end within the tolerance are plastic.
        let bound = RESTITUTION * self.speed;
        for support in &self.scene.supports {
            let [approach, parting] = [before, after].map(|row| {
                let touch = self.find_touch(row, support);
                dot(touch.normal, touch.slip)
            });
            let struck = told.get(support.point.as_str()).is_some_and(|[value, _]| *value > 0.0);
            if !struck {
                continue;
            }
            if parting < -bound {
                return wrong(event.t, || {
                    format!("{} goes on into its ground at {parting:e}", support.point)
                });
            }
            let is_newton = !(support.is_poisson && support.restitution > 0.0);
            let is_alone =
                event.kind == EventKind::Impact && event.supports.len() == 1 && event.note.is_none();
            let others = told.values().filter(|[value, _]| *value != 0.0).count();
            let is_blocked = self.is_on_circle(&support.point) && {
                let touch = self.find_touch(after, support);
                let slip = dot(touch.tangent, touch.slip) - support.moving.value(event.t);
                slip.abs() < RESTITUTION * self.speed
            };
            let is_asked = is_alone && is_newton && others == 1 && !is_blocked;
            if is_asked && !self.is_undecided(event.t) && approach < -bound {
                let expected = -support.restitution * approach;
                small(event.t, parting - expected, bound, || {
                    format!("restitution of {}: {approach:e} to {parting:e}", support.point)
                })?;
            }
        }
        let [had, has] = [before, after].map(|row| row.energies[0]);
        let gained = matches!(event.note, Some(liftoff::Note::EnergyGained(_)));
        let is_still = self.scene.drives.is_empty()
            && self.scene.supports.iter().all(|support| support.moving.is_zero());
        if is_still && !gained && has > had + MOTION * 10.0 * self.mass() * self.speed.powi(2) {
            return wrong(event.t, || format!("an impact gains energy: {had:e} to {has:e}"));
        }
        Ok(())
    }

    /// Whether a point moves along a circle alone: on a moving ground it has one velocity without
    /// slip, and once friction holds it there no impulse gives it another.
    fn is_on_circle(&self, point: &str) -> bool {
        self.scene.bodies_at(point).any(|(k, _)| {
            let body = &self.scene.bodies[k];
            let spots = body.spots.iter().map(|(name, _)| name);
            body.ends.iter().chain(spots).any(|name| name != point && self.scene.is_fixed(name))
        })
    }

    /// Whether the run says that the law of restitution does not decide an impact.
    fn is_undecided(&self, t: f64) -> bool {
        use liftoff::LoggedDecision::{ImpulsesNotUnique, RestitutionScaled, SeveralImpacts};
        let says = |decision: &liftoff::LoggedDecision| {
            matches!(decision, RestitutionScaled(_) | ImpulsesNotUnique | SeveralImpacts(_))
        };
        self.motion.run.log().iter().any(|entry| entry.t == t && says(&entry.decision))
    }
}
