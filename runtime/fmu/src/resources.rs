//! What the library reads in the unpacked unit: the declaration as Rust, and what a run of it
//! begins with as TOML.

use crate::error::FmuError;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::source;
use sha2::{Digest, Sha256};
use std::path::Path;

pub(crate) const DECLARATION: &str = "model.rs";
pub(crate) const RUN: &str = "run.toml";

/// A model as a unit carries it.
#[derive(Debug, Clone, PartialEq)]
pub struct Resources {
    /// The declaration that the equations are derived from.
    pub declaration: String,
    /// What a run begins with where importers set nothing: no condition ends it.
    pub spec: RunSpec,
}

impl Resources {
    /// Those of a model with its default values.
    pub fn from_model(model: &Entry) -> Self {
        let declaration = format!("#[derive(BarSystem)]\n{}", model.layout().declaration);
        let spec = RunSpec { until: Vec::new(), stop_at_impacts: false, limit: None, ..model.default_run() };
        Self { declaration, spec }
    }

    /// Reads them in a folder.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn load(folder: &Path) -> Result<Self, FmuError> {
        let text = |name: &str| {
            let path = folder.join(name);
            std::fs::read_to_string(&path).map_err(|error| resource(&path, &error))
        };
        let spec = toml::from_str(&text(RUN)?);
        let spec = spec.map_err(|error| resource(&folder.join(RUN), &error))?;
        Ok(Self { declaration: text(DECLARATION)?, spec })
    }

    /// The model, interpreted.
    ///
    /// # Errors
    /// The declaration has mistakes, as none has that was written by this version.
    pub fn model(&self) -> Result<Entry, FmuError> {
        let mistaken = |text: String| FmuError::Model(format!("{DECLARATION}: {text}"));
        let models = source::models(&self.declaration).map_err(|mistakes| {
            mistaken(mistakes.into_iter().map(|mistake| mistake.text).collect::<Vec<_>>().join("; "))
        })?;
        let first = Models::new(models).iter().next().cloned();
        first.ok_or_else(|| mistaken("nothing derives BarSystem".to_owned()))
    }

    /// The text of the run.
    pub(crate) fn run(&self) -> Result<String, FmuError> {
        toml::to_string(&self.spec).map_err(|error| FmuError::Model(error.to_string()))
    }

    /// What the description and the library must agree on: a hash of the version, the declaration
    /// and the run.
    ///
    /// # Errors
    /// A value of the run is no number.
    pub fn token(&self) -> Result<String, FmuError> {
        let mut hash = Sha256::new();
        for part in [env!("CARGO_PKG_VERSION"), &self.declaration, &self.run()?] {
            hash.update(part.len().to_le_bytes());
            hash.update(part);
        }
        Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
    }
}

fn resource(path: &Path, error: &dyn std::error::Error) -> FmuError {
    FmuError::Resource { path: path.to_owned(), reason: error.to_string() }
}
