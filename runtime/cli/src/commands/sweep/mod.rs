//! `liftoff sweep`.

mod file;
pub mod options;
mod sbatch;
mod shard;

use crate::CommandError;
use crate::errors::interrupted::{interrupted, is_interrupted};
use crate::output::file::{is_output, print_beside, tell_written, write_picture};
use crate::output::notes::note;
use crate::output::print::print;
use crate::output::progress::Progress;
use clap::Args;
use liftoff_processes::{Processes, joined};
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::sweep::{
    Leader, SHOWN, Shard, Share, Sweep as Builder, SweepError, Table, Threshold, merge, refuse,
};
use options::Options;
use std::fs::{remove_dir, remove_file};
use std::path::{Path, PathBuf};
use std::slice;

#[derive(Args, Debug)]
pub struct Sweep {
    /// Name of the model, as in `list`; or a Rust file, `FILE.rs`; or a TOML file with the model
    /// and the options by name
    #[arg(value_name = "MODEL|FILE.rs|FILE.toml")]
    what: String,
    #[command(flatten)]
    options: Options,
}

impl From<SweepError> for CommandError {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Interrupted => Self::Interrupted(error.to_string()),
            _ if error.is_mistake() => Self::Usage(error.to_string()),
            _ => Self::Failed(error.to_string()),
        }
    }
}

impl Sweep {
    /// The model, unless a file tells it.
    pub fn model(&mut self) -> Option<&mut String> {
        Some(&mut self.what).filter(|what| !what.ends_with(".toml"))
    }

    /// Runs the members, or those that a journal does not have, and prints a summary; what was done before Ctrl-C
    /// is kept. Processes that were started together share the members, and the first has all files and prints.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let processes = joined().map_err(|error| CommandError::Usage(error.to_string()))?;
        match processes.as_deref() {
            Some(processes) if processes.rank() > 0 => {
                self.work(models, processes);
                Ok(())
            }
            Some(processes) => self.lead(models, Some((processes, &Leader::new(processes)))),
            None => self.lead(models, None),
        }
    }

    /// What is to be done, on as many threads as a process of several may have where no number is given.
    fn resolve(self, processes: Option<&dyn Processes>) -> Result<(String, Options), CommandError> {
        let (what, mut options) = match self.what.ends_with(".toml") {
            true => file::load(Path::new(&self.what), self.options)?,
            false => (self.what, self.options),
        };
        options.threads = options.threads.or(processes.map(Processes::threads));
        Ok((what, options))
    }

    /// Computes what the first process sends, which is told what is wrong.
    fn work(self, models: &Models, processes: &dyn Processes) {
        let made =
            self.resolve(Some(processes)).and_then(|(name, options)| Ok((models.find(&name)?, options)));
        let sweep = made
            .as_ref()
            .map_err(ToString::to_string)
            .and_then(|(model, options)| options.sweep(model).map_err(|error| error.to_string()));
        match sweep {
            // It has told.
            Ok(sweep) => drop(sweep.cancel(interrupted()).work(processes)),
            Err(reason) => refuse(processes, &reason),
        }
    }

    fn lead(self, models: &Models, team: Option<(&dyn Processes, &Leader<'_>)>) -> Result<(), CommandError> {
        let (name, options) = self.resolve(team.map(|(processes, _)| processes))?;
        let model = models.find(&name)?;
        let folder = options.folder()?;
        options.notes(model).iter().for_each(|text| note(text));
        if let (Some(path), Some(folder)) = (&options.sbatch, folder) {
            let members = options.sweep(model)?.members()?;
            return options.write_sbatch(path, (model.name(), members), folder);
        }
        let progress = Progress::new(0, "members");
        let on_progress = |done: usize, total: usize| {
            progress.extend(total);
            progress.reach(done);
        };
        let sweep = options.sweep(model)?.cancel(interrupted()).progress(&on_progress);
        let sweep = match team {
            Some((_, leader)) => sweep.team(leader),
            None => sweep,
        };
        if options.bisects() {
            let found = sweep.thresholds(options.width())?;
            drop(progress);
            return options.thresholds(model, &found);
        }
        if let Some(folder) = folder {
            let share = sweep.run_shard(options.shard(&shard::environment)?, folder)?;
            drop(progress);
            return shard::tell(&share);
        }
        options.note_array(&shard::environment);
        options.check_files()?;
        if options.columnar.each().next().is_some() {
            sweep.check_columns()?;
        }
        if let Some(parts) = options.parts() {
            let share = sweep.run_shard(Shard::new(0, 1).map_err(CommandError::Usage)?, &parts)?;
            drop(progress);
            return options.write_parts(&share, parts);
        }
        let table = sweep.run()?;
        drop(progress);
        options.print_summary(&table)
    }
}

