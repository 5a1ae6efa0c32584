//! The archive of a unit.

use crate::description::{Head, description};
use crate::error::FmuError;
use crate::interface::Interface;
use crate::platform::{LIBRARY, binary, platform};
use crate::resources::{DECLARATION, RUN, Resources};
use liftoff_studio::file;
use liftoff_studio::registry::{Entry, RunOptions};
use std::io::{Cursor, Write};
use std::path::Path;
use zip::ZipWriter;
use zip::result::ZipResult;
use zip::write::SimpleFileOptions;

/// A unit of a model, with the shared library at a path: the bytes of the archive.
///
/// # Errors
/// A parameter has no value, the default values make no start, or the library is not there or is
/// another.
pub fn write(model: &Entry, library: &Path) -> Result<Vec<u8>, FmuError> {
    let library = read_library(library)?;
    let resources = Resources::from_model(model);
    let interface = Interface::from_model(model, &resources.spec)?;
    let identifier = identifier(model.name());
    let token = resources.token()?;
    let head = Head {
        name: model.layout().name,
        identifier: &identifier,
        token: &token,
        summary: model.summary(),
        stop: stop(model),
    };
    let other = |error: &dyn std::error::Error| FmuError::Model(error.to_string());
    let files = [
        (
            "modelDescription.xml".to_owned(),
            description(&head, &interface).map_err(|error| other(&error))?.into_bytes(),
        ),
        (format!("resources/{DECLARATION}"), resources.declaration.clone().into_bytes()),
        (format!("resources/{RUN}"), resources.run()?.into_bytes()),
        (format!("binaries/{}/{}", platform(), binary(&identifier)), library),
    ];
    archive(&files).map_err(|error| other(&error))
}

/// The library, if it is one of this version.
fn read_library(path: &Path) -> Result<Vec<u8>, FmuError> {
    if !path.exists() {
        return Err(FmuError::NoLibrary(path.to_owned()));
    }
    let bytes = file::read_file(path, u64::MAX)
        .map_err(|source| FmuError::Library { path: path.to_owned(), source })?;
    match bytes.windows(LIBRARY.len()).any(|part| part == LIBRARY.as_bytes()) {
        true => Ok(bytes),
        false => Err(FmuError::OtherLibrary { path: path.to_owned(), version: env!("CARGO_PKG_VERSION") }),
    }
}

/// A name in C.
fn identifier(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
}

/// When the default run ends, to three digits; none where it does not come to its end.
fn stop(model: &Entry) -> Option<f64> {
    let run = model.observe_by(RunOptions::default(), &model.default_run(), &mut ()).ok()?;
    format!("{:.2e}", run.end_time()).parse().ok().filter(|end| *end > 0.0)
}

fn archive(files: &[(String, Vec<u8>)]) -> ZipResult<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        zip.start_file(name.as_str(), SimpleFileOptions::default())?;
        zip.write_all(bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}
