//! What importers call that integrate, and what both call at events.

use super::{Begun, Instance, Kind, Stage};
use crate::exchange::{Exchange, Update};
use crate::motion::Arrival;

impl Instance {
    /// `fmi3UpdateDiscreteStates`.
    pub(crate) fn update(&mut self) -> Result<Update, String> {
        self.stage.must_be(&[Stage::Event])?;
        match &mut self.begun {
            Some(Begun::Exchange(exchange)) => exchange.update(),
            Some(Begun::Motion(motion)) => {
                let ended = motion.pass()? == Arrival::Ended;
                Ok(Update { moved: false, ended })
            }
            None => Err("the motion has not begun".to_owned()),
        }
    }

    /// `fmi3EnterContinuousTimeMode`.
    pub(crate) fn enter_continuous(&mut self) -> Result<(), String> {
        if self.kind != Kind::Exchange {
            return Err("this is an instance for co-simulation".to_owned());
        }
        self.stage.must_be(&[Stage::Event])?;
        self.stage = Stage::Continuous;
        Ok(())
    }

    /// `fmi3CompletedIntegratorStep`: there is nothing to be done.
    pub(crate) fn completed_step(&self) -> Result<(), String> {
        self.stage.must_be(&[Stage::Continuous])
    }

    /// `fmi3SetTime`.
    pub(crate) fn set_time(&mut self, t: f64) -> Result<(), String> {
        self.stage.must_be(&[Stage::Continuous, Stage::Event])?;
        if !t.is_finite() {
            return Err(format!("the time cannot be {t}"));
        }
        self.exchange_mut()?.set_time(t);
        Ok(())
    }

    /// `fmi3SetContinuousStates`.
    pub(crate) fn set_states(&mut self, states: &[f64]) -> Result<(), String> {
        self.stage.must_be(&[Stage::Continuous])?;
        self.must_count(states.len())?;
        self.exchange_mut()?.set_states(states);
        Ok(())
    }

    /// `fmi3GetContinuousStates`.
    pub(crate) fn states(&mut self, count: usize) -> Result<Vec<f64>, String> {
        self.must_count(count)?;
        Ok(self.exchange()?.instant().state.clone())
    }

    /// `fmi3GetContinuousStateDerivatives`.
    pub(crate) fn derivatives(&mut self, count: usize) -> Result<Vec<f64>, String> {
        self.must_count(count)?;
        Ok(self.exchange()?.derivatives())
    }

    /// `fmi3GetNominalsOfContinuousStates`.
    pub(crate) fn nominals(&mut self, count: usize) -> Result<Vec<f64>, String> {
        self.must_count(count)?;
        Ok(self.exchange()?.nominals())
    }

    /// `fmi3GetEventIndicators`.
    pub(crate) fn event_indicators(&mut self, count: usize) -> Result<Vec<f64>, String> {
        let indicators = self.exchange()?.indicators();
        match indicators.len() == count {
            true => Ok(indicators),
            false => Err(format!("there are {} event indicators, not {count}", indicators.len())),
        }
    }

    /// `fmi3GetNumberOfEventIndicators`.
    pub(crate) fn count_of_indicators(&self) -> usize {
        self.indicators.len()
    }

    /// `fmi3GetNumberOfContinuousStates`.
    pub(crate) fn count_of_states(&self) -> usize {
        2 * self.interface.layout.coordinates.len()
    }

    fn must_count(&self, count: usize) -> Result<(), String> {
        let states = self.count_of_states();
        if count == states {
            Ok(())
        } else {
            Err(format!("there are {states} continuous states, not {count}"))
        }
    }

    fn exchange(&mut self) -> Result<&Exchange, String> {
        match self.begin()? {
            Begun::Exchange(exchange) => Ok(exchange),
            Begun::Motion(_) => Err(NO_EXCHANGE.to_owned()),
        }
    }

    fn exchange_mut(&mut self) -> Result<&mut Exchange, String> {
        match &mut self.begun {
            Some(Begun::Exchange(exchange)) => Ok(exchange),
            _ => Err(NO_EXCHANGE.to_owned()),
        }
    }
}

const NO_EXCHANGE: &str = "this is an instance for co-simulation: it integrates itself";
