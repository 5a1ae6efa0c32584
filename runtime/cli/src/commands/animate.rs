//! `liftoff animate`.

use crate::CommandError;
use crate::errors::interrupted::{interrupted, is_interrupted};
use crate::options::run_args::RunArgs;
use crate::options::sliders::Sliders;
use crate::options::values::number;
use crate::output::file::{Form, print_beside, probe_as, write, write_picture};
use crate::output::progress::Progress;
use clap::Args;
use liftoff::Trajectory;
use liftoff_studio::animation::live::{self, Engine, Packed};
use liftoff_studio::animation::{self, About};
use liftoff_studio::registry::{Entry, MethodId, Models, MotionError, RunOptions};
use liftoff_studio::run_spec::RunSpec;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Args, Debug)]
pub struct Animate {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: MethodId,
    /// An expression to draw over time, besides coordinates, reactions and energies
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// The page to write, or with `.svg` an animated picture; by default MODEL.html in the current
    /// directory
    #[arg(long, value_name = "FILE.html|FILE.svg")]
    out: Option<PathBuf>,
    /// Factor of slow motion in a picture; by default one that is easy to follow
    #[arg(long, value_name = "X", value_parser = number)]
    slower: Option<f64>,
    #[command(flatten)]
    sliders: Sliders,
    /// Open it in the browser
    #[arg(long)]
    open: bool,
}

impl Animate {
    /// Runs the model and writes the page, or the moving picture, of its motion; that of a run that stopped short goes
    /// as far as it came, and the page says why.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        self.output.iter().try_for_each(|output| model.check(output))?;
        self.check_pace()?;
        let engine = self.engine()?;
        let path = self.path();
        probe_as(&path, &[Form::HTML, Form::SVG])?;
        let spec = self.run_args.spec(model)?;
        let options = RunOptions::by(self.method).cancel(Arc::clone(interrupted()));
        let progress = Progress::endless(format!("running {}", self.model));
        let outcome = model.run_by(options, &spec);
        drop(progress);
        match outcome {
            Ok(record) => self.write(model, &spec, engine.as_ref(), (&record, None)),
            Err(MotionError::Run { reason, trajectory }) => {
                self.write(model, &spec, engine.as_ref(), (&trajectory, Some(&reason)))?;
                Err(match is_interrupted() {
                    true => CommandError::Interrupted(reason),
                    false => CommandError::Failed(reason),
                })
            }
            Err(failure) => Err(failure.into()),
        }
    }

    fn path(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| format!("{}.html", self.model).into())
    }

    /// The engine of the sliders, if there are any.
    fn engine(&self) -> Result<Option<Packed>, CommandError> {
        match is_picture(&self.path()) && self.sliders.asked() {
            true => Err(CommandError::Usage("`--sliders` applies to a page, not to a picture".to_owned())),
            false => self.sliders.engine(),
        }
    }

    fn check_pace(&self) -> Result<(), CommandError> {
        match self.slower {
            Some(slower) if !(slower > 0.0 && slower.is_finite()) => {
                Err(CommandError::Usage(format!("`--slower {slower}`: a number above 0 is needed")))
            }
            Some(_) if !is_picture(&self.path()) => Err(CommandError::Usage(
                "`--slower` is for a picture, `--out FILE.svg`: a page is slowed while it plays".into(),
            )),
            _ => Ok(()),
        }
    }

    fn write(
        &self,
        model: &Entry,
        spec: &RunSpec,
        engine: Option<&Packed>,
        (record, stopped): (&Trajectory, Option<&str>),
    ) -> Result<(), CommandError> {
        let about = About {
            title: model.name(),
            summary: model.summary(),
            parameters: &spec.parameters,
            outputs: &self.output,
            stopped,
        };
        let path = self.path();
        let mut size = String::new();
        match engine {
            Some(engine) => {
                let page = live::page(model, spec, record, &about, Engine::Within(engine))?;
                let [all, own] = [page.len(), engine.size()].map(|bytes| bytes as f64 / 1e6);
                size = format!(", {all:.1} MB, {own:.1} MB of it the engine");
                write(&path, page)?;
            }
            None if is_picture(&path) => {
                write_picture(&path, &animation::moving_picture(record, &about, self.slower)?)?;
            }
            None => write(&path, animation::page(record, &about)?)?,
        }
        print_beside(Some(&path), &format!("{}{size}\n", path.display()))?;
        match self.open {
            true => open::that_detached(&path)
                .map_err(|error| CommandError::Failed(format!("cannot open {}: {error}", path.display()))),
            false => Ok(()),
        }
    }
}

fn is_picture(path: &Path) -> bool {
    Form::find(path, &[Form::SVG]).is_some()
}
