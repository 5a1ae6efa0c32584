//! The power of all forces that have no potential: that of friction, or where others act dE/dt along the accelerations of the
//! equations, E = T + V.

use crate::integration::legendre::{Series, W, X};
use crate::integration::phase_point::{Numbers, PhasePoint, RunContext};
use crate::integration::phase_run::RecordedPhase;
use crate::scales::slips;

/// The last two of a step's coefficients may be this part of the largest; those that the integral leaves out are as small as the
/// square of it.
const RESOLVED: f64 = 1e-6;
/// What is left out may be this part of the energy: some roundings of it, which the difference makes larger.
const NEGLIGIBLE: f64 = 1e-12;
/// A step over which the power is not so smooth is halved at most so many times.
const DEEPEST: u32 = 10;
/// A step shorter than this, in natural times, is not halved: a method makes such steps towards a singularity, where powers are
/// noise.
const SHORT: f64 = 1e-7;
/// The difference of the energy is taken over this part of the time in which a state moves by itself, of the natural time and of the
/// step, inside of which forces are smooth: an error of its fourth power.
const SPAN: f64 = 1e-3;

/// Work done on a model, or by it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Work {
    /// ∫ P dt.
    pub(crate) done: f64,
    /// ∫ |P| dt about, what went in and out.
    pub(crate) passed: f64,
}

impl Work {
    /// Adds that of a phase from one time to another, between which its motion is smooth.
    pub(crate) fn add(&mut self, context: &RunContext, phase: &RecordedPhase, span: [f64; 2]) {
        self.add_of(context, phase, span, &|point, step| power(context, point, step));
    }

    /// Adds that of a power, which depends on a point of the motion and on the length of the step.
    pub(crate) fn add_of(
        &mut self,
        context: &RunContext,
        phase: &RecordedPhase,
        span: [f64; 2],
        power: &dyn Fn(&PhasePoint, f64) -> f64,
    ) {
        let is_short = span[1] - span[0] < SHORT * context.scales.time;
        self.add_part((context, phase), span, power, if is_short { 0 } else { DEEPEST });
    }

    fn add_part(
        &mut self,
        (context, phase): (&RunContext, &RecordedPhase),
        [t0, t1]: [f64; 2],
        power: &dyn Fn(&PhasePoint, f64) -> f64,
        left: u32,
    ) {
        if t1 <= t0 {
            // Steps towards a singularity may be as short as times are told apart.
            return;
        }
        let (mut point, h) = (phase.at(t0), t1 - t0);
        let powers = X.map(|x| {
            phase.show(t0 + 0.5 * (1.0 + x) * h, &mut point);
            power(&point, h)
        });
        let tail = Series::through(|k| powers[k]).tail();
        let matters = || {
            let work = h * powers.iter().fold(0.0, |most: f64, power| most.max(power.abs()));
            let energy = context.system().energy(point.state());
            let size =
                context.scales.force() * context.scales.length + energy.kinetic + energy.potential.abs();
            tail * work > NEGLIGIBLE * size
        };
        if left > 0 && tail > RESOLVED && matters() {
            let middle = 0.5 * (t0 + t1);
            self.add_part((context, phase), [t0, middle], power, left - 1);
            return self.add_part((context, phase), [middle, t1], power, left - 1);
        }
        for (power, weight) in powers.iter().zip(W) {
            let part = 0.5 * weight * h * power;
            self.done += part;
            self.passed += part.abs();
        }
    }
}

fn power(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    if context.is_worked_on() { change_of_energy(context, point, step) } else { friction(context, point) }
}

/// Σ R J_t u, where J_t u is what rates add to the slip velocity: a surface may move.
fn friction(context: &RunContext, point: &PhasePoint) -> f64 {
    let (system, n) = (context.system(), context.layout().coordinates.len());
    let mut still: Numbers = point.state().into();
    still[n..2 * n].fill(0.0);
    let (reactions, contacts) = (point.reactions(), context.layout().contacts.len());
    let slips = slips(system, point.state()).into_iter().zip(slips(system, &still));
    let forces = reactions[contacts..].iter().zip(slips);
    forces.map(|(force, (moving, still))| force * (moving.velocity - still.velocity)).sum()
}

/// By a difference of order four.
fn change_of_energy(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    let (n, state, a) = (context.layout().coordinates.len(), point.state(), point.accelerations());
    let rate = |i: usize| if i < n { state[n + i] } else { a.get(i - n).copied().unwrap_or(1.0) };
    let unit = |i: usize| context.scales.entry(context.layout(), i).max(state[i].abs());
    let fastest = (0..2 * n).map(|i| rate(i).abs() / unit(i)).fold(f64::MIN_POSITIVE, f64::max);
    let dt = SPAN * (1.0 / fastest).min(context.scales.time).min(step);
    let gain = |dt: f64| {
        let [ahead, behind] = [dt, -dt].map(|dt| {
            let moved: Numbers = (0..state.len()).map(|i| state[i] + dt * rate(i)).collect();
            context.system().energy(&moved)
        });
        ahead.gained_since(&behind) / (2.0 * dt)
    };
    (4.0 * gain(dt) - gain(2.0 * dt)) / 3.0
}
