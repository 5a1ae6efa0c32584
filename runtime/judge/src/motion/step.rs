//! One step of the series, verified at its end.

use super::guards::Guard;
use super::{Follower, NotJudged, Number, Touch};
use crate::expansion::{Expansion, Kkt, State};
use liftoff_core::scalar::{Real, Scalar};

/// Accelerations at the end of a step, by the series and afresh, differ by less than this.
const VERIFIED: f64 = 1e-17;
/// Such differences below this part of what single forces would make are rounding.
const BALANCED: f64 = 1e-27;
/// Terms that may do where all are too many.
const FEWER: usize = 21;
/// The longest step, in natural times: roots of longer ones are lost.
const FARTHEST: f64 = 1e8;
/// Least pivots below this part of the largest are those of a singular position not far away.
const LOOSENED: f64 = 0.1;
/// Series that reach less than this part of what their first terms promise are noise in the last.
const NOISY: f64 = 0.7;
/// Hops, in such reaches, and the longest of them in promised ones: there fewer terms are enough.
const HOPS: [f64; 4] = [2.2, 3.0, 1.6, 5.0];
const LONGEST: f64 = 1.2;
/// Steps below this, in natural times, pass over what is not analytic.
const LEAST: f64 = 1e-14;
/// Such a step where there is no series: its error is a third power.
const CRAWL: f64 = 1e-10;
/// Steps below this, in natural times, may be leaps of so many terms, so long, verified to this.
const SHORT: f64 = 1e-4;
const FEW: usize = 10;
const LEAP: f64 = 4e-4;
const LOOSE: f64 = 1e-10;

