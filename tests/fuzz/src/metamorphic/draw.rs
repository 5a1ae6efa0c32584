//! Random scenes of the whole vocabulary, from seeds.

use std::f64::consts::{FRAC_PI_2, PI};

use liftoff_tests::random::Source;

use super::image;
use super::scene::{
    Body, Couple, Drive, Force, Guide, Look, Place, Reference, Scene, Shape, Slider, Spring, Support, Target,
    Thread, Torsion, Vector, Wave, add, direction, left, norm, scale, subtract,
};

/// A number of few digits.
fn short(source: &mut Source, low: f64, high: f64) -> f64 {
    (source.range(low, high) * 100.0).round() / 100.0
}

/// The scene of a seed.
pub fn draw(source: &mut Source) -> Scene {
    match source.chance(0.15) {
        true => symmetric(source),
        false => Draft::draw(source, false).scene,
    }
}

/// A half on the right of the line x = 0, its image, and what joins them.
fn symmetric(source: &mut Source) -> Scene {
    loop {
        let half = Draft::draw(source, true).scene;
        let root = half.bodies.first().map(|body| body.ends[0].clone());
        let on_line = |name: &String| root.as_ref() == Some(name) && half.points[name].position[0] == 0.0;
        if half.points.iter().all(|(name, place)| place.position[0] > 0.02 || on_line(name)) {
            let mut scene = image::add_image(&half);
            let free: Vec<String> =
                half.points.keys().filter(|name| !half.is_fixed(name) && !on_line(name)).cloned().collect();
            if source.chance(0.3) && !free.is_empty() {
                let end = source.choose(&free);
                // Its ends may meet: with a length of its own its force would turn round there.
                let length = 0.0;
                let name = "between".to_owned();
                let image = format!("{end}m");
                let stiffness = short(source, 5.0, 60.0);
                scene.springs.push(Spring { name, ends: [end, image], stiffness, length, damping: 0.0 });
            }
            return scene;
        }
    }
}

/// A scene in the making.
struct Draft<'a> {
    source: &'a mut Source,
    scene: Scene,
    is_half: bool,
    is_loop: bool,
}

impl<'a> Draft<'a> {
    fn draw(source: &'a mut Source, is_half: bool) -> Self {
        // Few have equations of their own, since to derive them takes longer than to run them.
        let sets = source.choose(&[2, 2, 2, 64]);
        let scene = Scene { limit: short(source, 0.6, 2.5), sets, ..Scene::default() };
        let mut draft = Self { source, scene, is_half, is_loop: false };
        draft.gravity();
        let bodies = draft.source.choose(&[1, 1, 1, 2, 2, 2, 3, 3, 4]);
        if !is_half && draft.source.chance(0.12) {
            let position = [short(draft.source, -0.5, 0.5), short(draft.source, 0.0, 1.0)];
            draft.particle(position);
        } else {
            draft.tree(bodies);
        }
        if draft.source.chance(0.3) {
            draft.second_particle();
        }
        draft.joints();
        draft.loads();
        draft.contacts();
        draft.drive();
        draft
    }

    fn gravity(&mut self) {
        let g = self.source.choose(&[9.81, 9.81, 10.0, 3.7, 1.0]);
        self.scene.gravity = match self.source.below(12) {
            0 => [0.0; 2],
            1 if !self.is_half => [short(self.source, -3.0, 3.0), -g],
            _ => [0.0, -g],
        };
    }

    fn point(&mut self, position: Vector, velocity: Vector) -> String {
        let name = format!("P{}", self.scene.points.len());
        self.scene.points.insert(name.clone(), Place { position, velocity });
        name
    }

    fn particle(&mut self, position: Vector) -> String {
        let is_moving = self.source.chance(0.5);
        let velocity = [0; 2].map(|_: i32| if is_moving { short(self.source, -2.0, 2.0) } else { 0.0 });
        let name = self.point(position, velocity);
        self.scene.particles.push((name.clone(), short(self.source, 0.3, 2.5)));
        name
    }

