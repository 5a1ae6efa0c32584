//! The power of all forces that have no potential: that of friction, or where others act dE/dt
//! along the accelerations of the equations, E = T + V. Powers are told in joules per natural time:
//! of motions that take 1e±130 s one per second is no number.

use crate::context::{Numbers, RunContext};
use crate::integration::phase_point::PhasePoint;
use crate::model::Energy;
use crate::numerics::legendre::{LegendreSeries, W, X};
use crate::numerics::root_isolation::{NODES, last_coefficients};
use crate::numerics::zero::SOLVED;
use crate::trajectory::RecordedPhase;

/// The last two of a step's coefficients may be this part of the largest; those that the integral
/// leaves out are as small as the square of it.
const RESOLVED: f64 = 1e-6;
/// A step over which the power is not so smooth is halved at most so many times.
const DEEPEST: u32 = 10;
/// Halves whose coefficients are not less than this part of the whole's tell no more than it does.
const NO_BETTER: f64 = 0.25;
/// A step shorter than this, in natural times, is not halved: a method makes such steps towards a
/// singularity, where powers are noise.
const SHORT: f64 = 1e-7;
/// The difference of the energy is taken over this part of the time in which a state moves by
/// itself, of the natural time and of the step, inside of which forces are smooth: an error of its
/// fourth power.
const SPAN: f64 = 1e-3;

/// Weights of Clenshaw's and Curtis's quadrature over 0 ≤ θ ≤ 1 at [`NODES`], the last of which
/// only compares (Clenshaw and Curtis, *A method for numerical integration on an automatic
/// computer*, Numer. Math. 2, 1960).
const AT_NODES: [f64; NODES.len()] = {
    let [ends, one, two, three, middle] = [
        0.007_936_507_936_507_936,
        0.073_109_324_608_009_08,
        0.139_682_539_682_539_69,
        0.180_858_929_360_244_9,
        0.196_825_396_825_396_82,
    ];
    [ends, one, two, three, middle, three, two, one, ends, 0.0]
};

/// Work done on a model, or by it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Work {
    /// ∫ P dt.
    pub(crate) done: f64,
    /// ∫ |P| dt about, what went in and out.
    pub(crate) passed: f64,
    /// The largest of kinetic and potential energy on the way.
    largest: f64,
}

impl Work {
    /// Adds that of a phase from one time to another, between which its motion is smooth.
    pub(crate) fn add(&mut self, context: &RunContext, phase: &RecordedPhase, span: [f64; 2]) {
        self.add_of(context, phase, span, &|point, step| power(context, point, step));
    }

    /// Takes note of the energy on the way: between two turns of a pendulum it may be far larger
    /// than at them.
    pub(crate) fn note(&mut self, energy: &Energy<f64>) {
        self.largest = self.largest.max(energy.kinetic).max(energy.potential.abs());
    }

    /// What a change of energy is relative to, given its parts at the start and now.
    pub(crate) fn size(&self, ends: f64) -> f64 {
        ends.max(self.passed).max(self.largest)
    }

    /// Adds what is known of a step.
    pub(crate) fn add_known(&mut self, work: f64) {
        self.done += work;
        self.passed += work.abs();
    }

    /// Adds that of a step of length h from the powers at [`NODES`]; false if they do not tell it.
    pub(crate) fn add_sampled(&mut self, context: &RunContext, powers: &[f64; NODES.len()], h: f64) -> bool {
        let size = context.scales.force() * context.scales.length;
        let left_out = left_out(powers) * h;
        let tells = left_out <= SOLVED * size;
        if tells {
            let parts = powers.iter().zip(AT_NODES).map(|(power, weight)| weight * h * power);
            parts.for_each(|part| self.add_known(part));
        }
        tells
    }

    /// Adds that of a power, J per natural time, which depends on a point of the motion and on the
    /// length of the step.
    pub(crate) fn add_of(
        &mut self,
        context: &RunContext,
        phase: &RecordedPhase,
        span: [f64; 2],
        power: &dyn Fn(&PhasePoint, f64) -> f64,
    ) {
        let is_short = span[1] - span[0] < SHORT * context.scales.time;
        let run = (context, phase);
        if let Some(part) = Part::new(run, span, power) {
            self.add_part(run, &part, power, if is_short { 0 } else { DEEPEST });
        }
    }