impl Options {
    /// The sweep that the options describe.
    pub fn sweep<'a>(&self, model: &'a Entry) -> Result<Builder<'a>, CommandError> {
        let mut spec = self.events.spec(model.default_run());
        if self.events.released_later().next().is_some() && !self.events.releases_at_times() {
            spec.release.clear();
        }
        if !self.start.is_empty() {
            spec.start.clear();
        }
        if !self.start.is_empty() || !self.energy_of.is_empty() {
            spec.energy_of.clear();
        }
        let mut sweep = Builder::new(model).spec(spec).sample(self.sample()?);
        for text in self.varied()? {
            sweep = sweep.vary(text)?;
        }
        for text in &self.set {
            sweep = sweep.set(text)?;
        }
        for text in &self.start {
            sweep = sweep.start(text)?;
        }
        for text in &self.energy_of {
            sweep = sweep.energy_of(text)?;
        }
        for text in self.events.released_later() {
            sweep = sweep.release(&text)?;
        }
        for text in &self.observe {
            sweep = sweep.observe(text)?;
        }
        if let Some(threads) = self.threads {
            sweep = sweep.threads(threads);
        }
        if let Some(path) = self.journal() {
            sweep = sweep.journal(path);
        }
        Ok(if self.fresh { sweep.fresh() } else { sweep })
    }

    fn print_summary(&self, table: &Table) -> Result<(), CommandError> {
        if table.is_whole() {
            self.write_tables(table)?;
        }
        let mut drawn = Ok(());
        if let Some(path) = self.svg.as_ref().filter(|_| !table.rows.is_empty()) {
            drawn = draw(table, path);
        }
        let pictures = self.svg.iter().map(PathBuf::as_path);
        print_beside(self.tables().chain(pictures).find(|path| is_output(path)), &table.summary())?;
        drawn?;
        if self.tables().next().is_none() && table.rows.len() > SHOWN {
            note("a table of all members is written by --csv FILE");
        }
        match (table.is_whole(), self.journal()) {
            (true, _) if !table.rows.is_empty() && table.failed().count() == table.rows.len() => {
                Err(CommandError::Failed("every member has failed".to_owned()))
            }
            (true, _) => Ok(()),
            (false, Some(path)) => Err(CommandError::Interrupted(format!(
                "interrupted; the same command resumes from {}",
                path.display()
            ))),
            (false, None) => Err(CommandError::Interrupted(
                "interrupted; --csv would have kept the finished members".into(),
            )),
        }
    }

    /// Writes the table of a finished sweep, which then needs no journal.
    fn write_tables(&self, table: &Table) -> Result<(), CommandError> {
        self.csv.iter().try_for_each(|path| table.write_csv(path))?;
        self.columnar.each().try_for_each(|(_, format, path)| table.write_columnar(format, path))?;
        self.tables().for_each(tell_written);
        self.drop_journal();
        Ok(())
    }

    /// The files of the table that are asked for.
    fn tables(&self) -> impl Iterator<Item = &Path> {
        self.csv.iter().map(PathBuf::as_path).chain(self.columnar.each().map(|(.., path)| path))
    }

    /// Writes the columnar files from the folder that has the members, and removes it.
    fn write_parts(&self, share: &Share, parts: PathBuf) -> Result<(), CommandError> {
        if !share.is_whole() {
            return shard::tell(share);
        }
        let merged = merge(slice::from_ref(&parts))?;
        for (_, format, path) in self.columnar.each() {
            merged.write_columnar(format, path)?;
            tell_written(path);
        }
        let output = self.tables().find(|path| is_output(path));
        print_beside(output, &merged.summary())?;
        // What else is in it stays.
        let _ = remove_file(&share.file).and_then(|()| remove_dir(parts));
        Ok(())
    }

    /// Of a finished sweep the table has all that the journal has, unless that was asked for.
    fn drop_journal(&self) {
        if self.journal.is_none() {
            self.journal().map(std::fs::remove_file);
        }
    }

    fn thresholds(&self, model: &Entry, found: &[Threshold]) -> Result<(), CommandError> {
        let observed = self.observe.join(", ");
        let name = self.bisect.as_deref().and_then(|text| text.split_once('=')).map_or("", |(name, _)| name);
        let mut text = format!("{}: changes of `{observed}` along {name}: {}\n", model.name(), found.len());
        for Threshold { below, above, before, after } in found {
            text += &format!("  {name} = {below} … {above}  {before} | {after}\n");
        }
        print(&text)?;
        if is_interrupted() {
            return Err(CommandError::Interrupted(
                "interrupted; the intervals are those found so far".into(),
            ));
        }
        Ok(())
    }
}

fn draw(table: &Table, path: &Path) -> Result<(), CommandError> {
    write_picture(path, &table.svg()?)?;
    tell_written(path);
    Ok(())
}
