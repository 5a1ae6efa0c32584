//! `liftoff fit`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::output::fit;
use crate::output::notes::note;
use crate::output::print::print;
use clap::Args;
use liftoff_core::model::Layout;
use liftoff_studio::analyses::{self, Measured, MeasuredEvent, MeasuredTable, check_deviation};
use liftoff_studio::registry::{Entry, Models, RunOptions, Units};
use std::path::PathBuf;

/// What stands before a standard deviation, in any typing.
const DEVIATIONS: [&str; 2] = ["±", "+-"];

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
        let spec = measured.lengthen(self.run_args.spec(model)?, self.run_args.has_until());
        let found = analyses::fit(model, (RunOptions::default(), spec), &self.vary, &measured)
            .map_err(|failure| CommandError::with_option("--vary", failure))?;
        print(&match self.json {
            true => fit::json(&measured, &found)?,
            false => fit::text(&measured, &found),
        })?;
        CommandError::unless_converged(&found.ending)
    }

    fn measured(&self, model: &Entry) -> Result<Measured, CommandError> {
        let layout = model.layout();
        let units = Units::from_layout(layout);
        let mut all = Measured::default();
        if let Some(path) = &self.data {
            let deviations = self.deviations(&units)?;
            all.add_table(&MeasuredTable::load(layout, path, &self.of)?, &deviations)
                .map_err(|why| CommandError::Usage(format!("--sd {why}")))?;
            if all.last.is_none() {
                return Err(CommandError::Usage(format!("{} has no values", path.display())));
            }
        }
        for text in &self.event {
            add_event(&mut all, &units, (text, layout))
                .map_err(|why| CommandError::Usage(format!("--event {text}: {why}")))?;
        }
        if all.skipped > 0 {
            note(&format!("empty cells, which are skipped: {}", all.skipped));
        }
        let gives = "--sd COLUMN=VALUE, a column `COLUMN ±`, or `±` after the value of an event gives it";
        all.check(self.run_args.limit(), gives).map_err(CommandError::Usage)?;
        Ok(all)
    }

    /// `COLUMN=VALUE` of standard deviations.
    fn deviations(&self, units: &Units) -> Result<Vec<(String, f64)>, CommandError> {
        let mut found: Vec<(String, f64)> = Vec::new();
        for text in &self.sd {
            let wrong = |why: &str| CommandError::Usage(format!("--sd {text}: {why}"));
            let (name, value) = text.rsplit_once('=').ok_or_else(|| wrong("expected COLUMN=VALUE"))?;
            let value = units.measure(name, value).map_err(|why| wrong(&why))?;
            check_deviation(value).map_err(|why| wrong(&why))?;
            found.push((name.trim().to_owned(), value));
        }
        let twice = (1..found.len()).find(|&k| found[..k].iter().any(|(name, _)| *name == found[k].0));
        match twice {
            Some(k) => Err(CommandError::Usage(format!("--sd {} is given twice", found[k].0))),
            None => Ok(found),
        }
    }
}

/// `first open=0.4531`, `2nd impact phi=0.3±0.01`.
fn add_event(
    all: &mut Measured,
    units: &Units,
    (text, layout): (&str, &'static Layout),
) -> Result<(), String> {
    let (what, value) = text.rsplit_once('=').ok_or("expected WHAT=VALUE")?;
    let parts = DEVIATIONS.iter().find_map(|sign| value.split_once(sign));
    let (value, known) = parts.map_or((value, None), |(value, known)| (value, Some(known)));
    let event = MeasuredEvent::parse(what, layout)?;
    let kind = event.kind();
    let number = |text: &str| units.measure(&kind, text);
    all.add_event(event, number(value)?, known.map(number).transpose()?)
}
