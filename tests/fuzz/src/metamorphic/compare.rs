//! Whether two forms of a scene have the same motion.

use liftoff::EventKind;

use super::form::{Form, Map};
use super::motion::{Motion, Row, TOLERANCE};
use super::scene::{Scene, Vector, norm, subtract};
use crate::Finding;

/// Motions that agree to this, relative to their sizes, need no second look.
const AT_ONCE: f64 = 1e-7;
/// Where neighbours differ by more than this, motions are not compared any farther.
const CHAOTIC: f64 = 1e-3;
/// By how many times more than neighbours of a motion its forms may differ from it.
const MARGIN: f64 = 100.0;
/// By how much the numbers of a neighbour differ.
const NUDGE: f64 = 1e-10;
/// Times beside an event, relative to it.
const BEFORE: f64 = 1.0 - 1e-6;
const AFTER: f64 = 1.0 + 1e-6;
/// Rows of a comparison.
const ROWS: usize = 24;

/// Sizes of lengths, velocities, forces and times.
struct Sizes {
    length: f64,
    speed: f64,
    force: f64,
    time: f64,
}

impl Sizes {
    fn measure(scene: &Scene, motion: &Motion) -> Self {
        let time = motion.run.end_time();
        let rows: Vec<Row> = (0..=8).map(|k| motion.row(time * f64::from(k) / 8.0, false)).collect();
        let bodies = scene.bodies.iter().map(|body| body.length);
        let far = |row: &Row, k: usize| {
            let moved = |(name, point): (&String, &[Vector; 3])| {
                let start = if k == 0 { scene.points[name].position } else { [0.0; 2] };
                norm(subtract(point[k], start))
            };
            row.points.iter().map(moved).fold(0.0, f64::max)
        };
        let length = bodies.chain(rows.iter().map(|row| far(row, 0))).fold(1e-3, f64::max);
        let speed = rows.iter().map(|row| far(row, 1)).fold(length / time, f64::max);
        let weights =
            scene.bodies.iter().map(|body| body.mass).chain(scene.particles.iter().map(|(_, m)| *m));
        let mass: f64 = weights.sum();
        let reactions = rows.iter().flat_map(|row| row.contacts.iter().map(|contact| contact.normal.abs()));
        let force = reactions.fold(mass * (norm(scene.gravity) + speed * speed / length), f64::max);
        Self { length, speed, force, time }
    }
}

/// Two motions, and how they correspond.
pub struct Pair<'a> {
    pub scene: &'a Scene,
    pub one: &'a Motion,
    pub other: &'a Motion,
    pub map: Map,
    /// When the other one starts.
    pub from: f64,
    /// Whether reactions are unique in both.
    pub is_unique: bool,
    /// Whether they are compared.
    pub with_forces: bool,
}

/// A difference: when, how large relative to its size, and in what.
#[derive(Clone, Debug)]
struct Difference {
    t: f64,
    value: f64,
    what: String,
}

