//! Contacts: closed or open, their reactions, and the impulses of impacts.

use super::stage::Stage;
use super::track::{carried, line, mean, path, steps, write_point};
use crate::plot::Colour;
use crate::plot::svg::plane::{Px, along, head, left_of, length, towards, unit};
use crate::plot::svg::{Fill, Pen};
use crate::registry::{Configuration, MotionError};
use liftoff::Trajectory;
use liftoff_core::model::geometry::Push;
use liftoff_core::model::{Contact, ContactKind};

/// The longest arrow, and the shortest that is seen.
const LONGEST: f64 = 62.0;
const LEAST: f64 = 1.5;

const REACTION: Pen = Pen::new(Colour::Vermilion, 2.4);
const IMPULSE: Pen = Pen::new(Colour::Purple, 3.6);

/// Seconds for which an impulse is seen, and how many of them at most.
const FLASH: f64 = 0.45;
const FLASHES: usize = 40;

/// The reactions at all frames.
pub(super) struct Contacts {
    /// For each contact the normal and the tangential reaction at each frame; zero while it is
    /// open.
    reactions: Vec<Vec<[f64; 2]>>,
    /// What the longest arrow shows.
    largest: f64,
}

impl Contacts {
    /// Of a record at the frames of a stage.
    pub fn from_run(record: &Trajectory, stage: &Stage) -> Result<Self, MotionError> {
        let mut reactions = Vec::new();
        for (i, contact) in record.layout().contacts.iter().enumerate() {
            let normal = record.function(&format!("N({})", contact.label))?;
            let tangent = contact
                .has_friction_force()
                .then(|| record.function(&format!("R({})", contact.label)))
                .transpose()?;
            let at = |&t: &f64| match is_closed(record, i, t) {
                true => [normal(t), tangent.as_ref().map_or(0.0, |tangent| tangent(t))]
                    .map(|value| if value.is_finite() { value } else { 0.0 }),
                false => [0.0; 2],
            };
            reactions.push(stage.timeline.times.iter().map(at).collect());
        }
        let largest = quantile(reactions.iter().flatten().map(|&force: &[f64; 2]| length(force)).collect());
        Ok(Self { reactions, largest })
    }

    /// Whether a support or thread is closed, from each part of the period on.
    pub fn closed(&self, stage: &Stage, record: &Trajectory, name: &str) -> Vec<(f64, bool)> {
        let contacts = record.layout().contacts;
        let contact = contacts.iter().position(|contact| contact.supports.contains(&name));
        let key = |t: f64| stage.timeline.key(t);
        let lasting = record.segments().into_iter().filter(|segment| segment.t1 > segment.t0);
        let is = |set: &liftoff_core::model::ContactSet| contact.is_some_and(|i| set.iter().any(|j| i == j));
        let mut all: Vec<_> = lasting.map(|segment| (key(segment.t0), is(&segment.set))).collect();
        if let Some(first) = all.first_mut() {
            first.0 = 0.0;
        }
        all
    }

    /// Dots that are rings where a contact is open, and arrows.
    pub fn drawn(&self, stage: &Stage, record: &Trajectory) -> String {
        let mut text = String::new();
        for (i, contact) in record.layout().contacts.iter().enumerate() {
            text += &self.arrows(stage, i, contact);
            if contact.kind != ContactKind::Thread {
                text += &self.marks(stage, record, contact);
            }
        }
        text + &flashes(stage, record)
    }

    fn marks(&self, stage: &Stage, record: &Trajectory, contact: &Contact) -> String {
        let mark = |push: &Push| {
            let places: Vec<_> =
                stage.frames.iter().map(|frame| write_point(stage.px(frame.touched(push)))).collect();
            let closed = self.closed(stage, record, push.support);
            let full: Vec<_> =
                closed.iter().map(|&(key, closed)| (key, if closed { "1" } else { "0" })).collect();
            let first = full.first().map_or("0", |first| first.1);
            let dot = format!(
                "<circle r=\"6\"{}{} fill-opacity=\"{first}\">{}</circle>",
                Pen::new(Colour::Vermilion, 1.6),
                Fill::Colour(Colour::Vermilion),
                steps(&stage.timeline, "fill-opacity", &full),
            );
            carried(&stage.timeline, &places, &dot)
        };
        pushes(&stage.frames[0], contact).map(mark).collect()
    }

    fn arrows(&self, stage: &Stage, i: usize, contact: &Contact) -> String {
        let values = &self.reactions[i];
        if values.iter().all(|&force| LONGEST * length(force) < LEAST * self.largest) {
            return String::new();
        }
        let all: Vec<Vec<[Px; 2]>> = stage
            .frames
            .iter()
            .zip(values)
            .map(|(frame, &force)| forces(stage, frame, contact, force))
            .collect();
        let arrow = |k: usize| {
            let forms: Vec<_> = all.iter().map(|forces| self.arrow(forces[k])).collect();
            let style = format!("{REACTION}{}", Fill::Colour(Colour::Vermilion));
            path(&stage.timeline, &style, &forms, "")
        };
        (0..all[0].len()).map(arrow).collect()
    }

