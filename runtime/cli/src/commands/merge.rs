//! `liftoff merge`.

use crate::CommandError;
use crate::options::columnar_files::ColumnarFiles;
use crate::output::file::{Form, is_output, print_beside, probe_as, tell_written};
use clap::Args;
use liftoff_studio::sweep::merge;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub struct Merge {
    /// Files of shards, or folders of them
    #[arg(value_name = "FOLDER|FILE", required = true)]
    shards: Vec<PathBuf>,
    /// Write all members to a file, as a sweep in one process would; `-` is the standard output;
    /// without files the shards are only checked
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    #[command(flatten)]
    columnar: ColumnarFiles,
}

impl Merge {
    /// Checks that all shards of one sweep are there and whole, and writes its table.
    pub fn execute(self) -> Result<(), CommandError> {
        self.csv.iter().try_for_each(|path| probe_as(path, &[Form::CSV]))?;
        self.columnar.check()?;
        let merged = merge(&self.shards)?;
        if let Some(path) = &self.csv {
            merged.write_csv(path)?;
            tell_written(path);
        }
        for (_, format, path) in self.columnar.each() {
            merged.write_columnar(format, path)?;
            tell_written(path);
        }
        let mut paths =
            self.csv.iter().map(PathBuf::as_path).chain(self.columnar.each().map(|(.., path)| path));
        let output: Option<&Path> = paths.find(|path| is_output(path));
        print_beside(output, &merged.summary())
    }
}
