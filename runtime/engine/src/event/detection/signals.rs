//! What loads and drives follow, over a step. Methods judge a step by values at a few places: a
//! load that acts between them is not seen, and neither is a drive that jumps there. A step is
//! accepted only if each signal f(t, q) is seen:
//!
//! ```text
//! |f − p| ≤ r/10 + δ  between the nodes of its interpolant p,   f ∈ [low − R, high + R] everywhere
//! ```
//!
//! with r = high − low the range of its values there, δ what the tolerance leaves of the largest f
//! and of the natural force, and R the largest of r, δ and a sixteenth of that f. The second is
//! proved by interval bounds over pieces of the step.

use super::SHORTEST;
use super::sample::Scratch;
use super::step::StepView;
use crate::context::RunContext;
use crate::expression::{Condition, Enclosure, Interval, Variable};
use crate::model::Layout;
use crate::numerics::root_isolation::Smooth;
use crate::numerics::zero::SOLVED;

/// Places of the interpolant, and places between them.
const NODES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const BETWEEN: [f64; 4] = [0.125, 0.375, 0.625, 0.875];
/// Of its range a signal may differ from its interpolant by this.
const SHARE: f64 = 0.1;
/// Of the largest value of a signal, what may be hidden between the nodes.
const LEAST: f64 = 1.0 / 16.0;
/// Pieces that are bounded in one step at most.
const MOST_PIECES: usize = 256;
/// A jump is larger by this factor than what the function changes by beside it, a pole than its
/// values farther off.
const JUMP: f64 = 16.0;
/// A slope that changes by this part of it has a kink.
const STEEP: f64 = 1e-3;
/// Lengths on which slopes are compared, in natural times.
const SPAN: f64 = 1e-5;

/// An expression of time and motion that loads or drives follow.
#[derive(Debug, Clone)]
pub(crate) struct Signal {
    text: &'static str,
    /// `f > 0`, whose left side is the expression.
    condition: Condition,
    drives: bool,
    reads: Vec<Variable>,
}

impl Signal {
    /// Those of a model. What the model's own names hide from the words of conditions is not
    /// watched.
    pub(crate) fn all(layout: &'static Layout) -> Vec<Self> {
        let signal = |signal: &crate::model::Signal| {
            let condition = Condition::parse(layout, &format!("{} > 0", signal.expression)).ok()?;
            let reads = condition.reads();
            Some(Self { text: signal.expression, condition, drives: signal.drives, reads })
        };
        layout.signals.iter().filter_map(signal).collect()
    }

    /// What a function of time does at a time, in words, if it is not smooth there.
    fn find_break(&self, context: &RunContext, t: f64) -> Option<Broken> {
        let value = |t: f64| {
            let time = |variable| {
                (variable == Variable::Time)
                    .then_some(Enclosure { value: Interval::exactly(t), slope: Interval::exactly(1.0) })
            };
            let bounds = self.condition.enclosure(&context.model.parameters, &time);
            bounds.map_or(f64::NAN, |bounds| bounds.value.middle())
        };
        let what = find_break(&value, t, context.scales.time)?;
        Some(Broken { t, expression: self.text, what })
    }
}

/// Why a step is not accepted, or a motion not gone on with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Unseen {
    /// A shorter step may see the signal.
    Step,
    /// No step sees it: it is not followed any farther.
    Lost,
    /// A drive is not smooth.
    Drive(Broken),
}

/// Where a drive is not smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Broken {
    /// s
    pub(crate) t: f64,
    /// Its value.
    pub(crate) expression: &'static str,
    /// What it does there.
    pub(crate) what: &'static str,
}

/// The signals of a phase, and what is known of them.
pub(crate) struct Signals<'a> {
    list: &'a [Signal],
    /// The largest size of each so far, or at all.
    largest: Vec<f64>,
    /// Those that no step, however short, was proved to have seen: they are not followed any
    /// farther.
    is_lost: Vec<bool>,
    /// Steps in a row that have not seen one.
    pub(crate) unseen: u32,
    scratch: Scratch,
}

