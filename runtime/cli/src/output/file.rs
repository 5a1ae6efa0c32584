//! Files, whole or not at all.

use crate::CommandError;
use crate::output::print::{print, tell};
use liftoff_studio::file;
use liftoff_studio::plot::with_theme;
use std::path::Path;

/// Forms of pictures that are not drawn here.
const OTHER_FORMS: [&str; 12] =
    ["png", "jpg", "jpeg", "gif", "webp", "bmp", "tif", "tiff", "pdf", "eps", "ps", "html"];

/// Bytes of a picture that no viewer shows in reasonable time.
const LARGEST: usize = 64 << 20;

/// Writes a file.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), CommandError> {
    file::write(path, content).map_err(|error| unwritable(path, &error))
}

/// Whether this is the standard output.
pub fn is_output(path: &Path) -> bool {
    path == Path::new("-")
}

/// Prints what goes with a file; where that is the standard output, on the standard error output.
pub fn print_beside(path: Option<&Path>, text: &str) -> Result<(), CommandError> {
    match path.is_some_and(is_output) {
        true => tell(text.trim_end()),
        false => print(text)?,
    }
    Ok(())
}

/// Tells where to find a file that has been written.
pub fn tell_written(path: &Path) {
    if !is_output(path) && !path.starts_with("/dev") {
        tell(&format!("{} written", path.display()));
    }
}

/// Refuses names of pictures that are no SVG, and files that cannot be written.
pub fn probe_picture(path: &Path) -> Result<(), CommandError> {
    let form = path.extension().map(|form| form.to_string_lossy().to_lowercase());
    match form.filter(|form| OTHER_FORMS.contains(&form.as_str())) {
        Some(form) => Err(CommandError::Usage(format!(
            "{}: pictures are written as SVG, not as {}; name the file {}, which browsers show and Inkscape or \
             rsvg-convert turn into others",
            path.display(),
            form.to_uppercase(),
            path.with_extension("svg").display(),
        ))),
        None => probe(path),
    }
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
    fn other_forms_than_svg_are_refused() {
        let told = probe_picture(Path::new("a/b.PNG")).unwrap_err();
        assert_eq!(told.code(), 2);
        assert!(told.to_string().contains("not as PNG; name the file a/b.svg, "), "{told}");
        for allowed in ["b.svg", "b", "/dev/null", "-"] {
            probe_picture(&std::env::temp_dir().join(allowed)).unwrap();
        }
    }

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
