//! What must hold of any finished motion, from the declaration alone: its states are on the
//! constraints, positions have no jumps, no gap is negative, closed ones stay closed and push, and
//! energy is not gained.

use crate::decision;
use crate::expansion::{Expansion, State};
use crate::motion::Number;
use crate::record::{MotionSegment, Record, Verdict};
use crate::scene::Scene;
use liftoff_core::scalar::{Real, Scalar};

type Scenery = Scene<Number>;

/// What is seen of a state.
struct Seen {
    t: f64,
    state: State<Number>,
    energy: f64,
}

/// The first thing that cannot be, or by how much all that must be zero is not.
pub(crate) fn audit(scene: &Scenery, record: &Record) -> Verdict {
    let mut auditor = Auditor { scene, record, last: None, kinetic: 0.0, worst: 0.0 };
    for stretch in &record.segments {
        if let Err((t, what)) = auditor.stretch(stretch) {
            return Verdict::Disagrees { t, what };
        }
    }
    if auditor.last.is_none() {
        return Verdict::NotJudged { why: "there is no motion".to_owned() };
    }
    Verdict::Agrees { error: auditor.worst }
}

struct Auditor<'a> {
    scene: &'a Scenery,
    record: &'a Record,
    last: Option<Seen>,
    /// The largest kinetic energy so far.
    kinetic: f64,
    worst: f64,
}

type Finding = (f64, String);