    /// An arrow from where a force acts: a shaft, and a head that is filled.
    fn arrow(&self, [at, force]: [Px; 2]) -> String {
        arrow(at, force.map(|x| LONGEST * x / self.largest))
    }
}

/// Of forces at the contact's places, in pixels: where each acts, and what it is; of one at their
/// middle where only the total is known.
fn forces(stage: &Stage, frame: &Configuration, contact: &Contact, [n, r]: [f64; 2]) -> Vec<[Px; 2]> {
    let one = |push: &Push| {
        let normal = towards(frame.normal(push));
        let tangent = left_of(normal).map(|x| f64::from(push.slip) * x);
        (stage.px(frame.touched(push)), normal, tangent)
    };
    let places: Vec<_> = pushes(frame, contact).map(one).collect();
    if contact.shared {
        let share = 1.0 / contact.supports.len() as f64;
        let force = |normal: Px, tangent: Px| along(normal.map(|x| share * n * x), tangent, share * r);
        return places.iter().map(|&(at, normal, tangent)| [at, force(normal, tangent)]).collect();
    }
    if places.is_empty() {
        return Vec::new();
    }
    let [at, normal] = [
        mean(&places.iter().map(|p| p.0).collect::<Vec<_>>()),
        mean(&places.iter().map(|p| p.1).collect::<Vec<_>>()),
    ];
    vec![[at, unit(normal).map(|x| n * x)]]
}

fn arrow(at: Px, force: Px) -> String {
    let long = length(force).min(1.4 * LONGEST);
    if long < LEAST {
        return line(&[at, at]) + &line(&[at, at, at]) + "Z";
    }
    let tip = along(at, unit(force), long);
    let [_, a, b] = head(tip, force);
    line(&[at, along(tip, unit(force), -long.min(6.0))]) + &line(&[a, tip, b]) + "Z"
}

/// Impulses of impacts, each for a moment.
fn flashes(stage: &Stage, record: &Trajectory) -> String {
    let layout = record.layout();
    let impulses =
        || record.events().iter().flat_map(|event| event.impulses.iter().map(move |of| (event.t, of)));
    let largest = quantile(impulses().map(|(_, of)| of.value.abs()).collect());
    let seen = impulses().filter(|(_, of)| LONGEST * of.value.abs() > 4.0 * largest * LEAST).take(FLASHES);
    let flash = |(t, of): (f64, &liftoff::Reaction)| {
        let contact = &layout.contacts[of.contact];
        let frame = &stage.frames[stage.timeline.frame(t)];
        let total = if contact.shared { of.value * contact.supports.len() as f64 } else { of.value };
        let all = forces(stage, frame, contact, [total, 0.0]);
        let struck = pushes(frame, contact).position(|push| push.support == of.label);
        let chosen = match struck.filter(|_| contact.shared) {
            Some(k) => &all[k..=k],
            None => &all[..],
        };
        chosen
            .iter()
            .map(|&[at, force]| spark(stage, t, at, force.map(|x| LONGEST * x / largest)))
            .collect::<String>()
    };
    seen.map(flash).collect()
}

fn spark(stage: &Stage, t: f64, at: Px, force: Px) -> String {
    let timeline = &stage.timeline;
    let from = timeline.key(t);
    let to = (from + FLASH / timeline.period()).min(1.0);
    let seen = steps(timeline, "opacity", &[(0.0, "0"), (from, "1"), (to, "0")]);
    let style = format!("{IMPULSE}{} opacity=\"0\"", Fill::Colour(Colour::Purple));
    path(timeline, &style, &[arrow(at, force)], &seen)
}

pub(super) fn pushes<'a>(
    frame: &Configuration,
    contact: &'a Contact,
) -> impl Iterator<Item = &'static Push> + use<'a> {
    let all = frame.geometry().pushes;
    contact.supports.iter().flat_map(move |name| all.iter().filter(move |push| push.support == *name))
}

/// Whether a contact is closed at a time; at an event, after it.
pub(super) fn is_closed(record: &Trajectory, contact: usize, t: f64) -> bool {
    let lasting: Vec<_> = record.segments().into_iter().filter(|segment| segment.t1 > segment.t0).collect();
    let at = lasting.iter().rfind(|segment| segment.t0 <= t);
    at.is_some_and(|segment| segment.set.iter().any(|i| i == contact))
}

/// Nearly the largest of sizes, so that a pole does not count.
fn quantile(mut sizes: Vec<f64>) -> f64 {
    sizes.retain(|&size| size > 0.0 && size.is_finite());
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len().saturating_sub(1) * 49 / 50).copied().unwrap_or(1.0)
}
