//! A motion followed by the judge alone: series of a step, the first root of any gap, reaction or
//! foot in it, a decision.

mod conditions;
mod guards;
mod instant;
mod settling;
mod step;
mod task;

pub use task::{Action, Change, Event, Motion, NotJudged, Task};

use crate::condition::{Condition, Watch};
use crate::decision::Undecided;
use crate::expansion::{Expansion, State};
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use settling::Rhythm;

/// The number that the judge counts in.
pub(crate) type Number = DoubleDouble;

/// What becomes of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// Its difference may be zero here.
    Fresh,
    /// Its difference is not zero here.
    Known,
    /// It was met.
    Done,
}

/// What a contact does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Touch {
    /// Its gap is open, and has a zero of this order where the step begins.
    Open(usize),
    /// Its gap and the rate of it are zero, and it is not decided yet.
    Resting,
    /// It bears, and its reaction has a zero of this order where the step begins.
    Bearing(usize),
    /// It is closed by others.
    Idle,
    /// Its corner lies beyond the end of its bar.
    Beyond,
    /// It is closed whatever its reaction.
    Held,
    /// It has been taken away.
    Removed,
}

/// A motion being followed.
struct Follower<'a> {
    scene: &'a Scene<Number>,
    state: State<Number>,
    touches: Vec<Touch>,
    rhythm: Rhythm,
    watch: Watch,
    conditions: &'a [Condition],
    sides: Vec<Side>,
    ends_at_impacts: bool,
    ended: bool,
    terms: usize,
    motion: Motion,
    steps: usize,
    most_work: u64,
}

/// Steps of one motion at most.
const STEPS: usize = 20_000;
/// Gaps at a start below this, in natural lengths, and their rates relative to the largest speed,
/// are closed.
const CLOSED: f64 = 1e-11;
/// A start further off its constraints, in natural lengths, is none.
const OFF: f64 = 1e-6;

/// A motion of a scene.
pub(crate) fn follow<'a>(scene: &'a Scene<Number>, task: &Task<'a>) -> Motion {
    let mut follower = match Follower::begin(scene, task) {
        Ok(follower) => follower,
        Err(reason) => return Motion { stopped: Some(reason), ..Motion::default() },
    };
    if let Err(reason) = follower.run(task) {
        follower.motion.stopped = Some(reason);
    }
    follower.motion.end = scene.public(&follower.state);
    follower.motion
}

impl<'a> Follower<'a> {
    fn begin(scene: &'a Scene<Number>, task: &Task<'a>) -> Result<Self, NotJudged> {
        let public: Vec<Number> = task.state.iter().map(|&x| Number::from_f64(x)).collect();
        if public.len() != 2 * scene.readings.len() || public.iter().any(|x| !x.is_finite()) {
            return Err(NotJudged::Empty);
        }
        let (state, off) = scene.placed(Number::from_f64(task.t), &public, &scene.figure);
        if off.is_nan() || off > OFF {
            return Err(NotJudged::Start(off));
        }
        let mut follower = Self {
            scene,
            state,
            touches: Vec::new(),
            rhythm: Rhythm::default(),
            watch: Watch::new(scene, task.conditions)?,
            conditions: task.conditions,
            sides: vec![Side::Fresh; task.conditions.len()],
            ends_at_impacts: task.ends_at_impacts,
            ended: false,
            terms: task.terms,
            motion: Motion::default(),
            steps: 0,
            most_work: task.most_work,
        };
        follower.touches = follower.touching();
        for name in task.held {
            let place = scene.contacts.iter().position(|contact| contact.name == *name);
            follower.touches[place.ok_or_else(|| NotJudged::Name(name.clone()))?] = Touch::Held;
        }
        let closed = follower.find_contacts(|touch| matches!(touch, Touch::Resting | Touch::Held));
        let slots = scene.slots(&closed);
        if !task.kept.is_empty() {
            scene.complete(&mut follower.state, &public, (task.kept, &slots));
        }
        scene.project(&mut follower.state, &slots);
        Ok(follower)
    }

    /// What touches at a start.
    fn touching(&self) -> Vec<Touch> {
        let expansion = Expansion::new(self.scene, &self.state);
        let speed = self.scene.speed(&self.state);
        let touch = |contact: &crate::scene::Contact<Number>| {
            let value = |node| expansion.series.get(node, 0).to_f64();
            let gap = contact.row.value.map_or(0.0, value);
            let beyond = contact.foot.is_some_and(|foot| foot.into_iter().any(|end| value(end) < 0.0));
            let rate = expansion.rate(&contact.row).to_f64();
            if beyond {
                Touch::Beyond
            } else if gap.abs() > CLOSED * self.scene.length {
                Touch::Open(0)
            } else if rate.abs() <= CLOSED * speed {
                Touch::Resting
            } else {
                Touch::Open(1)
            }
        };
        self.scene.contacts.iter().map(touch).collect()
    }

    /// The contacts that do something.
    fn find_contacts(&self, is: impl Fn(Touch) -> bool) -> Vec<usize> {
        (0..self.touches.len()).filter(|&i| is(self.touches[i])).collect()
    }

    fn closed(&self) -> Vec<usize> {
        self.find_contacts(|touch| matches!(touch, Touch::Bearing(_) | Touch::Idle | Touch::Held))
    }

    fn bearing(&self) -> Vec<usize> {
        self.find_contacts(|touch| matches!(touch, Touch::Bearing(_) | Touch::Held))
    }

    fn held(&self) -> Vec<usize> {
        self.find_contacts(|touch| touch == Touch::Held)
    }

    fn t(&self) -> f64 {
        self.state.t.to_f64()
    }

    fn run(&mut self, task: &Task) -> Result<(), NotJudged> {
        self.strike_at_start()?;
        self.decide()?;
        let (mut actions, mut samples) = (task.actions.iter().peekable(), task.samples.iter().peekable());
        loop {
            let now = self.state.t;
            while let Some(&&t) = samples.peek().filter(|t| Number::from_f64(***t) <= now) {
                self.motion.samples.push((t, self.scene.public(&self.state)));
                samples.next();
            }
            while let Some((_, action)) = actions.peek().filter(|(t, _)| Number::from_f64(*t) <= now) {
                self.act(action)?;
                actions.next();
            }
            if self.ended || Number::from_f64(task.until) <= now {
                return Ok(());
            }
            let next = samples.peek().copied().copied().into_iter();
            let next = next.chain(actions.peek().map(|(t, _)| *t)).fold(task.until, f64::min);
            self.steps += 1;
            if self.steps > STEPS || self.motion.work > self.most_work {
                return Err(NotJudged::Work(self.t()));
            }
            self.step(Number::from_f64(next))?;
        }
    }

    /// Counts the work of an expansion to so many terms, by a factor less where it is only
    /// evaluated.
    fn spend(&mut self, terms: usize) {
        self.motion.work += (self.scene.tape.size() * terms * self.terms) as u64;
    }

    fn decided<T>(&self, result: Result<T, Undecided>) -> Result<T, NotJudged> {
        let t = self.t();
        result.map_err(|reason| match reason {
            Undecided::Singular => NotJudged::Singular(t),
            Undecided::Jammed => NotJudged::Jammed(t),
            Undecided::Many => NotJudged::Rough(t),
        })
    }

    /// What is a rate of zero.
    fn still(&self) -> f64 {
        negligible::<Number>() * self.scene.speed(&self.state)
    }

    fn record(&mut self, change: Change, contacts: Vec<usize>) {
        let state = self.scene.public(&self.state);
        let closed = self.closed();
        self.motion.events.push(Event { t: self.state.t, change, contacts, closed, state });
    }
}