    /// A particle beside the bodies, now and then above one that it may touch.
    fn second_particle(&mut self) {
        let body = self.source.below(self.scene.bodies.len().max(1));
        let aside = [short(self.source, 1.5, 3.0), short(self.source, 0.0, 1.0)];
        let is_above = self.source.chance(0.6);
        let Some(Body { ends, length, angle, .. }) =
            self.scene.bodies.get(body).filter(|_| is_above).cloned()
        else {
            self.particle(aside);
            return;
        };
        let is_left = angle.cos() > 0.0;
        let gap = self.gap();
        let normal = scale(if is_left { 1.0 } else { -1.0 }, left(direction(angle)));
        let foot = scale(length * self.source.range(0.3, 0.7), direction(angle));
        let position = add(add(self.scene.points[&ends[0]].position, foot), scale(gap, normal));
        let point = self.particle(position);
        if gap == 0.0 {
            // At rest on what may move.
            self.stop();
        }
        let support = self.support(point, Shape::Bar { body, is_left });
        self.scene.supports.push(support);
    }

    /// Half of all contacts are closed at the start.
    fn gap(&mut self) -> f64 {
        if self.source.chance(0.45) { 0.0 } else { short(self.source, 0.03, 0.5) }
    }

    fn stop(&mut self) {
        self.scene.bodies.iter_mut().for_each(|body| body.rate = 0.0);
        self.scene.points.values_mut().for_each(|place| place.velocity = [0.0; 2]);
    }

    fn tree(&mut self, count: usize) {
        let is_moving = self.source.chance(0.5);
        let is_pinned = self.source.chance(0.4);
        let x = match self.is_half {
            true if self.source.chance(0.6) => 0.0,
            true => short(self.source, 0.3, 1.0),
            false => short(self.source, -1.0, 1.0),
        };
        let position = [x, short(self.source, -1.0, 1.0)];
        let is_flying = is_moving && !is_pinned;
        let mut velocity = [0; 2].map(|_: i32| if is_flying { short(self.source, -2.0, 2.0) } else { 0.0 });
        if self.is_half && x == 0.0 {
            velocity[0] = 0.0;
        }
        let root = self.point(position, velocity);
        if is_pinned {
            self.scene.pins.push(root.clone());
        }
        for _ in 0..count {
            let known: Vec<String> = self.scene.points.keys().cloned().collect();
            let at = match self.scene.bodies.is_empty() || self.source.chance(0.25) {
                true => root.clone(),
                false => self.source.choose(&known),
            };
            self.body(&at, is_moving);
        }
        let slides = !is_pinned && !is_flying && self.source.chance(0.3) && !self.is_half;
        if slides {
            let guide = match self.source.below(5) {
                0 => Guide::Line { angle: FRAC_PI_2, through: position },
                1 => Guide::Line { angle: short(self.source, -1.0, 1.0), through: position },
                2 => {
                    let radius = short(self.source, 0.5, 2.0);
                    Guide::Circle { centre: subtract(position, [0.0, radius]), radius }
                }
                _ => Guide::Line { angle: 0.0, through: position },
            };
            self.scene.sliders.push(Slider { point: root, guide });
        }
    }

    fn body(&mut self, at: &str, is_moving: bool) {
        let (k, angle) = (self.scene.bodies.len(), self.angle());
        let length = short(self.source, 0.4, 1.6);
        let mass = short(self.source, 0.3, 2.5);
        let is_uniform = self.source.chance(0.65);
        let [mut inertia, mut centre] = [mass * length * length / 12.0, 0.0];
        let mut along = length / 2.0;
        if !is_uniform {
            inertia *= self.source.range(0.3, 1.8);
            along = length * self.source.range(0.2, 0.8);
            centre = if self.source.chance(0.5) { short(self.source, -0.2, 0.2) } else { 0.0 };
        }
        let rate = if is_moving { short(self.source, -3.0, 3.0) } else { 0.0 };
        let start = self.scene.points[at];
        let end = self.point(start.position, start.velocity);
        let mut spots = Vec::new();
        if self.source.chance(0.25) {
            let spot = self.point(start.position, start.velocity);
            let across = if self.source.chance(0.5) { short(self.source, -0.3, 0.3) } else { 0.0 };
            spots.push((spot, [length * self.source.choose(&[0.25, 0.5, 0.75]), across]));
        }
        let look = self.source.choose(&[Look::Bar, Look::Bar, Look::Body]);
        self.scene.bodies.push(Body {
            name: format!("b{k}"),
            mass,
            inertia,
            centre: [along, centre],
            length,
            ends: [at.to_owned(), end],
            spots,
            angle,
            rate,
            look,
            reference: Reference::Quarters(0),
        });
        self.scene.place_body(k, at);
    }