impl Follower<'_> {
    /// A step up to a time at most, with what happens at its end.
    pub(super) fn step(&mut self, until: Number) -> Result<(), NotJudged> {
        let bearing = self.bearing();
        self.spend(self.terms);
        let expansion = Expansion::solve(self.scene, &self.state, &bearing, self.terms);
        let expansion = expansion.ok_or(NotJudged::Singular(self.t()))?;
        let left = until - self.state.t;
        let free = expansion.reach(self.scene.length);
        if free.is_nan() {
            return self.crawl(&expansion, left);
        }
        let free = free.min(left.to_f64()).min(FARTHEST * self.time(&expansion));
        let reach = self.heard(&expansion, free);
        let mut h = if reach < left.to_f64() { Number::from_f64(reach) } else { left };
        if reach == free && self.hop(&expansion, free, left, &bearing)? {
            return Ok(());
        }
        let short = SHORT * self.time(&expansion);
        let mut leapt = false;
        loop {
            self.spend(1);
            if !leapt && h.to_f64() < short && h < left {
                leapt = true;
                if self.leap(&expansion, left, &bearing)? {
                    return Ok(());
                }
            }
            let found = self.roots(&expansion, h);
            let (s, guards) = found.unwrap_or((h, Vec::new()));
            let verified = self.verified(&expansion, s, &bearing);
            let tiny = s.to_f64() < LEAST * self.time(&expansion);
            if let Some(state) = verified.or_else(|| tiny.then(|| expansion.state(s))) {
                let whole = guards.is_empty() && h == left;
                self.state = state;
                if whole {
                    self.state.t = until;
                }
                return self.arrive(&bearing, &guards);
            }
            h = s * Number::ratio(1, 2);
        }
    }

    /// The state after a step, if the equations agree there. Close to a position where constraints
    /// depend on one another terms of high order are noise that fewer terms do without.
    fn verified(&self, expansion: &Expansion<Number>, s: Number, bearing: &[usize]) -> Option<State<Number>> {
        let state = expansion.state(s);
        if self.agrees(expansion, s, &state, bearing, VERIFIED) {
            return Some(state);
        }
        let fewer = expansion.truncated(FEWER);
        let state = fewer.state(s);
        self.agrees(&fewer, s, &state, bearing, VERIFIED).then_some(state)
    }

    /// Over a position where constraints depend on one another, from afar: the motion is smooth
    /// there, while rounding in the terms of high order grows as if the series ended there. Fewer
    /// terms reach beyond.
    fn hop(
        &mut self,
        expansion: &Expansion<Number>,
        reach: f64,
        left: Number,
        bearing: &[usize],
    ) -> Result<bool, NotJudged> {
        let promise = expansion.promise(self.scene.length);
        if expansion.firmness >= LOOSENED || reach >= NOISY * promise {
            return Ok(false);
        }
        let few = expansion.truncated(FEWER);
        for s in HOPS.map(|factor| factor * reach).into_iter().filter(|&s| s <= LONGEST * promise) {
            let s = Number::from_f64(s);
            if s > left || self.roots(&few, s).is_some() {
                continue;
            }
            let state = few.state(s);
            if self.agrees(&few, s, &state, bearing, VERIFIED) {
                self.state = state;
                return self.arrive(bearing, &[]).map(|()| true);
            }
        }
        Ok(false)
    }

    /// Past a position where constraints depend on one another: the terms of high order are noise
    /// there, while few are enough for a short step.
    fn leap(
        &mut self,
        expansion: &Expansion<Number>,
        left: Number,
        bearing: &[usize],
    ) -> Result<bool, NotJudged> {
        let few = expansion.truncated(FEW);
        let longest = Number::from_f64(LEAP * self.time(expansion));
        let s = if longest < left { longest } else { left };
        let state = few.state(s);
        if self.roots(&few, s).is_some() || !self.agrees(&few, s, &state, bearing, LOOSE) {
            return Ok(false);
        }
        self.state = state;
        self.arrive(bearing, &[]).map(|()| true)
    }

    fn arrive(&mut self, bearing: &[usize], guards: &[Guard]) -> Result<(), NotJudged> {
        self.scene.project(&mut self.state, &self.scene.slots(bearing));
        for touch in &mut self.touches {
            match touch {
                Touch::Open(order) | Touch::Bearing(order) => *order = 0,
                _ => {}
            }
        }
        self.hear(guards);
        if guards.is_empty() { self.corners() } else { self.pass(guards) }
    }

    /// Whether the equations agree with the series at the end of a step.
    fn agrees(
        &self,
        expansion: &Expansion<Number>,
        s: Number,
        state: &State<Number>,
        bearing: &[usize],
        within: f64,
    ) -> bool {
        let fresh = Expansion::new(self.scene, state);
        let kkt = Kkt::assemble(self.scene, &fresh.series, self.scene.slots(bearing));
        let response = fresh.next(&kkt, 0);
        let (mut apart, mut size) = (0.0_f64, self.scene.speed(state).powi(2) / self.scene.length);
        let weights = self.scene.angles.iter().map(|&angle| if angle { self.scene.length } else { 1.0 });
        for ((a, b), weight) in response.a.iter().zip(expansion.accelerations(s)).zip(weights) {
            apart = apart.max((*a - b).abs().to_f64() * weight);
            size = size.max(a.abs().to_f64() * weight);
            // What is not a number holds nothing.
            if !a.is_finite() || !b.is_finite() {
                return false;
            }
        }
        // Where forces balance accelerations are rounding of what each of them would make.
        let rounding = BALANCED * fresh.pull(self.scene.length);
        apart <= within * size + rounding && !response.contradicts(0.0)
    }

    /// In which the motion changes, by speeds and accelerations.
    fn time(&self, expansion: &Expansion<Number>) -> f64 {
        let length = self.scene.length;
        let weight = |angle: bool| if angle { length } else { 1.0 };
        let rates = expansion.inputs.rates.iter().zip(&self.scene.angles);
        let (v, a) = rates.fold((0.0_f64, 0.0_f64), |(v, a), (rate, &angle)| {
            let size = |k: usize| rate.get(k).map_or(0.0, |x| x.abs().to_f64()) * weight(angle);
            (v.max(size(0)), a.max(size(1)))
        });
        (length / v).min((length / a).sqrt())
    }

    /// A short step by speeds and accelerations alone.
    fn crawl(&mut self, expansion: &Expansion<Number>, left: Number) -> Result<(), NotJudged> {
        let bearing = self.bearing();
        let time = CRAWL * self.time(expansion);
        if !(time.is_finite() && time > 0.0) {
            return Err(NotJudged::NotFinite(self.t()));
        }
        let s = if time < left.to_f64() { Number::from_f64(time) } else { left };
        let half = s * Number::ratio(1, 2);
        for (i, rate) in expansion.inputs.rates.iter().enumerate() {
            let (v, a) = (rate[0], rate[1]);
            if !a.is_finite() {
                return Err(NotJudged::NotFinite(self.t()));
            }
            self.state.q[i] = self.state.q[i] + s * (v + half * a);
            self.state.v[i] = v + s * a;
        }
        self.state.t = self.state.t + s;
        self.arrive(&bearing, &[])
    }
}
