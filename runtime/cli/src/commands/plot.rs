//! `liftoff plot`.

use crate::CommandError;
use crate::options::run_args::{RunArgs, checked};
use crate::options::values::{Assignment, assignment, whole};
use crate::output::file::{Form, print_beside, probe_as, write_picture};
use clap::{Args, ValueEnum};
use liftoff::Trajectory;
use liftoff_studio::picture::{Charts, Portrait, Positions, clearest_pose, drawing};
use liftoff_studio::registry::{Entry, Models, Place, as_far};
use liftoff_studio::run_spec::{RunSpec, overridden};
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Plot {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// Outputs to draw against time; by default coordinates, reactions and energies. In portraits:
    /// the coordinates
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// Output on the horizontal axis instead of time
    #[arg(long, value_name = "EXPR")]
    against: Option<String>,
    /// Kind of picture; by default the one that the other options imply, else a chart
    #[arg(long, value_enum)]
    picture: Option<Picture>,
    /// A point whose path is drawn
    #[arg(long, value_name = "POINT")]
    trail: Vec<String>,
    /// Number of superposed positions
    #[arg(long, value_name = "N", value_parser = whole(1..=1000))]
    positions: Option<usize>,
    /// The start of another motion in a portrait, `phi=0.2,phi'=1`
    #[arg(long, value_name = "NAME=VALUE,…", value_parser = start)]
    also: Vec<Start>,
    /// The file to write [default: MODEL.svg]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Width in pixels; chosen if not given
    #[arg(long, value_name = "PIXELS", value_parser = whole(240..=10_000))]
    width: Option<usize>,
    /// Height in pixels; chosen if not given
    #[arg(long, value_name = "PIXELS", value_parser = whole(160..=20_000))]
    height: Option<usize>,
}

/// Kinds of pictures.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
enum Picture {
    /// Outputs against time or another output
    Chart,
    /// The model in its pose
    Drawing,
    /// Superposed positions
    Pattern,
    /// Rates against coordinates
    Portrait,
}

/// Start of a further motion.
#[derive(Clone, Debug)]
struct Start {
    text: String,
    values: Vec<Assignment>,
}

fn start(text: &str) -> Result<Start, String> {
    let values: Result<_, String> = text.split(',').map(assignment).collect();
    Ok(Start { text: text.to_owned(), values: values? })
}

/// A picture, and why the motion that it shows stopped short.
struct Drawn {
    svg: String,
    reason: Option<String>,
}

impl Plot {
    /// Writes the picture; of a run that stopped short as far as it came.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let path = self.out.clone().unwrap_or_else(|| format!("{}.svg", model.name()).into());
        probe_as(&path, &[Form::SVG])?;
        let spec = self.run_args.spec(model)?;
        let drawn = match self.kind() {
            Picture::Drawing => {
                let configuration = if self.run_args.has_start() {
                    model.configuration(&spec)?
                } else {
                    clearest_pose(model, &spec)?
                };
                Drawn { svg: drawing(&configuration), reason: None }
            }
            kind => self.motion(kind, model, &spec)?,
        };
        write_picture(&path, &drawn.svg)?;
        print_beside(Some(&path), &format!("{}\n", path.display()))?;
        drawn.reason.map_or(Ok(()), |reason| Err(CommandError::Failed(reason)))
    }

    fn kind(&self) -> Picture {
        let inferred = || {
            if !self.also.is_empty() {
                Picture::Portrait
            } else if !self.trail.is_empty() || self.positions.is_some() {
                Picture::Pattern
            } else {
                Picture::Chart
            }
        };
        self.picture.unwrap_or_else(inferred)
    }

    /// Width and height, within their ranges.
    fn size(&self) -> (Option<u32>, Option<u32>) {
        let pixels = |given: Option<usize>| given.and_then(|pixels| pixels.try_into().ok());
        (pixels(self.width), pixels(self.height))
    }

    fn motion(&self, kind: Picture, model: &Entry, spec: &RunSpec) -> Result<Drawn, CommandError> {
        let (record, reason) = run(model, spec)?;
        let size = self.size();
        let svg = match kind {
            Picture::Pattern => {
                let positions = Positions::new(&record).trails(&self.trail).size(size.0, size.1);
                self.positions.into_iter().fold(positions, Positions::count).svg()?
            }
            Picture::Portrait => return self.portrait(model, spec, (&record, reason)),
            _ => {
                let charts = Charts::new(&record).outputs(&self.output).size(size.0, size.1);
                self.against.iter().fold(charts, |charts, output| charts.against(output)).svg()?
            }
        };
        Ok(Drawn { svg, reason })
    }

    fn portrait(
        &self,
        model: &Entry,
        spec: &RunSpec,
        (record, mut reason): (&Trajectory, Option<String>),
    ) -> Result<Drawn, CommandError> {
        let mut others = Vec::new();
        for also in &self.also {
            let values = checked(model, Place::Start, &also.values)?;
            let start = overridden(spec.start.clone(), &values);
            let (record, stopped) = run(model, &RunSpec { start, energy_of: Vec::new(), ..spec.clone() })?;
            reason = reason.or(stopped);
            others.push((also.text.as_str(), record));
        }
        let first: Vec<String> =
            spec.start.iter().map(|(name, value)| format!("{name} = {value:.4}")).collect();
        let portrait = Portrait::new(&first.join(", "), record).size(self.size().0, self.size().1);
        let portrait = if self.output.is_empty() { portrait } else { portrait.coordinates(&self.output) };
        let portrait = others.iter().fold(portrait, |portrait, (name, record)| portrait.and(name, record));
        Ok(Drawn { svg: portrait.svg()?, reason })
    }
}

/// A motion, and why it stopped short if it did.
fn run(model: &Entry, spec: &RunSpec) -> Result<(Trajectory, Option<String>), CommandError> {
    Ok(as_far(model.run(spec))?)
}