impl Auditor<'_> {
    fn stretch(&mut self, stretch: &MotionSegment) -> Result<(), Finding> {
        let closed: Vec<usize> = self.places(&stretch.closed);
        for (k, (t, public)) in stretch.samples.iter().enumerate() {
            let seen = self.seen(*t, public)?;
            self.gaps(&seen, &closed)?;
            if let Some(last) = self.last.take() {
                if k == 0 {
                    self.continuous(&last, &seen)?;
                }
                self.energy(&last, &seen)?;
            }
            // At the ends reactions may be zero.
            if k > 0 && k + 1 < stretch.samples.len() {
                self.reactions(&seen, &closed)?;
            }
            self.last = Some(seen);
        }
        Ok(())
    }

    fn places(&self, names: &[String]) -> Vec<usize> {
        let place = |name: &String| self.scene.contacts.iter().position(|contact| contact.name == *name);
        names.iter().filter_map(place).collect()
    }

    fn measure(&mut self, t: f64, value: f64, what: impl FnOnce() -> String) -> Result<(), Finding> {
        // Written so that what is not a number is found.
        if value <= self.record.within {
            self.worst = self.worst.max(value);
            return Ok(());
        }
        Err((t, what()))
    }

    fn seen(&mut self, t: f64, public: &[f64]) -> Result<Seen, Finding> {
        let public: Vec<Number> = public.iter().map(|&x| Number::from_f64(x)).collect();
        let guess = self.last.as_ref().map_or(&self.scene.figure, |last| &last.state.q);
        let (state, off) = self.scene.placed(Number::from_f64(t), &public, guess);
        self.measure(t, off, || format!("the constraints are off by {off:.1e}"))?;
        let [kinetic, potential] = self.scene.energy(&state).map(Scalar::to_f64);
        self.kinetic = self.kinetic.max(kinetic);
        Ok(Seen { t, state, energy: kinetic + potential })
    }

    fn gaps(&mut self, seen: &Seen, closed: &[usize]) -> Result<(), Finding> {
        let (scene, length) = (self.scene, self.scene.length);
        let expansion = Expansion::new(scene, &seen.state);
        let value = |node| expansion.series.get(node, 0).to_f64();
        let speed = scene.speed(&seen.state).max(length / self.record.time);
        for (i, contact) in scene.contacts.iter().enumerate() {
            let Some(gap) = contact.row.value.map(value) else { continue };
            let beyond = contact.foot.is_some_and(|foot| foot.into_iter().any(|end| value(end) < 0.0));
            let name = &contact.name;
            if closed.contains(&i) {
                self.measure(seen.t, gap.abs() / length, || {
                    format!("{name} is closed at a gap of {gap:.1e}")
                })?;
                let rate = expansion.rate(&contact.row).to_f64();
                self.measure(seen.t, rate.abs() / speed, || format!("{name} is closed but its gap grows"))?;
            } else if !beyond && !self.removed(name, seen.t) {
                self.measure(seen.t, -gap / length, || format!("the gap of {name} is {gap:.1e}"))?;
            }
        }
        Ok(())
    }

    /// Whether a contact has been taken away by then.
    fn removed(&self, name: &str, t: f64) -> bool {
        self.record.actions.iter().any(|(at, action)| match action {
            crate::motion::Action::Remove(names) => *at <= t && names.iter().any(|other| other == name),
            crate::motion::Action::Impulse { .. } => false,
        })
    }

    /// Positions are the same on both sides of an event.
    fn continuous(&mut self, last: &Seen, seen: &Seen) -> Result<(), Finding> {
        let weights = self.scene.angles.iter().map(|&angle| if angle { 1.0 } else { self.scene.length });
        let pairs = last.state.q.iter().zip(&seen.state.q).zip(weights);
        let apart = pairs.map(|((a, b), weight)| (*a - *b).abs().to_f64() / weight).fold(0.0, f64::max);
        let passed = (seen.t - last.t) * self.scene.speed(&last.state) / self.scene.length;
        self.measure(seen.t, (apart - 2.0 * passed).max(0.0), || format!("the position jumps by {apart:.1e}"))
    }

    fn energy(&mut self, last: &Seen, seen: &Seen) -> Result<(), Finding> {
        let pushed = self.record.actions.iter().any(|(t, action)| {
            matches!(action, crate::motion::Action::Impulse { .. }) && (last.t..=seen.t).contains(t)
        });
        if !self.scene.passive || pushed {
            return Ok(());
        }
        let weight: f64 = self
            .scene
            .masses
            .iter()
            .zip(&self.scene.angles)
            .filter(|(_, angle)| !**angle)
            .map(|(m, _)| m.to_f64())
            .sum();
        let natural = weight * (self.scene.length / self.record.time).powi(2);
        let gained = (seen.energy - last.energy) / self.kinetic.max(natural);
        self.measure(seen.t, gained, || format!("energy is gained: {gained:.1e} of its natural size"))
    }

    /// The closed contacts stay closed by the judge's own complementarity.
    fn reactions(&mut self, seen: &Seen, closed: &[usize]) -> Result<(), Finding> {
        let (scene, mut state) = (self.scene, seen.state.clone());
        let held = self.places(&self.record.held);
        let closed: Vec<usize> = closed.iter().copied().filter(|i| !held.contains(i)).collect();
        let all: Vec<usize> = held.iter().chain(&closed).copied().collect();
        scene.project(&mut state, &scene.slots(&all));
        let Ok(decision) = decision::decide(scene, &state, (&held, &closed)) else {
            return Err((seen.t, "no contact set is admissible".to_owned()));
        };
        let bearing: Vec<usize> =
            held.iter().copied().chain(decision.bearing.iter().map(|(i, _)| *i)).collect();
        let Some(expansion) = Expansion::solve(scene, &state, &bearing, 1) else { return Ok(()) };
        let a: Vec<Number> = expansion.accelerations(Number::ZERO);
        let natural = scene.length / self.record.time.powi(2);
        for (i, order) in decision.opening {
            let contact = &scene.contacts[i];
            let ((bias, size), (along, other)) =
                (expansion.bias(&contact.row, 0), expansion.along(&contact.row, &a));
            let rises = if order == 2 { (bias + along).to_f64() / (size + other).max(natural) } else { 0.0 };
            self.measure(seen.t, rises, || format!("{} pulls: it must open", contact.name))?;
        }
        Ok(())
    }
}
