//! `liftoff linearise`.

use crate::CommandError;
use crate::options::pose_args::PoseArgs;
use crate::output::analysis;
use crate::output::file::{Form, probe_as, tell_written, write_picture};
use crate::output::notes::note;
use crate::output::print::print;
use clap::Args;
use liftoff_analysis::Subject;
use liftoff_studio::analyses::{self, LinearHalves, describe_motion, find_contacts, subject};
use liftoff_studio::animation::{ModeShape, mode_shapes};
use liftoff_studio::registry::{Entry, Models, MotionError};
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub struct Linearise {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    pose: PoseArgs,
    /// The closed supports, `A,E`, or `free`; by default all that touch at the start
    #[arg(long, value_name = "SUPPORTS")]
    closed: Option<String>,
    /// Unfold a mirrored model: the motions that keep its symmetry, and those that break it
    #[arg(long)]
    unfold: bool,
    /// Print JSON, with the matrices A and B
    #[arg(long)]
    json: bool,
    /// Draw the modes into a file, as animations
    #[arg(long, value_name = "FILE", conflicts_with = "json")]
    svg: Option<PathBuf>,
}

impl Linearise {
    /// Prints or draws the modes of vibration about the start, at rest, of one contact set.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        if let Some(path) = &self.svg {
            probe_as(path, &[Form::SVG])?;
        }
        let model = models.find(&self.model)?;
        let spec = self.pose.spec(model)?;
        let subject = subject(model, &spec)?;
        let closed = find_contacts(&subject, self.closed.as_deref())?;
        if self.unfold {
            let unfolded = model.unfolded().map_err(|error| match error {
                MotionError::Input(text) => CommandError::Usage(format!("--unfold: {text}")),
                error => error.into(),
            })?;
            let halves = analyses::linearise_halves(&unfolded, &spec.parameters, &subject, closed)?;
            return self.tell_halves(&halves);
        }
        let linear = analyses::linearise(&subject, closed)?;
        warn_of_motion(linear.residual());
        match (&self.svg, self.json) {
            (Some(path), _) => self.draw(path, model, &subject, &analysis::mode_shapes(&linear)),
            (None, true) => Ok(print(&analysis::linear_json(subject.layout(), &linear)?)?),
            (None, false) => Ok(print(&analysis::modes_text(subject.layout(), &linear))?),
        }
    }

    fn tell_halves(&self, LinearHalves { model, subject, parts }: &LinearHalves) -> Result<(), CommandError> {
        warn_of_motion(parts.symmetric.residual().max(parts.antisymmetric.residual()));
        match (&self.svg, self.json) {
            (Some(path), _) => self.draw(path, model, subject, &analysis::mode_shapes_by_symmetry(parts)),
            (None, true) => Ok(print(&analysis::by_symmetry_json(subject.layout(), parts)?)?),
            (None, false) => Ok(print(&analysis::by_symmetry_text(subject.layout(), parts))?),
        }
    }

    fn draw(
        &self,
        path: &Path,
        model: &Entry,
        subject: &Subject,
        modes: &[ModeShape],
    ) -> Result<(), CommandError> {
        if modes.is_empty() {
            return Err(CommandError::Failed("nothing can move here: there are no modes to draw".to_owned()));
        }
        let svg = mode_shapes(model, &self.pose.parameters(model)?, &subject.positions(), modes)?;
        write_picture(path, &svg)?;
        tell_written(path);
        Ok(())
    }
}

/// Says so where the start is no equilibrium.
fn warn_of_motion(residual: f64) {
    if let Some(text) = describe_motion(residual) {
        note(&text);
    }
}
