//! `liftoff merge`.

use crate::CommandError;
use crate::output::file::{print_beside, probe, tell_written};
use clap::Args;
use liftoff_studio::sweep::merge;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Merge {
    /// Files of shards, or folders of them
    #[arg(value_name = "FOLDER|FILE", required = true)]
    shards: Vec<PathBuf>,
    /// Write all members to a file, as the sweep in one process does; `-` is the standard output; otherwise the shards are
    /// only checked
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Merge {
    /// Checks that all shards of one sweep are there and whole, and writes its table.
    pub fn execute(self) -> Result<(), CommandError> {
        self.csv.iter().try_for_each(|path| probe(path))?;
        let merged = merge(&self.shards, self.csv.as_deref())?;
        self.csv.iter().for_each(|path| tell_written(path));
        print_beside(self.csv.as_deref(), &merged.summary())
    }
}
