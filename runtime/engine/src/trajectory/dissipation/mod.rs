//! The energy that a motion has lost since it began, to friction, to dampers and in impacts:
//!
//! ```text
//! D = ∫ (Σ −R v + Σ c ḋ²) dt + Σ (T⁻ − T⁺ + W)
//! ```
//!
//! with W the work of applied impulses and moving surfaces at an impact, so that T + V + D changes
//! by the work of loads, drives and moving surfaces alone. The integral is taken over each recorded
//! step by Gauss's rule of eight points, halved until what it leaves out is below 1e-12 of the
//! energy; beside that it has the error of the motion.

mod jump;
mod power;

use super::Trajectory;
use crate::trajectory::{RecordedPhase, Work};
use power::Losses;

/// D at the start of each step of each phase.
pub(super) struct Dissipation {
    losses: Losses,
    before: Vec<Vec<f64>>,
}

impl Dissipation {
    pub(super) fn compute(record: &Trajectory) -> Self {
        let losses = Losses::from_model(&record.context.model);
        let (mut sum, mut before) = (0.0, Vec::new());
        for (k, phase) in record.phases.iter().enumerate() {
            let mut starts = Vec::new();
            let times: Vec<f64> = phase.times().collect();
            for step in times.windows(2) {
                starts.push(sum);
                sum += losses.within(record, phase, [step[0], step[1]]);
            }
            if starts.is_empty() {
                starts.push(sum);
            }
            before.push(starts);
            sum += record.phases.get(k + 1).map_or(0.0, |next| jump::loss(record, [phase, next]));
        }
        Self { losses, before }
    }

    /// D at a time of a phase.
    pub(super) fn evaluate(&self, record: &Trajectory, k: usize, t: f64) -> f64 {
        let phase = &record.phases[k];
        let t = t.clamp(phase.t0, phase.t1);
        let step = phase.steps.partition_point(|step| step.t0 <= t).saturating_sub(1);
        let start = phase.steps.get(step).map_or(phase.t0, |step| step.t0);
        let before = self.before[k].get(step).copied().unwrap_or(f64::NAN);
        if t > start { before + self.losses.within(record, phase, [start, t]) } else { before }
    }
}

impl Losses {
    /// What is lost within a step of a phase.
    fn within(&self, record: &Trajectory, phase: &RecordedPhase, span: [f64; 2]) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let mut work = Work::default();
        let time = record.context.scales.time;
        work.add_of(&record.context, phase, span, &|point, _| self.power(&record.context, point) * time);
        work.done
    }
}