    /// Now and then a multiple of a quarter turn, or the direction of the body before.
    fn angle(&mut self) -> f64 {
        match self.source.below(8) {
            0 => self.source.choose(&[0.0, FRAC_PI_2, -FRAC_PI_2, PI]),
            1 if !self.scene.bodies.is_empty() => -self.scene.bodies[0].angle,
            _ => short(self.source, -3.1, 3.1),
        }
    }

    /// A point that may move.
    fn free_point(&mut self) -> Option<String> {
        let free = self.scene.points.keys().filter(|name| !self.scene.is_fixed(name)).cloned();
        let free: Vec<String> = free.collect();
        (!free.is_empty()).then(|| self.source.choose(&free))
    }

    fn ground(&mut self, position: Vector) -> String {
        let name = self.point(position, [0.0; 2]);
        self.scene.grounds.push(name.clone());
        name
    }

    /// Loops and welds.
    fn joints(&mut self) {
        let count = self.scene.bodies.len();
        if count >= 2 && self.source.chance(0.1) {
            let joined = (1..count).find_map(|k| {
                let first =
                    (0..k).find(|j| self.scene.bodies[*j].local(&self.scene.bodies[k].ends[0]).is_some());
                first.map(|j| [j, k])
            });
            if let Some([j, k]) =
                joined.filter(|[j, k]| self.scene.bodies[*j].rate == self.scene.bodies[*k].rate)
            {
                self.scene.welds.push([j, k]);
            }
        }
        if count >= 3 && self.scene.welds.is_empty() && self.source.chance(0.35) {
            let last = self.scene.bodies[count - 1].ends[1].clone();
            if self.scene.pins.len() == 1 {
                self.stop();
                self.is_loop = true;
                let through = self.scene.points[&last].position;
                let angle = self.source.choose(&[0.0, FRAC_PI_2]);
                // A bar across its guide is in a singular position.
                let is_across = (self.scene.bodies[count - 1].angle - angle).cos().abs() < 0.1;
                if is_across || self.source.chance(0.5) {
                    self.scene.pins.push(last);
                } else {
                    self.scene.sliders.push(Slider { point: last, guide: Guide::Line { angle, through } });
                }
            }
        }
    }

    fn wave(&mut self, size: f64) -> Wave {
        let mean = short(self.source, -size, size);
        if self.source.chance(0.5) {
            return Wave { mean, ..Wave::default() };
        }
        let amplitude = short(self.source, 0.1 * size, size);
        Wave { mean, amplitude, rate: short(self.source, 0.5, 12.0), phase: short(self.source, -1.5, 1.5) }
    }

    fn springs(&mut self) {
        while self.source.chance(0.35) && self.scene.springs.len() < 2 {
            let Some(end) = self.free_point() else { break };
            let at = self.scene.points[&end].position;
            let all: Vec<String> = self.scene.points.keys().cloned().collect();
            let near = |scene: &Scene, other: &str| norm(subtract(scene.points[other].position, at)) < 0.2;
            let mut other = self.source.choose(&all);
            let is_same = |scene: &Scene, other: &str| {
                scene.bodies_at(other).any(|(k, _)| scene.bodies[k].local(&end).is_some())
            };
            if near(&self.scene, &other) || is_same(&self.scene, &other) {
                let offset = self.source.choose(&[[0.0, 1.0], [1.0, 0.5], [0.8, -0.7], [0.0, -0.9]]);
                other = self.ground(add(at, offset));
            }
            let distance = norm(subtract(self.scene.points[&other].position, at));
            let length = distance * self.source.choose(&[1.0, 0.7, 0.9, 1.3]);
            let damping = if self.source.chance(0.4) { short(self.source, 0.05, 2.0) } else { 0.0 };
            let name = format!("spring{}", self.scene.springs.len());
            let stiffness = short(self.source, 3.0, 80.0);
            self.scene.springs.push(Spring { name, ends: [other, end], stiffness, length, damping });
        }
    }

