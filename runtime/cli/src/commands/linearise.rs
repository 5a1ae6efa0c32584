//! `liftoff linearise`.

use crate::CommandError;
use crate::options::pose_args::{self, PoseArgs};
use crate::output::analysis;
use crate::output::notes::note;
use crate::output::print::print;
use clap::Args;
use liftoff::model::ContactSet;
use liftoff_analysis::{BySymmetry, Linearisation, Subject};
use liftoff_studio::registry::{Entry, Models, MotionError};

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
    /// Unfold a mirrored model: the motions that keep its symmetry, and those that break it
    #[arg(long)]
    unfold: bool,
    /// Print JSON, with the matrices A and B
    #[arg(long)]
    json: bool,
}

impl Linearise {
    /// Prints the modes of vibration about the start, at rest, of one contact set.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let subject = self.pose.subject(model)?;
        let closed = self.closed(&subject)?;
        let text = if self.unfold {
            let (whole, parts) = self.unfolded(model, &subject, closed)?;
            warn_of_motion(parts.symmetric.residual().max(parts.antisymmetric.residual()));
            match self.json {
                true => analysis::by_symmetry_json(whole.layout(), &parts)?,
                false => analysis::by_symmetry_text(whole.layout(), &parts),
            }
        } else {
            let linear = Linearisation::of(&subject, closed)?;
            warn_of_motion(linear.residual());
            match self.json {
                true => analysis::linear_json(subject.layout(), &linear)?,
                false => analysis::modes_text(subject.layout(), &linear),
            }
        };
        Ok(print(&text)?)
    }

    fn closed(&self, subject: &Subject) -> Result<ContactSet, CommandError> {
        Ok(match self.closed.as_deref() {
            None => subject.touching(),
            Some("free") => subject.contacts(&[])?,
            Some(names) => subject.contacts(&names.split(',').map(str::trim).collect::<Vec<_>>())?,
        })
    }

    /// Both halves about the position of the mirrored model, closed where that is.
    fn unfolded(
        &self,
        model: &Entry,
        mirrored: &Subject,
        closed: ContactSet,
    ) -> Result<(Subject, BySymmetry), CommandError> {
        let unfolded = model.unfolded().map_err(|error| match error {
            MotionError::Input(text) => CommandError::Usage(format!("--unfold: {text}")),
            error => error.into(),
        })?;
        let parameters = self.pose.parameters(model)?;
        let start = unfolded.position(&parameters, &mirrored.positions())?;
        let whole = pose_args::subject(unfolded.model(), parameters.clone(), start)?;
        let supports: Vec<&str> =
            closed.iter().flat_map(|i| mirrored.layout().contacts[i].supports).copied().collect();
        let linear = Linearisation::of(&whole, whole.contacts(&supports)?)?;
        let reflection = unfolded.reflection(&parameters, &whole.positions())?;
        Ok((whole, linear.by_symmetry(&reflection)?))
    }
}

/// Says so where the largest acceleration at the start is none of an equilibrium.
fn warn_of_motion(residual: f64) {
    if residual > AT_REST {
        note(&format!(
            "the start is no equilibrium: it accelerates by {residual:.1e} natural units; `equilibrium` finds one nearby"
        ));
    }
}