    fn add_part(
        &mut self,
        run: (&RunContext, &RecordedPhase),
        part: &Part,
        power: &dyn Fn(&PhasePoint, f64) -> f64,
        left: u32,
    ) {
        if left == 0 || part.is_resolved {
            return part.powers.iter().zip(W).for_each(|(power, weight)| {
                self.add_known(0.5 * weight * (part.length() / run.0.scales.time) * power);
            });
        }
        let [t0, t1] = part.span;
        let middle = 0.5 * (t0 + t1);
        let halves = [[t0, middle], [middle, t1]].map(|span| Part::new(run, span, power));
        // What no half tells better is rounding, of the energy of a stiff spring say; a kink is in
        // one of them.
        let is_noise =
            halves.iter().flatten().all(|half| !half.is_resolved && half.tail > NO_BETTER * part.tail);
        let left = if is_noise { 0 } else { left - 1 };
        halves.iter().flatten().for_each(|half| self.add_part(run, half, power, left));
    }
}

/// The power over a part of a step.
struct Part {
    span: [f64; 2],
    powers: [f64; X.len()],
    /// The last of its coefficients, relative to the largest.
    tail: f64,
    is_resolved: bool,
}

impl Part {
    /// None of a part without length: steps towards a singularity may be as short as times are told
    /// apart.
    fn new(
        (context, phase): (&RunContext, &RecordedPhase),
        span: [f64; 2],
        power: &dyn Fn(&PhasePoint, f64) -> f64,
    ) -> Option<Self> {
        let [t0, t1] = span;
        let h = t1 - t0;
        if h <= 0.0 {
            return None;
        }
        let mut point = phase.interpolate(t0);
        let powers = X.map(|x| {
            phase.show(t0 + 0.5 * (1.0 + x) * h, &mut point);
            power(&point, h)
        });
        let tail = LegendreSeries::through(|k| powers[k]).tail();
        let matters = || {
            let work =
                h / context.scales.time * powers.iter().fold(0.0, |most: f64, power| most.max(power.abs()));
            let energy = context.system().energy(point.state());
            let size =
                context.scales.force() * context.scales.length + energy.kinetic + energy.potential.abs();
            tail * work > SOLVED * size
        };
        let is_resolved = tail <= RESOLVED || !matters();
        Some(Self { span, powers, tail, is_resolved })
    }

    fn length(&self) -> f64 {
        self.span[1] - self.span[0]
    }
}

/// What a quadrature at [`NODES`] leaves out: the coefficients of Chebyshev's polynomials behind
/// the last two, which shrink as these have from the two before.
fn left_out(powers: &[f64; NODES.len()]) -> f64 {
    let [first, second, third, fourth] = last_coefficients(powers).map(f64::abs);
    let (before, last) = (first.max(second), third.max(fourth));
    if last < before { last * last / before } else { last }
}

fn power(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    if context.is_worked_on() {
        return change_of_energy(context, point, step);
    }
    let (layout, state, reactions) = (context.layout(), point.state(), point.reactions());
    let equations = context.system().equations(state);
    let rates = &state[context.rates()];
    let forces = reactions[layout.contacts.len()..].iter().zip(layout.frictions);
    let along =
        |row: usize| equations.jacobian(row).iter().zip(rates).map(|(entry, u)| entry * u).sum::<f64>();
    forces.map(|(force, friction)| force * (along(friction.row) * context.scales.time)).sum()
}

/// dE/dt in that unit, by a difference of order four.
fn change_of_energy(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    let (state, dt) = (point.state(), difference(context, point, step));
    let rate = |i: usize| rate(context, point, i);
    let gain = |dt: f64| {
        let [ahead, behind] = [dt, -dt].map(|dt| {
            let moved: Numbers = (0..state.len()).map(|i| state[i] + dt * rate(i)).collect();
            context.system().energy(&moved)
        });
        ahead.gained_since(&behind) / (2.0 * dt / context.scales.time)
    };
    (4.0 * gain(dt) - gain(2.0 * dt)) / 3.0
}

/// What the rounding of the energy makes of such differences over a step; nothing where none is
/// taken.
pub(crate) fn blur(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    if !context.is_worked_on() || step == 0.0 {
        return 0.0;
    }
    let energy = context.system().energy(point.state());
    step / difference(context, point, step) * f64::EPSILON * (energy.kinetic + energy.potential.abs())
}

/// The time over which it is taken.
fn difference(context: &RunContext, point: &PhasePoint, step: f64) -> f64 {
    let n = context.layout().coordinates.len();
    let unit = |i: usize| context.scales.entry(context.layout(), i).max(point.state()[i].abs());
    let fastest =
        (0..2 * n).map(|i| rate(context, point, i).abs() / unit(i)).fold(f64::MIN_POSITIVE, f64::max);
    SPAN * (1.0 / fastest).min(context.scales.time).min(step)
}

/// Of an entry of the state.
fn rate(context: &RunContext, point: &PhasePoint, entry: usize) -> f64 {
    let (n, a) = (context.layout().coordinates.len(), point.accelerations());
    let slope = || context.layout().slope(entry) as f64;
    if entry < n { point.state()[n + entry] } else { a.get(entry - n).copied().unwrap_or_else(slope) }
}
