//! Equal forms of a scene: what they are, and how their motions correspond.

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;

use liftoff_tests::random::Source;

use super::draw;
use super::image::{join, line_angles, move_places, reflect, rename};
use super::print;
use super::scene::{
    Body, Guide, Look, Place, Reference, Scene, Shape, Target, Vector, Wave, add, scale, turn,
};

/// How positions of the scene are those of its form: reflected at x = 0 or not, turned, shifted, in
/// other units.
#[derive(Clone, Copy, Debug)]
pub struct Map {
    pub is_reflected: bool,
    pub angle: f64,
    pub shift: Vector,
    /// Of length, time and mass: a number of the form is so many times that of the scene.
    pub units: [f64; 3],
}

impl Default for Map {
    fn default() -> Self {
        Self { is_reflected: false, angle: 0.0, shift: [0.0; 2], units: [1.0; 3] }
    }
}

impl Map {
    fn vector(&self, [x, y]: Vector) -> Vector {
        turn(self.angle, [if self.is_reflected { -x } else { x }, y])
    }

    pub fn position(&self, at: Vector) -> Vector {
        scale(self.units[0], add(self.vector(at), self.shift))
    }

    pub fn velocity(&self, of: Vector) -> Vector {
        scale(self.units[0] / self.units[1], self.vector(of))
    }

    /// The unit of forces.
    pub fn force(&self) -> f64 {
        self.units[2] * self.units[0] / self.units[1].powi(2)
    }
}

/// One way to declare a scene otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    Reflected,
    /// By an angle, and shifted.
    Turned(f64, Vector),
    /// Larger by these factors.
    Units([f64; 3]),
    /// Attributes in another order.
    Order(u64),
    /// Some bodies from their other ends.
    Reversed(u64),
    /// Bars as bodies, bodies as bars, uniform bars as point masses; corners as fixed points at
    /// bars.
    Looks(u64),
    /// Angles counted from elsewhere.
    References(u64),
    /// Numbers as parameters.
    Parameters,
    /// With a copy of itself, or another scene, that nothing joins to it.
    Beside(u64),
    /// With equations of their own for so many sets of closed contacts.
    Sets(usize),
    /// Declared as symmetric.
    Mirror,
    /// Stopped after this part of its time, and started again.
    Split(f64),
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Reflected => "reflected",
            Self::Turned(..) => "turned",
            Self::Units(_) => "units",
            Self::Order(_) => "order",
            Self::Reversed(_) => "reversed",
            Self::Looks(_) => "looks",
            Self::References(_) => "references",
            Self::Parameters => "parameters",
            Self::Beside(_) => "beside",
            Self::Sets(_) => "sets",
            Self::Mirror => "mirror",
            Self::Split(_) => "split",
        })
    }
}

/// A scene with the words in which it is declared.
#[derive(Clone, Debug)]
pub struct Form {
    pub scene: Scene,
    pub map: Map,
    order: Option<u64>,
    are_parameters: bool,
}

impl Form {
    pub fn new(scene: Scene) -> Self {
        Self { scene, map: Map::default(), order: None, are_parameters: false }
    }

    /// The same after a change.
    pub fn apply(self, change: Change) -> Self {
        let Self { scene, map, order, are_parameters } = self;
        let with = |scene: Scene| Self { scene, map, order, are_parameters };
        match change {
            Change::Reflected => Self { map: Map { is_reflected: true, ..map }, ..with(reflect(&scene)) },
            Change::Turned(angle, shift) => {
                Self { map: Map { angle, shift, ..map }, ..with(turn_scene(&scene, angle, shift)) }
            }
            Change::Units(units) => Self { map: Map { units, ..map }, ..with(scale_units(&scene, units)) },
            Change::Order(seed) => Self { order: Some(seed), ..with(scene) },
            Change::Parameters => Self { are_parameters: true, ..with(scene) },
            Change::Reversed(seed) => with(reverse_some(&scene, seed)),
            Change::Looks(seed) => with(change_looks(scene, seed)),
            Change::References(seed) => with(change_references(scene, seed)),
            Change::Beside(seed) => with(put_beside(&scene, seed)),
            Change::Sets(sets) => with(Scene { sets, ..scene }),
            Change::Mirror => with(Scene { mirror: Some(0.0), ..scene }),
            Change::Split(_) => with(scene),
        }
    }

