//! Options of a sweep.

use crate::CommandError;
use crate::options::columnar_files::ColumnarFiles;
use crate::options::run_args::{EventArgs, given, likely_degrees};
use crate::options::values::{assignment, whole, width};
use crate::output::file::{Form, is_output, probe_as};
use clap::Args;
use liftoff_studio::registry::Entry;
use liftoff_studio::sweep::{MOST_MEMBERS, MOST_SHARDS, MOST_THREADS, Sample, Shard};
use std::path::{Path, PathBuf};

/// How narrow the interval of a threshold becomes.
const WIDTH: f64 = 1e-10;

#[derive(Args, Clone, Default, Debug)]
pub struct Options {
    /// A parameter, a coordinate or rate at the start, or a name for use in expressions; `LOW:HIGH`
    /// for samples, `…:log` for equal ratios, `NAME=X,Y,…` for these values
    #[arg(long, value_name = "NAME=LOW:HIGH:COUNT")]
    pub vary: Vec<String>,
    /// A parameter, as an expression of the varied names
    #[arg(long, value_name = "NAME=EXPR")]
    pub set: Vec<String>,
    /// A coordinate or rate (`phi'`) at the start, as an expression of the varied names; replaces the default start
    #[arg(long, value_name = "NAME=EXPR")]
    pub start: Vec<String>,
    /// A coordinate of a pose: start with the energy of this pose at rest
    #[arg(long, value_name = "NAME=EXPR")]
    pub energy_of: Vec<String>,
    /// Outputs to observe: `first open`, `first open EXPR`, `2nd impact`, `t of last impact A`,
    /// `count impact`, `max EXPR`, `end EXPR`, `end`
    #[arg(long, value_name = "WHAT")]
    pub observe: Vec<String>,
    /// Number of random points
    #[arg(long, value_name = "N", conflicts_with = "sobol", value_parser = whole(1..=MOST_MEMBERS))]
    pub random: Option<usize>,
    /// Number of Sobol points
    #[arg(long, value_name = "N", value_parser = whole(1..=MOST_MEMBERS))]
    pub sobol: Option<usize>,
    /// Seed of random points [default: 0], or of the shift of Sobol points [default: unshifted]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Locate where an observed result changes: `first open`, or a number that reaches a value,
    /// `first open phi = 0.4`
    #[arg(long, value_name = "NAME=LOW:HIGH[:COUNT]", conflicts_with_all = ["vary", "random", "sobol", "csv", "parquet", "arrow", "npz", "svg", "journal"])]
    pub bisect: Option<String>,
    /// Width to which changes are located [default: 1e-10]
    #[arg(long, value_name = "WIDTH", requires = "bisect", value_parser = width, allow_negative_numbers = true)]
    pub to: Option<f64>,
    #[command(flatten)]
    pub events: EventArgs,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = whole(1..=MOST_THREADS))]
    pub threads: Option<usize>,
    /// Write all members to a file, `-` is the standard output; until all are done they are kept in FILE.journal, from
    /// which the same command resumes
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Alone, files of columns are written from FILE.parts, a folder that keeps what is done until all is, in memory of 12 bytes
    /// a member
    #[command(flatten)]
    pub columnar: ColumnarFiles,
    /// Draw curves over one varied name, a map over two
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
    /// Where to keep what is done, and to leave it for larger samples [default: FILE.journal beside the file of --csv,
    /// until all is done]
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    /// Compute everything again and ignore the journal or the files of the shard
    #[arg(long)]
    pub fresh: bool,
    /// Compute a part of the members and keep it in this folder, i-of-n.shard; the same command goes on where it was, `merge`
    /// makes all parts one table
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Part i of n: every n-th member from the i-th on, 0/n to (n-1)/n [default: from the task of a
    /// Slurm array, by SLURM_ARRAY_TASK_ID, _MIN and _COUNT]
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Write a script for `sbatch` that computes all parts as an array of tasks, instead of computing anything
    #[arg(long, value_name = "FILE", conflicts_with_all = ["shard", "fresh"])]
    pub sbatch: Option<PathBuf>,
    /// Number of tasks of the script [default: 16]
    #[arg(long, value_name = "N", requires = "sbatch", value_parser = whole(1..=MOST_SHARDS))]
    pub shards: Option<usize>,
}

impl Options {
    pub fn bisects(&self) -> bool {
        self.bisect.is_some()
    }

    pub fn width(&self) -> f64 {
        self.to.unwrap_or(WIDTH)
    }

