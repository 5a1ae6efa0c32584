//! What importers call that let the unit integrate.

use super::{Begun, Instance, Kind, Stage};
use crate::motion::{Arrival, Motion};

/// Times that differ by this part of themselves and of a step are one: importers add up their
/// steps.
const ONE_TIME: f64 = 1e-9;

/// What a step has come to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Step {
    /// Whether there is an event to be handled where it has come to.
    pub(crate) event: bool,
    /// Whether the motion has ended.
    pub(crate) ended: bool,
    /// Whether it has come less far than was asked for.
    pub(crate) early: bool,
    /// How far it has come.
    pub(crate) t: f64,
}

impl Instance {
    /// `fmi3DoStep`.
    pub(crate) fn step(&mut self, from: f64, length: f64) -> Result<Step, String> {
        self.stage.must_be(&[Stage::Step])?;
        let Kind::CoSimulation { event_mode, early_return } = self.kind else {
            return Err("the importer integrates: this is an instance for model exchange".to_owned());
        };
        if !(length > 0.0 && length.is_finite()) {
            return Err(format!("the step {length} is not a finite time > 0"));
        }
        let (stop, pauses) = (self.experiment.stop, event_mode && early_return);
        let Some(Begun::Motion(motion)) = &mut self.begun else {
            return Err("the motion has not begun".to_owned());
        };
        let here = motion.instant().t;
        let is_here = (from - here).abs() <= ONE_TIME * length.max(here.abs());
        if !is_here {
            return Err(format!("the step begins at t = {from}, and the motion is at t = {here}"));
        }
        let to = from + length;
        let aim = match stop {
            Some(stop) if to > stop + ONE_TIME * length => {
                return Err(format!("the step ends at t = {to}, after the stop time {stop}"));
            }
            Some(stop) => to.min(stop),
            None => to,
        };
        let arrival = advance(motion, aim.max(here), pauses)?;
        let t = motion.instant().t;
        Ok(match arrival {
            Arrival::Reached => Step { event: false, ended: false, early: false, t: to },
            Arrival::Event => {
                Step { event: true, ended: false, early: t < aim, t: if t < aim { t } else { to } }
            }
            Arrival::Ended => Step { event: false, ended: true, early: true, t },
        })
    }

    /// `fmi3EnterStepMode`.
    pub(crate) fn enter_step(&mut self) -> Result<(), String> {
        if self.kind == Kind::Exchange {
            return Err("this is an instance for model exchange".to_owned());
        }
        self.stage.must_be(&[Stage::Event])?;
        self.stage = Stage::Step;
        Ok(())
    }
}

/// Moves on to a time, or to the first event before. An event that has not been passed is.
fn advance(motion: &mut Motion, to: f64, pauses: bool) -> Result<Arrival, String> {
    loop {
        match motion.to(to)? {
            Arrival::Event if pauses => return Ok(Arrival::Event),
            Arrival::Event => {
                if motion.pass()? == Arrival::Ended {
                    return Ok(Arrival::Ended);
                }
            }
            arrival => return Ok(arrival),
        }
    }
}
