//! An instance: a model with what is set of it, and the motion once it has begun.

mod co_simulation;
mod exchanged;
mod stage;
mod values;

use crate::exchange::{Exchange, Indicators};
use crate::experiment::Experiment;
use crate::motion::Motion;
use crate::place::{Instant, Readings};
use crate::settings::{Settings, variable};
use liftoff::Simulation;
use liftoff_fmu::{Interface, Resources};
use liftoff_studio::RunSpec;
use liftoff_studio::registry::Entry;
use stage::Stage;
use std::path::Path;

/// When a motion ends whose end is not given: never.
const NEVER: f64 = f64::MAX;

/// The tolerance of event indicators where none is given, relative to natural units.
const TOLERANCE: f64 = 1e-9;

/// Who integrates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The importer.
    Exchange,
    /// The unit; and whether it returns at events.
    CoSimulation {
        /// Whether the importer handles events.
        event_mode: bool,
        /// Whether a step may end early.
        early_return: bool,
    },
}

/// A motion that has begun.
enum Begun {
    Exchange(Box<Exchange>),
    Motion(Box<Motion>),
}

/// An instance.
pub(crate) struct Instance {
    kind: Kind,
    model: Entry,
    spec: RunSpec,
    interface: Interface,
    readings: Readings,
    indicators: Indicators,
    stage: Stage,
    settings: Settings,
    experiment: Experiment,
    begun: Option<Begun>,
}

impl Instance {
    /// The model of a folder of resources, for a description with a token.
    ///
    /// # Errors
    /// The resources cannot be read, or the description is another's.
    pub(crate) fn new(kind: Kind, resources: &Path, token: &str) -> Result<Self, String> {
        let resources = Resources::load(resources).map_err(|error| error.to_string())?;
        if token != resources.token().map_err(|error| error.to_string())? {
            return Err(
                "the instantiation token is another: the description, the resources and the library are not \
                        from one unit"
                    .to_owned(),
            );
        }
        let model = resources.model().map_err(|error| error.to_string())?;
        let interface = Interface::from_model(&model, &resources.spec).map_err(|error| error.to_string())?;
        if let (Kind::Exchange, Some(lacks)) = (kind, interface.exchange_lacks) {
            return Err(format!("this model is for co-simulation only: it has {lacks}"));
        }
        Ok(Self {
            kind,
            model,
            spec: resources.spec,
            readings: Readings::from_interface(&interface)?,
            indicators: Indicators::from_interface(&interface)?,
            interface,
            stage: Stage::Instantiated,
            settings: Settings::default(),
            experiment: Experiment::default(),
            begun: None,
        })
    }

    /// `fmi3EnterInitializationMode`.
    pub(crate) fn enter_initialization(&mut self, experiment: Experiment) -> Result<(), String> {
        self.stage.must_be(&[Stage::Instantiated])?;
        experiment.check()?;
        (self.experiment, self.stage, self.begun) = (experiment, Stage::Initialization, None);
        Ok(())
    }

    /// `fmi3ExitInitializationMode`.
    pub(crate) fn exit_initialization(&mut self) -> Result<(), String> {
        self.stage.must_be(&[Stage::Initialization])?;
        self.begin()?;
        self.stage = match self.kind {
            Kind::CoSimulation { event_mode: false, .. } => Stage::Step,
            _ => Stage::Event,
        };
        Ok(())
    }

    /// `fmi3EnterEventMode`.
    pub(crate) fn enter_event(&mut self) -> Result<(), String> {
        let from = match self.kind {
            Kind::Exchange => Stage::Continuous,
            Kind::CoSimulation { event_mode: true, .. } => Stage::Step,
            Kind::CoSimulation { event_mode: false, .. } => {
                return Err("it was instantiated without event mode".to_owned());
            }
        };
        self.stage.must_be(&[from])?;
        self.stage = Stage::Event;
        Ok(())
    }

    /// `fmi3Terminate`.
    pub(crate) fn terminate(&mut self) -> Result<(), String> {
        self.stage.must_be(&[Stage::Event, Stage::Step, Stage::Continuous])?;
        self.stage = Stage::Terminated;
        Ok(())
    }

    /// `fmi3Reset`.
    pub(crate) fn reset(&mut self) {
        (self.stage, self.settings, self.experiment) =
            (Stage::Instantiated, Settings::default(), Experiment::default());
        self.begun = None;
    }

    /// `fmi3SetFloat64`.
    pub(crate) fn set(&mut self, references: &[u32], values: &[f64]) -> Result<(), String> {
        if references.len() != values.len() {
            return Err(format!("{} variables and {} values", references.len(), values.len()));
        }
        for (&reference, &value) in references.iter().zip(values) {
            let (_, variable) = variable(&self.interface, reference)?;
            if !matches!(self.stage, Stage::Instantiated | Stage::Initialization) {
                return Err(format!("`{}` cannot be set after the initialisation", variable.name));
            }
            self.settings.set(variable, value)?;
            self.begun = None;
        }
        Ok(())
    }

    /// Begins the motion, if it has not begun.
    fn begin(&mut self) -> Result<&Begun, String> {
        if self.begun.is_none() {
            let spec = self.settings.spec(&self.spec);
            let simulation = self.simulation(&spec)?;
            let Experiment { start, stop, tolerance } = self.experiment;
            self.begun = Some(match self.kind {
                Kind::Exchange => {
                    let times = (start, tolerance.unwrap_or(TOLERANCE));
                    let seen = (&self.interface, self.indicators.clone());
                    Begun::Exchange(Box::new(Exchange::begin(simulation, seen, times)?))
                }
                Kind::CoSimulation { .. } => {
                    Begun::Motion(Box::new(Motion::begin(&simulation, stop.unwrap_or(NEVER))?))
                }
            });
        }
        self.begun.as_ref().ok_or_else(|| "the motion has not begun".to_owned())
    }

    /// The simulation of what is set.
    fn simulation(&self, spec: &RunSpec) -> Result<Simulation, String> {
        let Experiment { start, tolerance, .. } = self.experiment;
        let finer = tolerance.filter(|_| self.kind != Kind::Exchange).unwrap_or(spec.tolerance);
        let mut spec = RunSpec { tolerance: spec.tolerance.min(finer), ..spec.clone() };
        spec.start.push(("t".to_owned(), start));
        self.model.simulation(&spec).map_err(|error| error.to_string())
    }

    /// Where the motion is.
    fn instant(&self) -> Option<(&Simulation, &Instant)> {
        match self.begun.as_ref()? {
            Begun::Exchange(exchange) => Some((exchange.simulation(), exchange.seen())),
            Begun::Motion(motion) => Some((motion.simulation(), motion.instant())),
        }
    }
}
