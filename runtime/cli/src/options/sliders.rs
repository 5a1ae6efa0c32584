//! Pages that run their model again.

use crate::CommandError;
use clap::Args;
use liftoff_studio::animation::live::Packed;
use liftoff_studio::file::read_file;
use std::path::PathBuf;

/// Bytes of an engine or a page that has one.
const LARGEST: u64 = 64 << 20;

/// The engine of a page.
#[derive(Args, Debug)]
pub struct Sliders {
    /// Add sliders for parameters and start that run the model again within the page, by the engine of FILE: `liftoff_web.wasm`, or the
    /// page that `liftoff-web-bundle` makes
    #[arg(long, value_name = "FILE.wasm|FILE.html")]
    sliders: Option<PathBuf>,
}

impl Sliders {
    /// The engine, if sliders are asked for.
    pub fn engine(&self) -> Result<Option<Packed>, CommandError> {
        let Some(path) = &self.sliders else { return Ok(None) };
        let packed = read_file(path, LARGEST).and_then(|content| Packed::new(&content));
        packed
            .map(Some)
            .map_err(|error| CommandError::Usage(format!("`--sliders {}`: {error}", path.display())))
    }

    /// Whether they are.
    pub fn asked(&self) -> bool {
        self.sliders.is_some()
    }
}
