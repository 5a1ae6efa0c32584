//! Why there is no unit of a model.

use std::path::PathBuf;

use thiserror::Error;

/// Why there is no unit of a model.
#[derive(Debug, Error)]
pub enum FmuError {
    /// A parameter has no value that importers could start from.
    #[error("parameter `{0}` has no value to begin with: declare one, #[value(…)]")]
    Parameter(String),
    /// The model cannot be begun with its default values.
    #[error("{0}")]
    Model(String),
    /// The shared library is not there.
    #[error("there is no `{}`: build it, cargo build --release -p liftoff-fmu-library, or name it, --library FILE", .0.display())]
    NoLibrary(PathBuf),
    /// The shared library cannot be read.
    #[error("cannot read `{}`: {source}", path.display())]
    Library {
        /// Where it lies.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file is no such library, or one of another version.
    #[error("`{}` is not the library of functional mock-up units of liftoff {version}", path.display())]
    OtherLibrary {
        /// Where it lies.
        path: PathBuf,
        /// The version that is asked for.
        version: &'static str,
    },
    /// Resources of a unit that cannot be read.
    #[error("cannot read the unit's resource `{}`: {reason}", path.display())]
    Resource {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}