    /// Its file.
    pub fn declare(&self) -> String {
        let shuffle = |lines: &mut Vec<String>| {
            if let Some(seed) = self.order {
                let mut source = Source::new(seed);
                (1..lines.len()).for_each(|k| lines.swap(k, source.below(k + 1)));
            }
        };
        print::declare(&self.scene, self.are_parameters, shuffle)
    }
}

/// Some changes that fit together, in the order in which they are made.
pub fn draw_changes(scene: &Scene, source: &mut Source) -> Vec<Change> {
    let is_symmetric = scene.points.keys().any(|name| name.ends_with('m'));
    let mut seed = || (source.unit() * 2f64.powi(52)) as u64;
    let seeds = [0; 5].map(|_: i32| seed());
    match source.below(14) {
        0 => return vec![Change::Beside(seeds[0])],
        1 | 2 => return vec![Change::Split(source.range(0.1, 0.9))],
        3..9 if is_symmetric => return vec![Change::Mirror],
        _ => {}
    }
    let shift = [source.range(-3.0, 3.0), source.range(-3.0, 3.0)];
    let angle = match source.below(5) {
        0 => source.choose(&[FRAC_PI_2, PI, -FRAC_PI_2]),
        1 => 0.0,
        _ => source.range(-3.1, 3.1),
    };
    let factor = |source: &mut Source| source.choose(&[1.0, 2.0, 0.001, 1000.0, 0.3048, 60.0]);
    let all = [
        Change::Parameters,
        Change::Looks(seeds[0]),
        Change::References(seeds[1]),
        Change::Reversed(seeds[2]),
        Change::Reflected,
        Change::Turned(angle, shift),
        Change::Units([0; 3].map(|_: i32| factor(source))),
        Change::Order(seeds[3]),
        Change::Sets(if scene.sets == 64 { 0 } else { 8 }),
    ];
    let wanted = source.below(all.len());
    let chosen = all.iter().enumerate().filter(|(k, _)| *k == wanted || source.chance(0.2));
    chosen.map(|(_, change)| *change).collect()
}

fn turn_scene(scene: &Scene, by: f64, shift: Vector) -> Scene {
    let place = |Place { position, velocity }| Place {
        position: add(turn(by, position), shift),
        velocity: turn(by, velocity),
    };
    let mut turned = move_places(scene, place);
    turned.gravity = turn(by, scene.gravity);
    turned.bodies.iter_mut().for_each(|body| body.angle += by);
    line_angles(&mut turned).for_each(|angle| *angle += by);
    turned.forces.iter_mut().for_each(|force| force.along = turn(by, force.along));
    turned.turn_as_in(scene, 1.0);
    turned
}

