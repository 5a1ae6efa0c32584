//! Periodic orbits.

use super::{Failure, equations, find_coordinate};
use crate::registry::{Entry, RunOptions, input};
use crate::run_spec::RunSpec;
use liftoff::Simulation;
use liftoff_analysis::{Branch, Orbit, OrbitError, ReturnMap, Section};
use liftoff_core::scalar::Dual4;

/// Periodic orbits near a run, by what is met once per period.
pub struct Orbits<'a> {
    model: &'a Entry,
    options: RunOptions,
    spec: RunSpec,
    section: Section,
    drifting: Vec<usize>,
}

impl<'a> Orbits<'a> {
    /// Those that meet a section, an event or a condition, once per period; coordinates that drift
    /// need not return. What ends the run does not end them.
    ///
    /// # Errors
    /// The section is neither; an unknown coordinate.
    pub fn new(
        model: &'a Entry,
        run: (RunOptions, RunSpec),
        section: &str,
        drift: &[String],
    ) -> Result<Self, Failure> {
        let (layout, (options, spec)) = (model.layout(), run);
        let spec = RunSpec { until: Vec::new(), ..spec };
        let section = Section::parse(layout, section)?;
        let drifting = drift.iter().map(|name| find_coordinate(layout, name)).collect::<Result<_, _>>()?;
        Ok(Self { model, options, spec, section, drifting })
    }

    /// That near the start of the run.
    ///
    /// # Errors
    /// The start is refused; no orbit is found.
    pub fn find(&self) -> Result<Orbit, Failure> {
        let start = self.model.simulation(&self.spec)?;
        let state = start.start_state().map_err(input)?;
        let state = self.model.layout().public_state(&state);
        self.by_map(|map| map.orbit(&start.model().parameters, state))
    }

    /// The branch of an orbit in the parameter at a place, up to a value.
    ///
    /// # Errors
    /// The orbit is one of a family.
    pub fn follow(&self, orbit: &Orbit, parameter: usize, to: f64) -> Result<Branch, Failure> {
        self.by_map(|map| map.branch(orbit, parameter, to))
    }

    fn by_map<T>(&self, work: impl FnOnce(&ReturnMap<'_>) -> Result<T, OrbitError>) -> Result<T, Failure> {
        let map = ReturnMap {
            simulate: &|parameters: &[f64], state: &[f64]| self.simulation(parameters, state),
            model: &|parameters: &[Dual4]| equations(self.model, parameters),
            section: self.section.clone(),
            drifting: self.drifting.clone(),
        };
        Ok(work(&map)?)
    }

    /// The run with these parameters from a state.
    fn simulation(&self, parameters: &[f64], values: &[f64]) -> Result<Simulation, String> {
        let layout = self.model.layout();
        let names = layout.parameters.iter().map(|name| (*name).to_owned());
        let spec = RunSpec {
            parameters: names.zip(parameters.iter().copied()).collect(),
            start: layout.names_of_state().zip(values.iter().copied()).collect(),
            energy_of: Vec::new(),
            ..self.spec.clone()
        };
        self.model.simulation_by(self.options.clone(), &spec).map_err(|error| error.to_string())
    }
}
