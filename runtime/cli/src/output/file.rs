//! Files, whole or not at all.

use crate::CommandError;
use liftoff_studio::file;
use liftoff_studio::plot::with_theme;
use std::path::Path;

/// Bytes of a picture that no viewer shows in reasonable time.
const LARGEST: usize = 64 << 20;

/// Writes a file.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), CommandError> {
    file::write(path, content).map_err(|error| unwritable(path, &error))
}

/// Writes an SVG on a card of its own; one that is too large to be shown is refused.
pub fn write_picture(path: &Path, svg: &str) -> Result<(), CommandError> {
    match svg.len() {
        0..=LARGEST => write(path, with_theme(svg)),
        size => Err(CommandError::Failed(format!(
            "{} would have {} MB, and {} are the most: draw a shorter run or less of it",
            path.display(),
            size >> 20,
            LARGEST >> 20,
        ))),
    }
}

/// Tries whether a file can be written, before anything is computed for it.
pub fn probe(path: &Path) -> Result<(), CommandError> {
    file::probe(path).map_err(|error| unwritable(path, &error))
}

/// What keeps a file from being written.
pub fn unwritable(path: &Path, error: &impl std::fmt::Display) -> CommandError {
    CommandError::Failed(format!("cannot write {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_nothing_shows_is_refused() {
        let path = Path::new("/nowhere/large.svg");
        let told = write_picture(path, &" ".repeat(LARGEST + (3 << 20))).unwrap_err().to_string();
        assert_eq!(
            told,
            "/nowhere/large.svg would have 67 MB, and 64 are the most: draw a shorter run or less of it"
        );
    }
}
