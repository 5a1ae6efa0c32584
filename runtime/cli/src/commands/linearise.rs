//! `liftoff linearise`.

use crate::CommandError;
use crate::options::pose_args::PoseArgs;
use crate::output::analysis;
use crate::output::notes::note;
use crate::output::print::print;
use clap::Args;
use liftoff_analysis::Linearisation;
use liftoff_studio::registry::Models;

/// An acceleration above this, in natural units, is none of an equilibrium.
const AT_REST: f64 = 1e-9;

#[derive(Args, Debug)]
pub struct Linearise {
    /// Name of the model, as `list` has it; or a file of Rust, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    pose: PoseArgs,
    /// The supports that are closed, `A,E`, or `free`; by default all that touch at the start
    #[arg(long, value_name = "SUPPORTS")]
    closed: Option<String>,
    /// Print JSON, with the matrices A and B
    #[arg(long)]
    json: bool,
}

impl Linearise {
    /// Prints the modes of vibration about the start, at rest, of one contact set.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let subject = self.pose.subject(models.find(&self.model)?)?;
        let closed = match self.closed.as_deref() {
            None => subject.touching(),
            Some("free") => subject.contacts(&[])?,
            Some(names) => subject.contacts(&names.split(',').map(str::trim).collect::<Vec<_>>())?,
        };
        let linear = Linearisation::of(&subject, closed)?;
        if linear.residual() > AT_REST {
            note(&format!(
                "the start is no equilibrium: it accelerates by {:.1e} natural units; `equilibrium` finds one nearby",
                linear.residual()
            ));
        }
        let layout = subject.layout();
        Ok(print(&match self.json {
            true => analysis::linear_json(layout, &linear)?,
            false => analysis::modes_text(layout, &linear),
        })?)
    }
}
