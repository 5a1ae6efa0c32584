//! `liftoff equilibrium`.

use crate::CommandError;
use crate::options::pose_args::PoseArgs;
use crate::options::values::{Assignment, assignment};
use crate::output::analysis;
use crate::output::print::print;
use clap::Args;
use liftoff::NameError;
use liftoff_analysis::{AnalysisError, Equilibrium as Rest, LoadLimit, equilibria, load_limit};
use liftoff_studio::registry::{Entry, Models, Units};

#[derive(Args, Debug)]
pub struct Equilibrium {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    pose: PoseArgs,
    /// A parameter, such as a load: find how far it may grow, or change towards VALUE, until a
    /// contact opens or slides
    #[arg(long, value_name = "NAME[=VALUE]", value_parser = load)]
    load: Option<Load>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

fn load(text: &str) -> Result<Load, String> {
    match text.contains('=') {
        true => assignment(text).map(|to| Load { name: to.name.clone(), to: Some(to) }),
        false => Ok(Load { name: text.trim().to_owned(), to: None }),
    }
}

/// A parameter that grows, and how far.
#[derive(Clone, Debug)]
struct Load {
    name: String,
    to: Option<Assignment>,
}

impl Equilibrium {
    /// Prints the equilibria that are found from the start, each with its reactions, its modes of vibration, and how far a load may go.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        if let Some(Load { name, to }) = &self.load {
            check_parameter(model, name)?;
            let unit = to.as_ref().and_then(|to| to.unit);
            let checked = Units::from_layout(model.layout()).check(name, unit);
            checked.map_err(|why| CommandError::Usage(format!("--load {name}: {why}")))?;
        }
        let subject = self.pose.subject(model)?;
        let found = equilibria(&subject)?;
        let layout = subject.layout();
        let limits = match &self.load {
            Some(Load { name, to }) => {
                let to = to.as_ref().map(|to| to.value);
                let each = found.iter().map(|rest| self.limit(model, rest, (name, to)));
                Some(each.collect::<Result<Vec<_>, _>>()?)
            }
            None => None,
        };
        let load = self.load.as_ref().map(|load| load.name.as_str());
        Ok(print(&match self.json {
            true => analysis::equilibria_json(layout, &found, limits.as_deref())?,
            false => analysis::equilibria_text(layout, &found, load.zip(limits.as_deref())),
        })?)
    }

    fn limit(
        &self,
        model: &Entry,
        rest: &Rest,
        (name, to): (&str, Option<f64>),
    ) -> Result<Option<LoadLimit>, CommandError> {
        let from = self.pose.parameter(model, name)?;
        let with = |value: f64| {
            let mut pose = self.pose.clone();
            pose.set.retain(|given| given.name != name);
            pose.set.push(Assignment { name: name.to_owned(), value, unit: None });
            pose.subject(model).map_err(|error| AnalysisError::Value { value, why: error.to_string() })
        };
        Ok(load_limit(&with, rest, [from, to.unwrap_or(f64::INFINITY)])?)
    }
}

fn check_parameter(model: &Entry, name: &str) -> Result<(), CommandError> {
    let names = || model.layout().parameters.iter().copied();
    if names().any(|known| known == name) {
        return Ok(());
    }
    Err(CommandError::Usage(format!("--load {}", NameError::new("parameter", name, names()))))
}
