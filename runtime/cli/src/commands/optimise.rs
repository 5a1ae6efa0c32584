//! `liftoff optimise`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::options::values::measured;
use crate::options::variables::{variables, with_values};
use crate::output::optimum;
use crate::output::print::print;
use clap::Args;
use liftoff::Output;
use liftoff_analysis::{Free, Optimum, Place};
use liftoff_core::model::Layout;
use liftoff_core::scalar::Dual4;
use liftoff_studio::registry::{Entry, Models, Units};
use liftoff_studio::sweep::Observation;

#[derive(Args, Debug)]
pub struct Optimise {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// A parameter, coordinate or rate at the start, with optional bounds; the search begins with
    /// its value in the run
    #[arg(long, value_name = "NAME[=LOW:HIGH]", required = true)]
    vary: Vec<String>,
    /// The quantity to minimise: `first open`, the time of an event, `first impact x`, an output
    /// after one, `end phi`, an output at the end
    #[arg(long, value_name = "WHAT")]
    of: String,
    /// Maximise it
    #[arg(long)]
    greatest: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Optimise {
    /// Prints the values with which what is asked for is least or greatest.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let (place, output) = self.resolve(model.layout())?;
        let spec = self.run_args.spec(model)?;
        let simulation = model.simulation(&spec)?;
        let (names, bounds): (Vec<String>, Vec<_>) = self
            .vary
            .iter()
            .map(|text| bounded(model, text))
            .collect::<Result<Vec<_>, _>>()?
            .into_iter()
            .unzip();
        let varied = variables(&simulation, &spec, "--vary", &names)?;
        let simulate = |values: &[f64]| {
            model.simulation(&with_values(&spec, &varied, values)).map_err(|error| error.to_string())
        };
        let equations = |parameters: &[Dual4]| model.varied(parameters).map_err(|error| error.to_string());
        let free = |(variable, bounds)| Free { variable, bounds };
        let problem = Optimum {
            simulate: &simulate,
            model: &equations,
            variables: varied.iter().cloned().zip(bounds).map(free).collect(),
            place,
            output,
            greatest: self.greatest,
        };
        let best = problem.solve()?;
        print(&match self.json {
            true => optimum::json(&self.of, &names, &best)?,
            false => optimum::text(&self.of, &names, &best),
        })?;
        CommandError::unless_converged(&best.ending)
    }

    /// When what is asked for is read, and what it is.
    fn resolve(&self, layout: &'static Layout) -> Result<(Place, Option<Output>), CommandError> {
        let wrong = |why: &str| CommandError::Usage(format!("--of {}: {why}", self.of));
        let observation = Observation::parse(&self.of, layout).map_err(|error| wrong(&error.to_string()))?;
        if let Some(output) = observation.at_end() {
            return Ok((Place::End, Some(output.clone())));
        }
        let (which, filter, output) = observation.event().ok_or_else(|| {
            wrong("expected an event, `first open`, an output after it, `2nd impact x`, or at the end, `end phi`")
        })?;
        Ok((Place::Event(which, filter), output.cloned()))
    }
}

/// `NAME` or `NAME=LOW:HIGH`.
fn bounded(model: &Entry, text: &str) -> Result<(String, Option<[f64; 2]>), CommandError> {
    let wrong = |why: &str| CommandError::Usage(format!("--vary {text}: {why}"));
    let Some((name, bounds)) = text.split_once('=') else { return Ok((text.trim().to_owned(), None)) };
    let (low, high) = bounds.split_once(':').ok_or_else(|| wrong("expected NAME=LOW:HIGH"))?;
    let units = Units::from_layout(model.layout());
    let number = |text: &str| measured(&units, name, text).map_err(|why| wrong(&why));
    let [low, high] = [number(low)?, number(high)?];
    if !(low < high && (high - low).is_finite()) {
        return Err(wrong("expected a lower and a greater bound"));
    }
    Ok((name.trim().to_owned(), Some([low, high])))
}
