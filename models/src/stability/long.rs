//! Long runs: an error per period that has one sign adds up to a drift.

use super::reference::reference;
use crate::models;
use liftoff::{Observer, Step};
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError, stopped};
use liftoff_verification::cases::{Case, Effort, at_most, expect};
use std::f64::consts::FRAC_PI_2;

pub(super) fn cases(_: MethodId, effort: Effort) -> Vec<Case> {
    let (single, double) = if effort == Effort::Full { (1e5, 1e3) } else { (2e3, 1e2) };
    vec![pendulum(single), double_pendulum(double)]
}

/// A bar of amplitude 90° swings as a pendulum of two thirds of its length.
fn period() -> f64 {
    reference("pendulum.period[90]") * (2.0_f64 / 3.0).sqrt()
}

/// The greatest departure of an energy from its first value, over the ends of all steps.
struct Drift {
    energy: fn(&[f64]) -> f64,
    first: Option<f64>,
    most: f64,
}

impl Drift {
    fn new(energy: fn(&[f64]) -> f64) -> Self {
        Self { energy, first: None, most: 0.0 }
    }
}

impl Observer for Drift {
    fn step(&mut self, step: &dyn Step) {
        let [t0, t1] = step.times();
        let first = *self.first.get_or_insert_with(|| (self.energy)(&step.state(t0)));
        self.most = self.most.max(((self.energy)(&step.state(t1)) - first).abs());
    }
}

/// The drift of the energy and the state at the end of so many periods.
fn swing(
    name: &str,
    start: &[(&str, f64)],
    periods: f64,
    energy: fn(&[f64]) -> f64,
    by: MethodId,
) -> Result<(f64, Vec<f64>), MotionError> {
    let unit = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]);
    let spec = unit.start(start).limit(periods * period()).tolerance(1e-13);
    let simulation = models().find(name)?.simulation(&spec)?.method(by);
    let mut drift = Drift::new(energy);
    let run = simulation.observe(&mut drift).map_err(stopped)?;
    Ok((drift.most, run.final_state()))
}

/// E = m l² φ̇²/6 − ½ m g l cos φ, in m g l.
fn energy_of_one(state: &[f64]) -> f64 {
    state[1].powi(2) / 6.0 - 0.5 * state[0].cos()
}

/// E = m l² (⅔ φ̇₁² + ⅙ φ̇₂² + ½ φ̇₁ φ̇₂ cos (φ₁ − φ₂)) − m g l (3/2 cos φ₁ + ½ cos φ₂), in m g l.
fn energy_of_two(state: &[f64]) -> f64 {
    let [a, b, u, v] = [state[0], state[1], state[2], state[3]];
    let kinetic = u * u * 2.0 / 3.0 + v * v / 6.0 + 0.5 * u * v * (a - b).cos();
    kinetic - 1.5 * a.cos() - 0.5 * b.cos()
}

fn pendulum(periods: f64) -> Case {
    let scene = format!("pendulum, amplitude 90°, {periods:e} periods");
    // At the turning point φ̇ = −(3/2) (g/l) times the time by which it is late. The period changes
    // with the energy at most by 4 (l/g)^½ per m g l, so that a drift of 1e-10 makes it late by at
    // most 4e-10 of a unit in each.
    let expectations = vec![
        at_most("drift of E in mgl", 1e-10),
        expect("φ", FRAC_PI_2, 1e-10 + (1e-10 * periods).powi(2)),
        at_most("delay of the last turning point", 4e-10 * periods),
    ];
    Case::numbers("long.pendulum", scene, "elliptic integral", expectations, move |by| {
        let start = [("phi", FRAC_PI_2)];
        let (drift, state) = swing("pendulum", &start, periods, energy_of_one, by)?;
        Ok(vec![drift, state[0], (state[1] / 1.5).abs()])
    })
}

fn double_pendulum(periods: f64) -> Case {
    let scene = format!("double-pendulum from rest at 90°, for {periods:e} periods of one bar");
    let expectations = vec![at_most("drift of E in mgl", 1e-10)];
    Case::numbers("long.double pendulum", scene, "energy", expectations, move |by| {
        let start = [("phi_1", FRAC_PI_2), ("phi_2", FRAC_PI_2)];
        Ok(vec![swing("double-pendulum", &start, periods, energy_of_two, by)?.0])
    })
}
