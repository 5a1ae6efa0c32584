//! A planar scene in numbers, in the pose and with the velocities of its start.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

pub type Vector = [f64; 2];

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

pub fn subtract(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub fn scale(factor: f64, a: Vector) -> Vector {
    a.map(|x| factor * x)
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// a × b, positive counter-clockwise.
pub fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A quarter turn to the left.
pub fn left(a: Vector) -> Vector {
    [-a[1], a[0]]
}

pub fn direction(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

pub fn norm(a: Vector) -> f64 {
    a[0].hypot(a[1])
}

/// (cos, sin) of the angle times x, plus its left normal times y.
pub fn turn(angle: f64, [x, y]: Vector) -> Vector {
    let e = direction(angle);
    add(scale(x, e), scale(y, left(e)))
}

/// In what words a body is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    Bar,
    Body,
    /// A bar without mass that carries m/6, 2m/3 and m/6: those of a uniform bar, by Simpson's
    /// rule.
    Masses,
}

/// From where the coordinate of a body's angle is counted: so many quarter turns from the right, or
/// another body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    Quarters(i32),
    Body(usize),
}

/// A rigid body. Its frame has the first end as origin, and the second on its first axis.
#[derive(Clone, Debug)]
pub struct Body {
    pub name: String,
    pub mass: f64,
    pub inertia: f64,
    pub centre: Vector,
    pub length: f64,
    pub ends: [String; 2],
    /// Further points, in its frame.
    pub spots: Vec<(String, Vector)>,
    pub angle: f64,
    pub rate: f64,
    pub look: Look,
    pub reference: Reference,
}

impl Body {
    /// Where a point is in its frame; none of points of other bodies.
    pub fn local(&self, point: &str) -> Option<Vector> {
        let ends = [[0.0, 0.0], [self.length, 0.0]];
        let end = self.ends.iter().position(|end| end == point).map(|k| ends[k]);
        end.or_else(|| self.spots.iter().find(|(name, _)| name == point).map(|(_, at)| *at))
    }

    /// Whether it is the uniform bar between its ends.
    pub fn is_uniform(&self) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12 * b;
        close(self.inertia, self.mass * self.length.powi(2) / 12.0)
            && close(self.centre[0], self.length / 2.0)
            && self.centre[1] == 0.0
    }
}

/// A place at the start, with its velocity.
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    pub position: Vector,
    pub velocity: Vector,
}

/// mean + amplitude sin(rate t + phase).
#[derive(Clone, Copy, Debug, Default)]
pub struct Wave {
    pub mean: f64,
    pub amplitude: f64,
    pub rate: f64,
    pub phase: f64,
}

impl Wave {
    pub fn opposite(self) -> Self {
        Self { mean: -self.mean, amplitude: -self.amplitude, ..self }
    }

    pub fn is_zero(&self) -> bool {
        self.mean == 0.0 && self.amplitude == 0.0
    }

    pub fn value(&self, t: f64) -> f64 {
        self.mean + self.amplitude * (self.rate * t + self.phase).sin()
    }

    /// Its derivative.
    pub fn slope(&self, t: f64) -> f64 {
        self.amplitude * self.rate * (self.rate * t + self.phase).cos()
    }
}

/// Where a point may be.
#[derive(Clone, Debug)]
pub enum Shape {
    /// On the left of a line.
    Line { angle: f64, through: Vector },
    /// Outside a circle, or inside it.
    Circle { centre: Vector, radius: f64, inside: bool },
    /// On the left of a body seen from its first end, or on the right; between the ends.
    Bar { body: usize, is_left: bool },
}

/// A one-sided contact.
#[derive(Clone, Debug)]
pub struct Support {
    pub point: String,
    pub shape: Shape,
    /// Kinetic and static coefficients.
    pub friction: Option<[f64; 2]>,
    /// No slip while it is closed.
    pub is_rough: bool,
    /// The speed of a line along itself.
    pub moving: Wave,
    /// Of the disc about the point.
    pub radius: f64,
    pub restitution: f64,
    pub is_poisson: bool,
}

/// Two-sided: what a point stays on.
#[derive(Clone, Debug)]
pub enum Guide {
    Line { angle: f64, through: Vector },
    Circle { centre: Vector, radius: f64 },
}

#[derive(Clone, Debug)]
pub struct Slider {
    pub point: String,
    pub guide: Guide,
}

#[derive(Clone, Debug)]
pub struct Thread {
    pub name: String,
    pub path: Vec<String>,
    pub length: f64,
    pub restitution: f64,
}

#[derive(Clone, Debug)]
pub struct Spring {
    pub name: String,
    pub ends: [String; 2],
    pub stiffness: f64,
    pub length: f64,
    pub damping: f64,
}

/// Between the direction of the first body, or the right, and that of the second: torque −k (Δ − a)
/// − c Δ̇.
#[derive(Clone, Debug)]
pub struct Torsion {
    pub first: Option<usize>,
    pub second: usize,
    pub stiffness: f64,
    pub angle: f64,
    pub damping: f64,
}

/// A force of one direction that varies in time, and drag −c v.
#[derive(Clone, Debug)]
pub struct Force {
    pub name: String,
    pub point: String,
    pub along: Vector,
    pub wave: Wave,
    pub drag: f64,
    /// When it ceases.
    pub until: Option<f64>,
}