    fn torsion(&mut self) {
        let count = self.scene.bodies.len();
        if count == 0 || !self.source.chance(0.2) {
            return;
        }
        let second = self.source.below(count);
        let first = (second > 0 && self.source.chance(0.6)).then(|| self.source.below(second));
        // The angle a of an image to the ground is π − a, which is another parameter.
        if first.is_none() && self.is_half {
            return;
        }
        let angle = self.scene.measure_angle(first, second) + short(self.source, -0.5, 0.5);
        let damping = if self.source.chance(0.4) { short(self.source, 0.05, 1.0) } else { 0.0 };
        let stiffness = short(self.source, 1.0, 30.0);
        self.scene.torsions.push(Torsion { first, second, stiffness, angle, damping });
    }

    fn loads(&mut self) {
        self.springs();
        let count = self.scene.bodies.len();
        if count > 0
            && self.source.chance(0.12)
            && let Some(point) = self.free_point()
            && self.scene.bodies_at(&point).count() > 0
        {
            self.scene.masses.push((point, short(self.source, 0.1, 1.5)));
        }
        self.torsion();
        if self.source.chance(0.3)
            && let Some(point) = self.free_point()
        {
            let along = direction(short(self.source, -3.0, 3.0));
            let drag = if self.source.chance(0.4) { short(self.source, 0.05, 1.0) } else { 0.0 };
            let wave = self.wave(6.0);
            let until = self.source.chance(0.2).then(|| short(self.source, 0.1, 0.9) * self.scene.limit);
            self.scene.forces.push(Force { name: "load".to_owned(), point, along, wave, drag, until });
        }
        if count > 0 && self.source.chance(0.15) {
            let body = self.source.below(count);
            let from = (body > 0 && self.source.chance(0.5)).then(|| self.source.below(body));
            let wave = self.wave(3.0);
            self.scene.couples.push(Couple { name: "motor".to_owned(), body, from, wave });
        }
    }

    fn support(&mut self, point: String, shape: Shape) -> Support {
        let friction = self.source.chance(0.4).then(|| {
            let kinetic = short(self.source, 0.05, 0.8);
            [kinetic, kinetic * self.source.choose(&[1.0, 1.0, 1.25])]
        });
        let restitution =
            if self.source.chance(0.45) { self.source.choose(&[0.3, 0.5, 0.8, 1.0]) } else { 0.0 };
        let is_rough = friction.is_none() && self.source.chance(0.1);
        let is_line = matches!(shape, Shape::Line { .. });
        let is_belt = is_line && friction.is_some() && !self.is_half && self.source.chance(0.15);
        let moving = if is_belt { self.wave(1.0) } else { Wave::default() };
        let is_poisson = self.source.chance(0.2);
        Support { point, shape, friction, restitution, is_poisson, is_rough, moving, radius: 0.0 }
    }

    fn contacts(&mut self) {
        match self.source.below(6) {
            0 | 1 => self.floor(),
            2 | 3 => self.single(),
            4 => self.thread(),
            _ => {}
        }
        if self.source.chance(0.35) {
            self.single();
        }
        if self.source.chance(0.12) {
            self.thread();
        }
        if self.source.chance(0.12) {
            self.corner();
        }
    }

    /// One floor under all points that may move.
    fn floor(&mut self) {
        let free: Vec<String> =
            self.scene.points.keys().filter(|name| !self.scene.is_fixed(name)).cloned().collect();
        let height = |name: &String| self.scene.points[name].position[1];
        let lowest = free.iter().map(height).fold(f64::INFINITY, f64::min);
        let gap = self.gap();
        if gap == 0.0 {
            self.stop();
        }
        let model = self.support(String::new(), Shape::Line { angle: 0.0, through: [0.0, lowest - gap] });
        for point in free.into_iter().take(4) {
            if !self.has_support(&point) && !self.is_guided(&point) {
                self.scene.supports.push(Support { point, ..model.clone() });
            }
        }
    }

    fn has_support(&self, point: &str) -> bool {
        self.scene.supports.iter().any(|support| support.point == point)
    }

    fn is_guided(&self, point: &str) -> bool {
        self.scene.sliders.iter().any(|slider| slider.point == point)
    }