fn scale_units(scene: &Scene, [length, time, mass]: [f64; 3]) -> Scene {
    let (speed, force) = (length / time, mass * length / time.powi(2));
    let place = |Place { position, velocity }| Place {
        position: scale(length, position),
        velocity: scale(speed, velocity),
    };
    let mut scene = move_places(scene, place);
    let wave = |wave: &mut Wave, unit: f64| {
        wave.mean *= unit;
        wave.amplitude *= unit;
        wave.rate /= time;
    };
    scene.gravity = scale(length / time.powi(2), scene.gravity);
    scene.limit *= time;
    for body in &mut scene.bodies {
        body.mass *= mass;
        body.inertia *= mass * length.powi(2);
        body.length *= length;
        body.centre = scale(length, body.centre);
        body.rate /= time;
        body.spots.iter_mut().for_each(|(_, at)| *at = scale(length, *at));
    }
    scene.particles.iter_mut().chain(&mut scene.masses).for_each(|(_, own)| *own *= mass);
    for support in &mut scene.supports {
        support.radius *= length;
        wave(&mut support.moving, speed);
        if let Shape::Circle { radius, .. } = &mut support.shape {
            *radius *= length;
        }
    }
    for slider in &mut scene.sliders {
        if let Guide::Circle { radius, .. } = &mut slider.guide {
            *radius *= length;
        }
    }
    scene.threads.iter_mut().for_each(|thread| thread.length *= length);
    for spring in &mut scene.springs {
        spring.length *= length;
        spring.stiffness *= force / length;
        spring.damping *= force / speed;
    }
    for torsion in &mut scene.torsions {
        torsion.stiffness *= force * length;
        torsion.damping *= force * length * time;
    }
    for load in &mut scene.forces {
        wave(&mut load.wave, force);
        load.drag *= force / speed;
        load.until = load.until.map(|until| until * time);
    }
    scene.couples.iter_mut().for_each(|couple| wave(&mut couple.wave, force * length));
    for drive in &mut scene.drives {
        let unit = if matches!(drive.target, Target::Distance(_)) { length } else { 1.0 };
        wave(&mut drive.wave, unit);
    }
    scene
}

fn reverse_some(original: &Scene, seed: u64) -> Scene {
    let (mut source, mut scene) = (Source::new(seed), original.clone());
    let chosen: Vec<bool> = scene.bodies.iter().map(|_| source.chance(0.7)).collect();
    for k in (0..chosen.len()).filter(|k| chosen[*k]) {
        let Body { length, ends, angle, centre, spots, .. } = &mut scene.bodies[k];
        let other = |[x, y]: Vector| [*length - x, -y];
        *centre = other(*centre);
        spots.iter_mut().for_each(|(_, at)| *at = other(*at));
        ends.swap(0, 1);
        *angle += if *angle > 0.0 { -PI } else { PI };
        for support in &mut scene.supports {
            match &mut support.shape {
                Shape::Bar { body, is_left } if *body == k => *is_left = !*is_left,
                _ => {}
            }
        }
    }
    scene.turn_as_in(original, 1.0);
    scene
}

fn change_looks(mut scene: Scene, seed: u64) -> Scene {
    let mut source = Source::new(seed);
    for body in &mut scene.bodies {
        let looks = match body.is_uniform() {
            true => &[Look::Bar, Look::Body, Look::Masses][..],
            false => &[Look::Bar, Look::Body],
        };
        body.look = source.choose(looks);
    }
    if source.chance(0.7) {
        let corners = std::mem::take(&mut scene.corners);
        scene.grounds.extend(corners);
    }
    scene
}

fn change_references(mut scene: Scene, seed: u64) -> Scene {
    let mut source = Source::new(seed);
    for k in 0..scene.bodies.len() {
        scene.bodies[k].reference = match k > 0 && source.chance(0.4) {
            true => Reference::Body(source.below(k)),
            false => Reference::Quarters(source.below(4) as i32 - 1),
        };
    }
    scene
}

fn put_beside(scene: &Scene, seed: u64) -> Scene {
    let other = turn_scene(&draw_other(scene, seed), 0.0, [8.0, 0.0]);
    join(scene, rename(&other, |name| format!("{name}z"), scene.bodies.len()))
}

/// What [`Change::Beside`] puts beside a scene: a copy of it, or another one.
pub fn draw_other(scene: &Scene, seed: u64) -> Scene {
    let mut source = Source::new(seed);
    let other = if source.chance(0.4) { scene.clone() } else { draw::draw(&mut source) };
    Scene { limit: scene.limit, gravity: scene.gravity, ..other }
}
