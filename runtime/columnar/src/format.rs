//! Which formats there are.

use std::error::Error;
use std::fmt;

/// A format of files.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Apache Parquet.
    Parquet,
    /// Apache Arrow's IPC file, also known as Feather of version 2.
    Arrow,
    /// NumPy's NPZ.
    Npz,
}

impl Format {
    /// Refuses a format that this build does not have.
    ///
    /// # Errors
    /// It was built without the feature of the format.
    pub fn check(self) -> Result<(), NotBuilt> {
        match self {
            Self::Parquet | Self::Arrow if cfg!(feature = "parquet") => Ok(()),
            Self::Npz if cfg!(feature = "npz") => Ok(()),
            missing => Err(NotBuilt(missing)),
        }
    }

    /// The feature that has it.
    fn feature(self) -> &'static str {
        match self {
            Self::Parquet | Self::Arrow => "parquet",
            Self::Npz => "npz",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Parquet => "Parquet",
            Self::Arrow => "Arrow",
            Self::Npz => "NPZ",
        })
    }
}

/// A format that this build does not have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NotBuilt(pub(crate) Format);

impl fmt::Display for NotBuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(format) = self;
        write!(f, "this program is built without {format}: build it with --features {}", format.feature())
    }
}

impl Error for NotBuilt {}
