//! Columnar files with units, for other programs.

use crate::CommandError;
use crate::output::file::{Form, probe_as};
use clap::Args;
use liftoff_columnar::Format;
use std::path::{Path, PathBuf};

/// The form of a format, by the extension of its files.
fn form(format: Format) -> Form {
    match format {
        Format::Parquet => Form::PARQUET,
        Format::Arrow => Form::ARROW,
        Format::Npz => Form::NPZ,
    }
}

#[derive(Args, Clone, Default, Debug)]
pub struct ColumnarFiles {
    /// Write a Parquet file, columns with units (of programs built with feature `parquet`)
    #[arg(long, value_name = "FILE")]
    parquet: Option<PathBuf>,
    /// Write an Arrow IPC file (of programs built with feature `parquet`)
    #[arg(long, value_name = "FILE")]
    arrow: Option<PathBuf>,
    /// Write an archive of arrays for NumPy (of programs built with feature `npz`)
    #[arg(long, value_name = "FILE")]
    npz: Option<PathBuf>,
}

impl ColumnarFiles {
    /// The requested files, each with its option.
    pub fn each(&self) -> impl Iterator<Item = (&'static str, Format, &Path)> {
        let all = [
            ("--parquet", Format::Parquet, &self.parquet),
            ("--arrow", Format::Arrow, &self.arrow),
            ("--npz", Format::Npz, &self.npz),
        ];
        all.into_iter().filter_map(|(option, format, path)| Some((option, format, path.as_deref()?)))
    }

    /// Refuses formats that this program does not have, and files that cannot be written.
    pub fn check(&self) -> Result<(), CommandError> {
        self.each().try_for_each(|(option, format, path)| {
            format.check().map_err(|missing| CommandError::Usage(format!("{option}: {missing}")))?;
            probe_as(path, &[form(format)])
        })
    }

    /// These options; those missing come from `file`.
    pub fn over(self, file: Self) -> Self {
        Self {
            parquet: self.parquet.or(file.parquet),
            arrow: self.arrow.or(file.arrow),
            npz: self.npz.or(file.npz),
        }
    }

    /// The paths, to be made relative to another folder.
    pub fn paths_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        [&mut self.parquet, &mut self.arrow, &mut self.npz].into_iter().flatten()
    }
}