impl Pair<'_> {
    /// The differences of all rows and events, in the order of time.
    fn differences(&self, until: f64) -> Vec<Difference> {
        let sizes = Sizes::measure(self.scene, self.one);
        let mut all = self.differences_of_events(&sizes, until);
        let events: Vec<f64> = self.one.run.events().iter().map(|event| event.t).collect();
        for k in 0..=ROWS {
            let t =
                self.from + (self.one.run.end_time() - self.from) * (k as f64 + 0.37) / (ROWS as f64 + 0.5);
            let is_near = events.iter().any(|event| *event > 0.0 && (event - t).abs() < 1e-4 * sizes.time);
            if t < until && !is_near {
                all.push(self.difference_of_rows(&sizes, t));
            }
        }
        all.sort_by(|a, b| a.t.total_cmp(&b.t));
        all
    }

    fn difference_of_rows(&self, sizes: &Sizes, t: f64) -> Difference {
        let one = self.one.row(t, false);
        let other = self.other.row((t - self.from) * self.map.units[1], false);
        let mut worst = Difference { t, value: 0.0, what: String::new() };
        let mut note = |value: f64, what: &dyn Fn() -> String| {
            if value.is_nan() || value > worst.value {
                worst.value = if value.is_nan() { f64::INFINITY } else { value };
                worst.what = what();
            }
        };
        let [length, time, _] = self.map.units;
        for (name, [position, velocity, _]) in &one.points {
            let Some(other) = other.points.get(name) else { continue };
            let off = norm(subtract(self.map.position(*position), other[0])) / length / sizes.length;
            note(off, &|| format!("position of {name}"));
            let off = norm(subtract(self.map.velocity(*velocity), other[1])) * time / length / sizes.speed;
            note(off, &|| format!("velocity of {name}"));
        }
        let force = self.map.force();
        for contact in one.contacts.iter().filter(|_| self.with_forces) {
            let Some(other) = other.contacts.iter().find(|other| other.name == contact.name) else {
                continue;
            };
            let (name, off) = (&contact.name, (contact.normal - other.normal / force).abs() / sizes.force);
            // Accelerations have the rounding of their solution.
            note(off / 10.0, &|| format!("N({name}): {:e} and {:e}", contact.normal, other.normal / force));
            if let (Some([a, _]), Some([b, _])) = (contact.friction, other.friction) {
                // Its sign is that of the direction in which a line is declared.
                let off = (a.abs() - b.abs() / force).abs() / sizes.force;
                note(off / 10.0, &|| format!("R({name}): {a:e} and {:e}", b / force));
            }
        }
        worst
    }

    fn differences_of_events(&self, sizes: &Sizes, until: f64) -> Vec<Difference> {
        let unit = self.map.units[1];
        let known = |name: &str| {
            let supports = self.scene.supports.iter().map(|support| &support.point);
            supports.chain(self.scene.threads.iter().map(|thread| &thread.name)).any(|own| own == name)
        };
        let events = |motion: &Motion, shift: f64, unit: f64| {
            let all = motion
                .events(self.is_unique)
                .into_iter()
                .map(move |(t, kind, name)| (t / unit + shift, kind, name));
            all.filter(|(t, _, name)| known(name) && *t > self.from + 1e-6 * sizes.time && *t < until)
                .collect::<Vec<_>>()
        };
        let one = events(self.one, 0.0, 1.0);
        let mut other = events(self.other, self.from, unit);
        let mut all = Vec::new();
        for (t, kind, name) in &one {
            let like = |(_, (_, k, n)): &(usize, &(f64, EventKind, String))| k == kind && n == name;
            let found =
                other.iter().enumerate().filter(like).map(|(k, (at, ..))| (k, (at - t).abs() / sizes.time));
            match found.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, off)| *off < CHAOTIC) {
                Some((k, value)) => {
                    other.remove(k);
                    all.push(Difference { t: *t, value, what: format!("time of {kind} {name}") });
                }
                None if self.is_idle(self.one, name, t * BEFORE, sizes)
                    || self.is_idle(self.other, name, (t - self.from) * unit * AFTER, sizes) => {}
                None => all.push(Difference {
                    t: *t,
                    value: f64::INFINITY,
                    what: format!("{kind} {name} in one only"),
                }),
            }
        }
        for (t, kind, name) in other.iter().filter(|(t, ..)| *t < until - CHAOTIC * sizes.time) {
            if self.is_idle(self.other, name, (t - self.from) * unit * BEFORE, sizes)
                || self.is_idle(self.one, name, t * AFTER, sizes)
            {
                continue;
            }
            all.push(Difference {
                t: *t,
                value: f64::INFINITY,
                what: format!("{kind} {name} in the other only"),
            });
        }
        all
    }

    /// Whether a contact touches without a load, before an event or after one that the other motion
    /// has: whether it is closed there is a matter of rounding.
    fn is_idle(&self, motion: &Motion, name: &str, t: f64, sizes: &Sizes) -> bool {
        let unit = if std::ptr::eq(motion, self.one) { 1.0 } else { self.map.force() };
        let row = motion.row(t, false);
        let contact = row.contacts.iter().find(|contact| contact.name == name);
        contact.is_some_and(|contact| {
            contact.normal.abs() < AT_ONCE * sizes.force * unit && contact.gap.abs() < AT_ONCE * sizes.length
        })
    }

    /// Compares them up to where either says that it is undecided.
    ///
    /// # Errors
    /// They differ by more than neighbours do.
    pub fn check(&self, form: &Form) -> Result<&'static str, Finding> {
        let unit = self.map.units[1];
        let undecided = self.one.undecided_from().min(self.other.undecided_from() / unit + self.from);
        let end = self.one.run.end_time();
        let until = (undecided - CHAOTIC * end).min(end * (1.0 - CHAOTIC));
        let all = self.differences(until);
        let Some(first) = all.iter().find(|difference| difference.value > AT_ONCE) else {
            return Ok("the same");
        };
        let neighbours = neighbours(form);
        if neighbours.is_empty() {
            return Ok("not compared: no neighbour");
        }
        let mut known: Vec<Difference> = Vec::new();
        for neighbour in &neighbours {
            let pair = Pair {
                scene: self.scene,
                one: self.one,
                other: neighbour,
                map: Map::default(),
                from: 0.0,
                ..*self
            };
            known.extend(pair.differences(until.min(neighbour.undecided_from())));
        }
        let allowed = |t: f64| {
            let before = known.iter().filter(|own| own.t <= t + 2.0 * CHAOTIC * end);
            AT_ONCE + MARGIN * before.map(|own| own.value).fold(0.0, f64::max)
        };
        for difference in all.iter().filter(|difference| difference.t >= first.t) {
            let allowed = allowed(difference.t);
            if allowed > CHAOTIC {
                return Ok("the same until chaos");
            }
            if difference.value > allowed {
                let Difference { t, value, what } = difference;
                return Err(Finding(format!("t = {t}: {what} differ by {value:e}, allowed {allowed:e}")));
            }
        }
        Ok("the same")
    }
}

/// Motions of the scene by another tolerance, and with other last digits.
fn neighbours(form: &Form) -> Vec<Motion> {
    let mut nudged = form.clone();
    let scene = &mut nudged.scene;
    for (k, body) in scene.bodies.iter_mut().enumerate() {
        let sign = if k % 2 == 0 { 1.0 } else { -0.7 };
        body.mass *= 1.0 + sign * NUDGE;
        body.inertia *= 1.0 + 0.6 * sign * NUDGE;
        body.rate *= 1.0 + NUDGE;
    }
    scene.particles.iter_mut().for_each(|(_, mass)| *mass *= 1.0 - 0.8 * NUDGE);
    scene.gravity = scene.gravity.map(|g| g * (1.0 + 0.9 * NUDGE));
    for support in &mut scene.supports {
        support.restitution *= 1.0 - NUDGE;
        if let Some(pair) = &mut support.friction {
            *pair = pair.map(|mu| mu * (1.0 + 0.8 * NUDGE));
        }
    }
    let others = [
        Motion::run_from(&nudged, TOLERANCE, None),
        Motion::run_from(form, TOLERANCE / 50.0, None),
        Motion::run_from(form, TOLERANCE * 50.0, None),
    ];
    others.into_iter().flatten().collect()
}
