//! `liftoff optimise`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::output::optimum;
use crate::output::print::print;
use clap::Args;
use liftoff_studio::analyses::{Bounded, Goal, optimise};
use liftoff_studio::registry::{Entry, Models, RunOptions, Units};

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
        let goal = Goal::parse(&self.of, model.layout(), self.greatest)
            .map_err(|why| CommandError::Usage(format!("--of {}: {why}", self.of)))?;
        let run = (RunOptions::default(), self.run_args.spec(model)?);
        let varied = self.vary.iter().map(|text| bounded(model, text)).collect::<Result<Vec<_>, _>>()?;
        let best = optimise(model, run, &varied, goal)
            .map_err(|failure| CommandError::with_option("--vary", failure))?;
        let names: Vec<String> = varied.into_iter().map(|(name, _)| name).collect();
        print(&match self.json {
            true => optimum::json(&self.of, &names, &best)?,
            false => optimum::text(&self.of, &names, &best),
        })?;
        CommandError::unless_converged(&best.ending)
    }
}

/// `NAME` or `NAME=LOW:HIGH`.
fn bounded(model: &Entry, text: &str) -> Result<Bounded, CommandError> {
    let wrong = |why: &str| CommandError::Usage(format!("--vary {text}: {why}"));
    let Some((name, bounds)) = text.split_once('=') else { return Ok((text.trim().to_owned(), None)) };
    let (low, high) = bounds.split_once(':').ok_or_else(|| wrong("expected NAME=LOW:HIGH"))?;
    let units = Units::from_layout(model.layout());
    let number = |text: &str| units.measure(name, text).map_err(|why| wrong(&why));
    let [low, high] = [number(low)?, number(high)?];
    if !(low < high && (high - low).is_finite()) {
        return Err(wrong("expected a lower and a greater bound"));
    }
    Ok((name.trim().to_owned(), Some([low, high])))
}
