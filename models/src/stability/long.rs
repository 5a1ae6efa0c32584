//! Long runs: an error per period that has one sign adds up to a drift.

use super::Effort;
use super::answer::{at_most, want};
use super::case::Case;
use super::reference::reference;
use super::story::{drift, last, run};
use crate::scene::Setup;
use std::f64::consts::FRAC_PI_2;

const ONE: [(&str, f64); 3] = [("m", 1.0), ("l", 1.0), ("g", 1.0)];

pub(super) fn cases(effort: Effort) -> Vec<Case> {
    let (single, double) = if effort == Effort::Full { (3000.0, 300.0) } else { (300.0, 30.0) };
    vec![pendulum(single), double_pendulum(double)]
}

/// A bar of amplitude 90° swings as a pendulum of two thirds of its length.
fn period() -> f64 {
    reference("pendulum.period[90]") * (2.0_f64 / 3.0).sqrt()
}

fn pendulum(periods: f64) -> Case {
    let end = periods * period();
    let setup = Setup::with(&ONE)
        .start(&[("phi", FRAC_PI_2)])
        .tolerance(1e-13)
        .until(&format!("t = {end}"))
        .limit(2.0 * end);
    let scene = format!("pendulum, amplitude 90°, {periods:e} periods");
    // At the turning point φ̇ = −(3/2) (g/l) times the time by which it is late. A drift of the energy makes the
    // period drift: half of 1e-10 over all periods.
    let wants = vec![
        at_most("drift of E in mgl", 1e-10),
        want("φ", FRAC_PI_2, 1e-10),
        at_most("delay of the last turning point", 1e-10 * end),
    ];
    Case::numbers("long.pendulum", scene, "elliptic integral", wants, move || {
        let record = run("pendulum", &setup)?;
        let state = last(&*record);
        Ok(vec![drift(&*record, "E")?, state[0], (state[1] / 1.5).abs()])
    })
}

fn double_pendulum(periods: f64) -> Case {
    let end = periods * period();
    let start = [("phi_1", FRAC_PI_2), ("phi_2", FRAC_PI_2)];
    let setup =
        Setup::with(&ONE).start(&start).tolerance(1e-13).until(&format!("t = {end}")).limit(2.0 * end);
    let scene = format!("double-pendulum from rest at 90°, for {periods:e} periods of one bar");
    let wants = vec![at_most("drift of E in mgl", 1e-10)];
    Case::numbers("long.double pendulum", scene, "energy", wants, move || {
        Ok(vec![drift(&*run("double-pendulum", &setup)?, "E")?])
    })
}