    /// One point at a line or a circle.
    fn single(&mut self) {
        let Some(point) = self.free_point() else { return };
        if self.has_support(&point) || self.is_guided(&point) {
            return;
        }
        let at = self.scene.points[&point].position;
        let gap = self.gap();
        if gap == 0.0 && self.source.chance(0.8) {
            self.stop();
        }
        let angle = match self.source.below(6) {
            0..3 => 0.0,
            3 => short(self.source, -0.7, 0.7),
            4 => FRAC_PI_2,
            _ => -FRAC_PI_2,
        };
        let normal = left(direction(angle));
        let radius = short(self.source, 0.4, 2.0);
        let shape = match self.source.below(5) {
            0 => Shape::Circle { centre: subtract(at, scale(radius + gap, normal)), radius, inside: false },
            1 if gap < radius => {
                Shape::Circle { centre: add(at, scale(radius - gap, normal)), radius, inside: true }
            }
            _ => Shape::Line { angle, through: subtract(at, scale(gap, normal)) },
        };
        let mut support = self.support(point, shape);
        self.disc(&mut support);
        self.scene.supports.push(support);
    }

    /// Now and then a point on a line is the middle of a disc.
    fn disc(&mut self, support: &mut Support) {
        let Support { point, shape: Shape::Line { angle, through }, radius, .. } = support else { return };
        let threads = self.scene.threads.iter();
        let is_tied = threads.flat_map(|thread| &thread.path).any(|name| name == point);
        if !is_tied && self.scene.bodies_at(point).count() < 2 && self.source.chance(0.3) {
            *radius = short(self.source, 0.05, 0.4);
            *through = subtract(*through, scale(*radius, left(direction(*angle))));
        }
    }

    fn corner(&mut self) {
        let Some(body) = self.scene.bodies.len().checked_sub(1) else { return };
        let Body { ends, length, angle, .. } = self.scene.bodies[body].clone();
        if angle.cos().abs() < 0.3 {
            return;
        }
        let gap = self.gap();
        if gap == 0.0 {
            self.stop();
        }
        let is_left = angle.cos() < 0.0;
        let normal = scale(if is_left { 1.0 } else { -1.0 }, left(direction(angle)));
        let foot = scale(length * self.source.range(0.25, 0.75), direction(angle));
        let at = add(add(self.scene.points[&ends[0]].position, foot), scale(gap, normal));
        let point = self.point(at, [0.0; 2]);
        self.scene.corners.push(point.clone());
        let support = self.support(point, Shape::Bar { body, is_left });
        self.scene.supports.push(support);
    }

    fn thread(&mut self) {
        let Some(end) = self.free_point() else { return };
        if self.scene.supports.iter().any(|support| support.point == end && support.radius != 0.0) {
            return;
        }
        let at = self.scene.points[&end].position;
        let offset = self.source.choose(&[[0.3, 1.0], [0.0, 0.8], [-0.7, 0.6], [0.9, 0.1]]);
        let slack = self.gap();
        if slack == 0.0 {
            self.stop();
        }
        let peg = self.ground(add(at, offset));
        let mut path = vec![peg, end];
        let mut length = norm(offset);
        if self.source.chance(0.3) {
            let further = self.ground(add(add(at, offset), [0.6, -0.3]));
            path.insert(0, further);
            length += norm([0.6, -0.3]);
        }
        let restitution = if self.source.chance(0.4) { 0.5 } else { 0.0 };
        let name = format!("thread{}", self.scene.threads.len());
        self.scene.threads.push(Thread { name, path, length: length + slack, restitution });
    }

    /// It begins to move from rest: mean + a sin(w t − π/2).
    fn drive(&mut self) {
        let is_free = self.scene.bodies.iter().all(|body| body.rate == 0.0) && !self.is_loop;
        if self.is_half || self.scene.bodies.is_empty() || !is_free || !self.source.chance(0.25) {
            return;
        }
        self.stop();
        let count = self.scene.bodies.len();
        let target = match self.source.below(3) {
            0 if count > 1 => Target::Between(0, 1),
            1 => {
                let Some(end) = self.free_point() else { return };
                let at = self.scene.points[&end].position;
                let ground = self.ground(add(at, [0.4, 0.9]));
                Target::Distance([ground, end])
            }
            _ => Target::Angle(0),
        };
        let value = self.scene.measure_target(&target);
        let amplitude = short(self.source, 0.05, 0.3);
        let wave = Wave {
            mean: value + amplitude,
            amplitude,
            rate: short(self.source, 1.0, 8.0),
            phase: -FRAC_PI_2,
        };
        self.scene.drives.push(Drive { target, wave });
    }
}