impl<'a> Signals<'a> {
    pub(crate) fn new(layout: &'static Layout, list: &'a [Signal], parameters: &[f64]) -> Self {
        let whole = Enclosure { value: Interval::WHOLE, slope: Interval::WHOLE };
        let largest = list.iter().map(|signal| {
            let bounds = signal.condition.enclosure(parameters, &|_| Some(whole));
            bounds.map(|bounds| bounds.value.size()).filter(|size| size.is_finite()).unwrap_or(0.0)
        });
        Self {
            list,
            largest: largest.collect(),
            is_lost: vec![false; list.len()],
            unseen: 0,
            scratch: Scratch::new(layout),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// What of a step is not seen. One that `is_shortest` is accepted but where a drive breaks.
    pub(crate) fn find_unseen(
        &mut self,
        step: &StepView<'_>,
        tolerance: f64,
        is_shortest: bool,
    ) -> Option<Unseen> {
        (0..self.list.len()).find_map(|k| match self.is_lost[k] {
            true => None,
            false => self.find_unseen_of(k, step, (tolerance, is_shortest)),
        })
    }

    fn find_unseen_of(
        &mut self,
        k: usize,
        step: &StepView<'_>,
        (tolerance, is_shortest): (f64, bool),
    ) -> Option<Unseen> {
        let Signal { condition, drives, reads, .. } = &self.list[k];
        let scratch = &mut self.scratch;
        let leaves = |scratch: &mut Scratch| {
            let smooth = |&variable: &Variable| {
                let smooth = match step.polynomial(variable) {
                    Some(exact) => exact.ok(),
                    None => {
                        Smooth::fit(&mut |theta| step.evaluate_variable(theta, variable, scratch), tolerance)
                            .ok()
                            .flatten()
                    }
                };
                Some((variable, smooth?))
            };
            reads.iter().map(smooth).collect::<Option<Vec<_>>>()
        };
        // What has no polynomial over the step is not followed by the method either.
        let leaves = leaves(scratch)?;
        let bound = |piece: [f64; 2]| step.enclosure(condition, &leaves, piece);
        let value = |theta: f64| bound([theta, theta]).map_or(f64::NAN, |bounds| bounds.value.middle());
        let seen = NODES.map(value);
        let [low, high] = seen
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], f| [low.min(*f), high.max(*f)]);
        self.largest[k] = self.largest[k].max(low.abs().max(high.abs()));
        let scales = &step.context.scales;
        let natural = if *drives { scales.length } else { scales.force() };
        let (range, delta) = (high - low, tolerance * self.largest[k].max(natural));
        let is_polynomial = BETWEEN
            .iter()
            .all(|&theta| (value(theta) - interpolate(&seen, theta)).abs() <= SHARE * range + delta);
        let margin = range.max(LEAST * self.largest[k]).max(delta);
        let allowed = Interval { low: low - margin, high: high + margin };
        let is_bounded = |piece: [f64; 2]| {
            let Some(Enclosure { value: natural, slope }) = bound(piece) else { return true };
            // Of a load that may have a pole nothing is proved.
            if !drives && !natural.size().is_finite() {
                return true;
            }
            let reach = 0.5 * (piece[1] - piece[0]) * slope.size();
            let middle = value(0.5 * (piece[0] + piece[1]));
            let within = |low: f64, high: f64| allowed.low <= low && high <= allowed.high;
            let is_within = within(natural.low, natural.high) || within(middle - reach, middle + reach);
            is_within && (!drives || slope.size().is_finite())
        };
        let open = first_unbounded(&is_bounded);
        if is_polynomial && open.is_none() {
            return None;
        }
        if !is_shortest {
            return Some(Unseen::Step);
        }
        let (signal, context) = (&self.list[k], step.context);
        let at = |theta: f64| step.dense.t0 + theta * step.dense.h;
        let places = open.into_iter().chain([1.0, 0.0]).filter(|_| signal.drives);
        let broken = places.map(at).find_map(|t| signal.find_break(context, t));
        // A drive whose bounds alone are open is smooth.
        self.is_lost[k] = !signal.drives;
        let lost = (!signal.drives || open.is_none()).then_some(Unseen::Lost);
        broken.map(Unseen::Drive).or(lost)
    }

    /// The drive that breaks at a time at which no step can be made.
    pub(crate) fn find_break_near(&self, context: &RunContext, t: f64) -> Option<Broken> {
        self.list.iter().filter(|signal| signal.drives).find_map(|signal| signal.find_break(context, t))
    }
}

/// The polynomial through values at [`NODES`].
fn interpolate(values: &[f64; NODES.len()], theta: f64) -> f64 {
    let basis = |i: usize| -> f64 {
        let others = NODES.iter().enumerate().filter(|(j, _)| *j != i);
        others.map(|(_, node)| (theta - node) / (NODES[i] - node)).product()
    };
    values.iter().enumerate().map(|(i, value)| value * basis(i)).sum()
}

/// Where in a step bounds first prove nothing, however short the piece.
fn first_unbounded(is_bounded: &dyn Fn([f64; 2]) -> bool) -> Option<f64> {
    let (mut waiting, mut left) = (vec![[0.0, 1.0]], MOST_PIECES);
    while let Some(piece @ [start, end]) = waiting.pop() {
        if is_bounded(piece) {
            continue;
        }
        let middle = 0.5 * (start + end);
        let Some(fewer) = left.checked_sub(1).filter(|_| end - start > SHORTEST) else { return Some(middle) };
        left = fewer;
        waiting.extend([[middle, end], [start, middle]]);
    }
    None
}

/// What a function of time has at a time where bounds prove nothing, in words; none where it is
/// smooth.
fn find_break(value: &dyn Fn(f64) -> f64, t: f64, natural: f64) -> Option<&'static str> {
    let d = (SPAN * natural).max(4.0 * SHORTEST * t.abs());
    let [far, left, right, farther] = [t - 2.0 * d, t - d, t + d, t + 2.0 * d].map(value);
    let near = 1e-3 * d;
    let [before, after] = [t - near, t + near].map(value);
    if ![far, left, right, farther, before, after].iter().all(|x| x.is_finite()) {
        return Some("is not finite");
    }
    let size = left.abs().max(right.abs());
    if before.abs().max(after.abs()) > JUMP * size {
        return Some("has a pole");
    }
    let beside = (left - far).abs().max((farther - right).abs());
    if (after - before).abs() > JUMP * beside + SOLVED * size {
        return Some("jumps");
    }
    let slope_change = |d: f64| ((value(t + d) - after) - (before - value(t - d))) / d;
    let [once, twice] = [slope_change(d), slope_change(2.0 * d)].map(f64::abs);
    let steep = ((right - after).abs() + (before - left).abs()) / d;
    (once > 0.75 * twice && once > STEEP * steep).then_some("has a kink")
}