/// A couple on a body, and its opposite on another one or the ground.
#[derive(Clone, Debug)]
pub struct Couple {
    pub name: String,
    pub body: usize,
    pub from: Option<usize>,
    pub wave: Wave,
}

/// What is prescribed.
#[derive(Clone, Debug)]
pub enum Target {
    Angle(usize),
    Between(usize, usize),
    Distance([String; 2]),
}

#[derive(Clone, Debug)]
pub struct Drive {
    pub target: Target,
    pub wave: Wave,
}

/// Everything that is declared, and the start.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub gravity: Vector,
    pub bodies: Vec<Body>,
    pub particles: Vec<(String, f64)>,
    pub masses: Vec<(String, f64)>,
    pub pins: Vec<String>,
    pub grounds: Vec<String>,
    /// Fixed points under bodies that are declared as corners.
    pub corners: Vec<String>,
    /// Pairs of bodies whose angle to each other stays.
    pub welds: Vec<[usize; 2]>,
    pub sliders: Vec<Slider>,
    pub supports: Vec<Support>,
    pub threads: Vec<Thread>,
    pub springs: Vec<Spring>,
    pub torsions: Vec<Torsion>,
    pub forces: Vec<Force>,
    pub couples: Vec<Couple>,
    pub drives: Vec<Drive>,
    pub points: BTreeMap<String, Place>,
    pub limit: f64,
    /// So many sets of closed contacts have equations of their own.
    pub sets: usize,
    /// The vertical line that it is declared to be symmetric about.
    pub mirror: Option<f64>,
}

impl Scene {
    /// The bodies that a point belongs to, with its place in the frame of each.
    pub fn bodies_at<'a>(&'a self, point: &'a str) -> impl Iterator<Item = (usize, Vector)> + 'a {
        self.bodies.iter().enumerate().filter_map(move |(k, body)| Some((k, body.local(point)?)))
    }

    /// Whether a point may go round an end of what it lies on.
    pub fn has_bars_as_ground(&self) -> bool {
        self.supports.iter().any(|support| matches!(support.shape, Shape::Bar { .. }))
    }

    pub fn is_fixed(&self, point: &str) -> bool {
        self.grounds.iter().chain(&self.corners).chain(&self.pins).any(|name| name == point)
    }

    /// Positions of a body's points from one of them and its angle.
    pub fn place_body(&mut self, body: usize, from: &str) {
        let Body { angle, rate, .. } = self.bodies[body];
        let (Some(local), Some(known)) = (self.bodies[body].local(from), self.points.get(from).copied())
        else {
            return;
        };
        let own = self.bodies[body].clone();
        let names = own.ends.iter().chain(own.spots.iter().map(|(name, _)| name));
        for name in names.filter(|name| *name != from) {
            let arm = turn(angle, subtract(own.local(name).unwrap_or_default(), local));
            let position = add(known.position, arm);
            let velocity = add(known.velocity, scale(rate, left(arm)));
            self.points.insert(name.clone(), Place { position, velocity });
        }
    }
}

impl Scene {
    /// What is prescribed, as it is at the start.
    pub fn measure_target(&self, target: &Target) -> f64 {
        match target {
            Target::Angle(body) => self.measure_angle(None, *body),
            Target::Between(first, second) => self.measure_angle(Some(*first), *second),
            Target::Distance([a, b]) => norm(subtract(self.points[b].position, self.points[a].position)),
        }
    }

    /// The direction of a body at the start, or its angle from another: within half a turn.
    pub fn measure_angle(&self, from: Option<usize>, to: usize) -> f64 {
        let direction = |k: usize| unwind(self.bodies[k].angle);
        unwind(direction(to) - from.map_or(0.0, direction))
    }

    /// Springs and drives turned from the start as far as those of another scene, in the same sense
    /// or the opposite one.
    pub fn turn_as_in(&mut self, other: &Self, sense: f64) {
        for k in 0..self.torsions.len() {
            let Torsion { first, second, .. } = self.torsions[k];
            let bent = other.torsions[k].angle - other.measure_angle(first, second);
            self.torsions[k].angle = self.measure_angle(first, second) + sense * bent;
        }
        for k in 0..self.drives.len() {
            let target = &self.drives[k].target;
            if !matches!(target, Target::Distance(_)) {
                let Wave { mean, amplitude, .. } = other.drives[k].wave;
                let mean = self.measure_target(target) + sense * (mean - other.measure_target(target));
                self.drives[k].wave = Wave { mean, amplitude: sense * amplitude, ..other.drives[k].wave };
            }
        }
    }
}

/// An angle within half a turn; a straight one is positive.
pub fn unwind(angle: f64) -> f64 {
    let rest = angle.rem_euclid(TAU);
    if rest > PI + 1e-9 { rest - TAU } else { rest }
}

impl Scene {
    /// The same from a later time on: what depends on time is that of then.
    pub fn after(&self, from: f64) -> Self {
        let mut scene = self.clone();
        let waves = scene.forces.iter_mut().map(|force| &mut force.wave);
        let waves = waves.chain(scene.couples.iter_mut().map(|couple| &mut couple.wave));
        let waves = waves.chain(scene.drives.iter_mut().map(|drive| &mut drive.wave));
        let waves = waves.chain(scene.supports.iter_mut().map(|support| &mut support.moving));
        waves.for_each(|wave| wave.phase += wave.rate * from);
        scene.forces.iter_mut().filter_map(|force| force.until.as_mut()).for_each(|until| *until -= from);
        scene.limit -= from;
        scene
    }
}
