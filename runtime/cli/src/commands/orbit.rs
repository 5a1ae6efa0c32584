//! `liftoff orbit`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::options::values::{Assignment, assignment};
use crate::output::orbit;
use crate::output::print::print;
use clap::Args;
use liftoff::{NameError, Simulation};
use liftoff_analysis::{ReturnMap, Section};
use liftoff_core::model::Layout;
use liftoff_core::scalar::Dual4;
use liftoff_studio::registry::{Entry, Models, Units};
use liftoff_studio::run_spec::RunSpec;

#[derive(Args, Debug)]
pub struct Orbit {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The section, met once per period: an event, `impact` or `impact A`, or a condition that
    /// becomes true, `phi' > 0`; for a driven model `t = T` with the period of its drive
    #[arg(long, value_name = "EVENT|EXPR")]
    section: String,
    /// A coordinate that need not return, such as the distance walked
    #[arg(long, value_name = "NAME")]
    drift: Vec<String>,
    /// A parameter in which to continue the orbit, and its final value
    #[arg(long = "continue", value_name = "NAME=VALUE", value_parser = assignment)]
    to: Option<Assignment>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Orbit {
    /// Prints the periodic orbit near the run, its multipliers, and its branch where a parameter is given.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let layout = model.layout();
        let spec = RunSpec { until: Vec::new(), ..self.run_args.spec(model)? };
        let start = model.simulation(&spec)?;
        let state = start.start_state().map_err(|error| CommandError::Usage(error.to_string()))?;
        let map = ReturnMap {
            simulate: &|parameters: &[f64], state: &[f64]| simulation(model, &spec, parameters, state),
            model: &|parameters: &[Dual4]| model.varied(parameters).map_err(|error| error.to_string()),
            section: Section::parse(layout, &self.section)?,
            drifting: self.drift.iter().map(|name| coordinate(layout, name)).collect::<Result<_, _>>()?,
        };
        let found = map.orbit(&start.model().parameters, layout.public_state(&state))?;
        let Some(to) = &self.to else {
            return Ok(print(&match self.json {
                true => orbit::json(layout, &found)?,
                false => orbit::text(layout, &found),
            })?);
        };
        let place = parameter(layout, &to.name)?;
        Units::from_layout(layout)
            .check(&to.name, to.unit)
            .map_err(|why| CommandError::Usage(format!("--continue {}: {why}", to.name)))?;
        let branch = map.branch(&found, place, to.value)?;
        Ok(print(&match self.json {
            true => orbit::branch_json(layout, &branch)?,
            false => orbit::branch_text(layout, &branch, place),
        })?)
    }
}

/// The run with these parameters from a state.
fn simulation(
    model: &Entry,
    spec: &RunSpec,
    parameters: &[f64],
    values: &[f64],
) -> Result<Simulation, String> {
    let layout = model.layout();
    let names = layout.parameters.iter().map(|name| (*name).to_owned());
    let spec = RunSpec {
        parameters: names.zip(parameters.iter().copied()).collect(),
        start: layout.names_of_state().zip(values.iter().copied()).collect(),
        energy_of: Vec::new(),
        ..spec.clone()
    };
    model.simulation(&spec).map_err(|error| error.to_string())
}

fn coordinate(layout: &Layout, name: &str) -> Result<usize, CommandError> {
    let names = || layout.coordinates.iter().map(|coordinate| coordinate.name);
    let place = names().position(|known| known == name);
    place.ok_or_else(|| CommandError::Usage(NameError::new("coordinate", name, names()).to_string()))
}

fn parameter(layout: &Layout, name: &str) -> Result<usize, CommandError> {
    let names = || layout.parameters.iter().copied();
    let place = names().position(|known| known == name);
    place.ok_or_else(|| CommandError::Usage(NameError::new("parameter", name, names()).to_string()))
}