    /// The texts of what is varied.
    pub fn varied(&self) -> Result<impl Iterator<Item = &str>, CommandError> {
        if self.bisect.is_some() && !self.vary.is_empty() {
            return Err(CommandError::Usage(
                "--bisect already varies its name; do not vary anything else".into(),
            ));
        }
        Ok(self.vary.iter().chain(&self.bisect).map(String::as_str))
    }

    pub fn sample(&self) -> Result<Sample, CommandError> {
        match (self.random, self.sobol) {
            (Some(_), Some(_)) => {
                Err(CommandError::Usage("use either random or Sobol points, not both".into()))
            }
            (Some(count), None) => Ok(Sample::Random { count, seed: self.seed.unwrap_or(0) }),
            (None, Some(count)) => Ok(Sample::Sobol { count, seed: self.seed }),
            (None, None) if self.seed.is_some() => {
                Err(CommandError::Usage("a seed needs --random or --sobol".into()))
            }
            (None, None) => Ok(Sample::Grid),
        }
    }

    /// The journal that is asked for, or that belongs to the table.
    pub fn journal(&self) -> Option<PathBuf> {
        // Beside a device nothing is kept.
        let is_table =
            |path: &&PathBuf| !is_output(path) && std::fs::metadata(path).map_or(true, |what| what.is_file());
        self.journal
            .clone()
            .or_else(|| self.csv.as_ref().filter(is_table).map(|path| beside(path, ".journal")))
    }

    /// The folder in which a sweep keeps what is done whose members are not needed in memory: beside the first columnar file,
    /// where no other file of the whole is asked for.
    pub fn parts(&self) -> Option<PathBuf> {
        let (.., path) = self.columnar.each().next()?;
        let is_kept = self.csv.is_some() || self.svg.is_some() || self.journal.is_some();
        let is_file = !is_output(path) && std::fs::metadata(path).map_or(true, |what| what.is_file());
        (!is_kept && is_file).then(|| beside(path, ".parts"))
    }

    /// What to say of angles that look like degrees.
    pub fn notes(&self, model: &Entry) -> Vec<String> {
        let varied = self.vary.iter().chain(&self.bisect).filter_map(|text| text.split_once('='));
        // The ends of a range, or the values.
        let values = varied.flat_map(|(name, values)| {
            let ends = if values.contains(':') { 2 } else { usize::MAX };
            values.split([':', ',']).take(ends).map(move |value| format!("{name}={value}"))
        });
        let given = self.start.iter().chain(&self.energy_of).cloned().chain(values);
        let mut notes: Vec<String> =
            given.filter_map(|text| likely_degrees(model, &assignment(&text).ok()?)).collect();
        notes.truncate(1);
        notes
    }

    /// Refuses files that cannot be written before anything is computed for them.
    pub fn check_files(&self) -> Result<(), CommandError> {
        self.csv.iter().try_for_each(|path| probe_as(path, &[Form::CSV]))?;
        self.columnar.check()?;
        self.svg.iter().try_for_each(|path| probe_as(path, &[Form::SVG]))
    }

    /// These, and where none is given those of a file.
    pub fn over(self, file: Self) -> Self {
        Self {
            vary: given(&self.vary, file.vary),
            set: given(&self.set, file.set),
            start: given(&self.start, file.start),
            energy_of: given(&self.energy_of, file.energy_of),
            observe: given(&self.observe, file.observe),
            random: self.random.or(file.random),
            sobol: self.sobol.or(file.sobol),
            seed: self.seed.or(file.seed),
            bisect: self.bisect.or(file.bisect),
            to: self.to.or(file.to),
            events: self.events.over(file.events),
            threads: self.threads.or(file.threads),
            csv: self.csv.or(file.csv),
            columnar: self.columnar.over(file.columnar),
            svg: self.svg.or(file.svg),
            journal: self.journal.or(file.journal),
            fresh: self.fresh || file.fresh,
            out: self.out.or(file.out),
            // A script of the file's is written by hand, and its tasks are not to write it again.
            sbatch: self.sbatch.or(file.sbatch).filter(|_| self.shard.is_none()),
            shard: self.shard.or(file.shard),
            shards: self.shards.or(file.shards),
        }
    }

    /// The same with paths as seen from another folder.
    pub fn within(mut self, folder: &Path) -> Self {
        let paths = [&mut self.csv, &mut self.svg, &mut self.journal, &mut self.out, &mut self.sbatch];
        for path in paths.into_iter().flatten().chain(self.columnar.paths_mut()) {
            *path = folder.join(&*path);
        }
        self
    }
}

/// A path whose name goes on with this.
fn beside(path: &Path, end: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(end);
    PathBuf::from(name)
}
