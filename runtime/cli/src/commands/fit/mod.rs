//! `liftoff fit`.

pub mod data;
mod table;

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::options::variables::{variables, with_values};
use crate::output::fit;
use crate::output::notes::note;
use crate::output::print::print;
use clap::Args;
use data::Measured;
use liftoff_analysis::Fit as LeastSquares;
use liftoff_core::scalar::Dual4;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::run_spec::RunSpec;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Fit {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// A parameter, coordinate or rate at the start to fit; the search begins with its value in the
    /// run
    #[arg(long, value_name = "NAME", required = true)]
    vary: Vec<String>,
    /// A table with a column `t` and columns named by outputs, as `run --csv` writes it; a column
    /// `phi ±` has the standard deviations
    #[arg(long, value_name = "FILE.csv", required_unless_present = "event")]
    data: Option<PathBuf>,
    /// A column of the table to fit [default: all]
    #[arg(long, value_name = "COLUMN", requires = "data")]
    of: Vec<String>,
    /// The standard deviation of a column
    #[arg(long, value_name = "COLUMN=VALUE", requires = "data")]
    sd: Vec<String>,
    /// The measured time of an event, `first open=0.4531`, or an output after it, `2nd impact
    /// phi=0.3`; a standard deviation after `±` or `+-`
    #[arg(long, value_name = "WHAT=VALUE[±SD]")]
    event: Vec<String>,
    /// Print JSON, with the residuals
    #[arg(long)]
    json: bool,
}

impl Fit {
    /// Prints the values with the least sum of squares, with their errors.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let measured = self.measured(model)?;
        let spec = self.spec(model, &measured)?;
        let simulation = model.simulation(&spec)?;
        let varied = variables(&simulation, &spec, "--vary", &self.vary)?;
        let simulate = |values: &[f64]| {
            model.simulation(&with_values(&spec, &varied, values)).map_err(|error| error.to_string())
        };
        let equations = |parameters: &[Dual4]| model.varied(parameters).map_err(|error| error.to_string());
        let problem = LeastSquares {
            simulate: &simulate,
            model: &equations,
            variables: varied.clone(),
            data: measured.data.clone(),
        };
        let found = problem.solve()?;
        print(&match self.json {
            true => fit::json(&measured, &found)?,
            false => fit::text(&measured, &found),
        })?;
        CommandError::unless_converged(&found.ending)
    }

    fn measured(&self, model: &Entry) -> Result<Measured, CommandError> {
        let mut all = Measured::default();
        if let Some(path) = &self.data {
            all.add_table(model.layout(), path, &self.of, &self.sd)?;
        }
        self.event.iter().try_for_each(|text| all.add_event(model.layout(), text))?;
        if let (Some(limit), Some((line, t))) = (self.run_args.limit(), all.last)
            && t > limit
        {
            let told = format!("line {line} of the table: t = {t} is after the limit {limit}");
            return Err(CommandError::Usage(told));
        }
        if all.skipped > 0 {
            note(&format!("empty cells, which are skipped: {}", all.skipped));
        }
        all.weighed()
    }

    /// The run, as long as there are data: what ends a model's default run does not end that of a series.
    fn spec(&self, model: &Entry, measured: &Measured) -> Result<RunSpec, CommandError> {
        let mut spec = self.run_args.spec(model)?;
        let last = measured.data.iter().filter_map(|datum| datum.place.time()).reduce(f64::max);
        if let Some(last) = last {
            if !self.run_args.has_until() {
                spec.until.clear();
            }
            spec.limit = spec.limit.map(|limit| limit.max(last));
        }
        Ok(spec)
    }
}
