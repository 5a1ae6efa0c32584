//! `liftoff equilibrium`.

use crate::CommandError;
use crate::options::length::Length;
use crate::options::pose_args::PoseArgs;
use crate::options::values::{Assignment, assignment};
use crate::output::analysis::{self, Detail};
use crate::output::print::print;
use clap::Args;
use liftoff_studio::analyses::find_equilibria;
use liftoff_studio::registry::{Models, Units};

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
    #[command(flatten)]
    length: Length,
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
        if let Some(Load { name, to: Some(to) }) = &self.load {
            let checked = Units::from_layout(model.layout()).check(name, to.unit);
            checked.map_err(|why| CommandError::Usage(format!("--load {name}: {why}")))?;
        }
        let load = self.load.as_ref();
        let towards =
            load.map(|Load { name, to }| (name.as_str(), to.as_ref().map_or(f64::INFINITY, |to| to.value)));
        let found = find_equilibria(model, &self.pose.spec(model)?, towards)
            .map_err(|failure| CommandError::with_option("--load", failure))?;
        let (layout, name) = (model.layout(), load.map(|load| load.name.as_str()));
        let text = |found, detail| analysis::equilibria_text(layout, found, name, detail);
        // An equilibrium takes five lines at most then.
        let brief = |lines| text(&found[..found.len().min(lines / 5)], Detail::Rates);
        Ok(print(&match self.json {
            true => analysis::equilibria_json(layout, &found, load.is_some())?,
            false => self.length.fit(text(&found, Detail::All), brief),
        })?)
    }
}
